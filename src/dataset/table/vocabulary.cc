#include "dataset/table/vocabulary.h"

#include <toml++/toml.h>

#include "base/toml_file.h"
#include "dataset/table/heading.h"

namespace mixity {

extern const char* const kShippedHeadings;  // data/headings.toml, made into a source file by CMake

std::optional<ColumnId> Vocabulary::find(std::string_view name) const {
  if (const auto symbol = symbols_.find(name); symbol != symbols_.end()) return symbol->second;
  const std::string bare = folded(name);
  if (const auto found = bare.empty() ? names_.end() : names_.find(bare); found != names_.end()) return found->second;
  const auto found = words_.find(sorted_words(name));
  return found == words_.end() ? std::nullopt : found->second;
}

const Vocabulary& Vocabulary::shipped() {
  static const Vocabulary vocabulary = [] {
    Vocabulary made;
    made.add("headings.toml", toml::parse(kShippedHeadings));
    return made;
  }();
  return vocabulary;
}

Vocabulary Vocabulary::with(const std::string& path) {
  Vocabulary vocabulary = shipped();
  vocabulary.add(path, read_toml(path));
  return vocabulary;
}

void Vocabulary::add(const std::string& path, const toml::table& table) {
  for (const auto& [key, lists] : table) {
    const auto id = column_named(key.str());
    if (!id) fail_at(path, key, "no quantity is called \"" + std::string(key.str()) + "\"");
    if (!lists.is_table()) fail_at(path, lists, "must be a table with lists of symbols and names");
    for (const auto& [kind, list] : *lists.as_table()) {
      const bool symbols = kind == "symbols";
      if (!symbols && kind != "names")
        fail_at(path, kind, "unknown key \"" + std::string(kind.str()) + "\" (known: symbols, names)");
      if (!list.is_array()) fail_at(path, list, std::string(kind.str()) + " must be a list of strings");
      for (const toml::node& entry : *list.as_array()) {
        if (!entry.is_string()) fail_at(path, entry, std::string(kind.str()) + " must be a list of strings");
        const std::string& text = entry.as_string()->get();
        const std::string name = symbols ? text : folded(text);
        if (name.empty()) fail_at(path, entry, "\"" + text + "\" holds neither letters nor digits");
        const auto [at, is_new] = (symbols ? symbols_ : names_).try_emplace(name, *id);
        if (!is_new && at->second != *id)
          fail_at(path, entry, "\"" + text + "\" already is a name of " + std::string(to_string(at->second)));
        if (symbols) continue;
        // words that name two quantities in two orders name none when sorted
        const auto [same, first] = words_.try_emplace(sorted_words(text), *id);
        if (!first && same->second != id) same->second = std::nullopt;
      }
    }
  }
}

}  // namespace mixity
