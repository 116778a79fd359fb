#include "dataset/logs/cuts_file.h"

#include "base/toml_file.h"
#include "base/units.h"

namespace mixity {

std::map<std::string, StatedCut> read_cuts(const std::string& path) {
  std::map<std::string, StatedCut> cuts;
  for (const auto& [key, node] : read_toml(path)) {
    if (key != "cuts" || !node.is_array_of_tables()) fail_at(path, key, "holds tables [[cuts]] and nothing else");
    for (const toml::node& entry : *node.as_array()) {
      std::string name;
      StatedCut cut;
      cut.file = path;
      for (const auto& [item, value] : *entry.as_table()) {
        const auto time = [&, &item = item, &value = value]() -> double {
          const auto quantity = value.is_string() ? parse_quantity(value.as_string()->get()) : std::nullopt;
          if (!quantity || quantity->unit.dimension != dimension::time)
            fail_at(path, value, std::string(item.str()) + " must be a time such as \"4.31 s\"");
          return quantity->si();
        };
        const FilePlace place{value.source().begin.line, value.source().begin.column};
        if (item == "run" && value.is_string())
          name = value.as_string()->get();
        else if (item == "shear") {
          cut.shear = time();
          cut.shear_place = place;
        } else if (item == "onset") {
          cut.onset = time();
          cut.onset_place = place;
        } else if (item == "leave_out" && value.is_boolean())
          cut.leave_out = value.as_boolean()->get();
        else
          fail_at(
              path, item,
              "unknown key \"" + std::string(item.str()) +
                  "\" or a wrong kind of value (known: run, a text; shear and onset, times; leave_out, true or false)");
      }
      if (name.empty()) fail_at(path, entry, "a cut needs the name of its run: run = \"P=4.68 mN\"");
      if (cut.shear && cut.onset && !(*cut.onset > *cut.shear))
        fail_at(path, entry, "the onset is not later than the start of the shear");
      if (!cuts.emplace(name, cut).second) fail_at(path, entry, "a second cut of run '" + name + "'");
    }
  }
  return cuts;
}

}  // namespace mixity
