#include <cctype>
#include <filesystem>

#include "base/input_error.h"
#include "base/number_text.h"
#include "base/text.h"
#include "base/toml_file.h"
#include "dataset/metadata.h"

namespace mixity {
namespace {

std::filesystem::path without_ending(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  return ending.size() > 1 && std::isalpha(static_cast<unsigned char>(ending[1]))
             ? std::filesystem::path(path).replace_extension()
             : path;
}

}  // namespace

std::string metadata_path(const std::string& csv_path) { return without_ending(csv_path).string() + ".toml"; }

std::string data_name(const std::string& csv_path) {
  return printable(without_ending(csv_path).filename().string(), std::string::npos);
}

Metadata read_metadata(const std::string& path, Inputs& inputs) {
  Metadata metadata;
  if (!inputs.exists(path)) return metadata;
  const toml::table table = read_toml(path, inputs);
  for (const char* const name : {"data", "runs", "models"})
    if (const auto found = table.find(name); found != table.end())
      fail_at(path, found->first,
              "key \"" + std::string(name) + "\" is one of a fit definition, which needs another name than its data");
  for (const auto& [key, node] : table) {
    const std::string name(key.str());
    if (kind_of_field(name).empty()) fail_at(path, key, set_field(metadata, name, ""));
    std::string text;
    if (name == "columns" && node.is_table())
      text = mapping_text(path, *node.as_table());
    else if (node.is_string())
      text = node.as_string()->get();
    else if ((name == "poisson_ratio" || name == "table" || name == "fps") && node.is_number())
      text =
          shortest(node.is_integer() ? static_cast<double>(node.as_integer()->get()) : node.as_floating_point()->get());
    else
      fail_at(path, node, name + " must be " + kind_of_field(name));
    const std::string problem = set_field(metadata, name, text);
    if (!problem.empty()) fail_at(path, node, problem);
  }
  for (std::string* const file : {&metadata.headings, &metadata.definition})
    if (!file->empty()) *file = (std::filesystem::path(path).parent_path() / *file).string();
  return metadata;
}

Metadata metadata_of(const std::string& csv_path, const Overrides& overrides, Inputs& inputs) {
  return with_definition(read_metadata(metadata_path(csv_path), inputs), overrides, inputs);
}

Metadata with_definition(Metadata own, const Overrides& overrides, Inputs& inputs) {
  for (const auto& [name, text] : overrides)
    if (name == "definition") own.definition = text;
  if (own.definition.empty()) return own;
  inputs.read(own.definition);  // throws if there is none
  const Metadata common = read_metadata(own.definition, inputs);
  if (!common.definition.empty()) throw InputError(own.definition, "names another definition; one is read");
  ModeIII mode_III = own.mode_III == ModeIII::unstated ? common.mode_III : own.mode_III;
  for (const auto& [name, text] : overrides)
    if (name == "mode_III") mode_III = text == to_string(ModeIII::averaged) ? ModeIII::averaged : ModeIII::half;
  const bool pair = mode_III != ModeIII::averaged;    // whether poisson_ratio is of youngs_modulus alone
  const auto replaced = [&](std::string_view name) {  // by another field
    if (name == "modulus") return own.youngs_modulus || (pair && own.poisson_ratio);
    if (name == "youngs_modulus" || (pair && name == "poisson_ratio")) return own.modulus.has_value();
    if (name == "load") return !own.load_from.empty();
    return name == "load_from" && own.load.has_value();
  };
  Metadata whole = own;
  for (const MetadataField& field : metadata_fields()) {
    const auto text = stated_text(common, field.name);
    if (text && !stated_text(own, field.name) && !replaced(field.name)) set_field(whole, field.name, *text);
  }
  return whole;
}

Metadata stated_by(const Overrides& overrides) {
  Inputs inputs;
  Metadata stated = with_definition({}, overrides, inputs);
  apply_overrides(overrides, stated);
  return stated;
}

}  // namespace mixity
