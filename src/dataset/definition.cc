#include "dataset/definition.h"

#include <algorithm>
#include <optional>
#include <sstream>

#include "base/files.h"
#include "base/phrases.h"
#include "base/text.h"
#include "base/toml_file.h"

namespace mixity {
namespace {

using Entries = std::vector<std::pair<std::string, std::string>>;  // keys and texts

bool is_of_the_kind(std::string_view field) {
  return field != "columns" && field != "load" && field != "title" && field != "source" && field != "note" &&
         field != "definition";
}

Entries constants_and_rules(const UnderstoodFile& file, const std::string& path) {
  Entries entries;
  for (const MetadataField& field : metadata_fields())
    if (const auto text = stated_text(file.metadata, field.name); text && is_of_the_kind(field.name))
      entries.emplace_back(field.name, field.is_path ? relative_to(path, *text) : *text);
  return entries;
}

Entries columns(const UnderstoodFile& file) { return {file.mapping.begin(), file.mapping.end()}; }

/// Null if there is no such key.
const std::string* find(const Entries& entries, const std::string& key) {
  const auto found = std::find_if(entries.begin(), entries.end(), [&](const auto& one) { return one.first == key; });
  return found == entries.end() ? nullptr : &found->second;
}

std::string shown(const std::string& path) {
  return printable(path.substr(path.find_last_of('/') + 1), std::string::npos);
}

/// The entries that all files share, and a comment for each of the others.
void write_entries(const std::vector<UnderstoodFile>& files, const std::vector<Entries>& of, std::ostream& out) {
  std::vector<std::string> written;
  for (const Entries& entries : of)
    for (const auto& [key, text] : entries) {
      if (std::find(written.begin(), written.end(), key) != written.end()) continue;
      written.push_back(key);
      std::string differ;
      for (std::size_t k = 0; k < files.size() && differ.empty(); ++k) {
        const std::string* const other = find(of[k], key);
        if (!other || *other != text)
          differ = (other ? toml_text(*other) : std::string("nothing")) + " in " + shown(files[k].path);
      }
      const std::string line = key + " = " + toml_text(text);
      out << (differ.empty() ? line : "# " + line + " in one file, " + differ) << '\n';
    }
}

}  // namespace

UnderstoodFile understood(const Dataset& data, const std::vector<std::string>& placeholders) {
  UnderstoodFile file{data.path, data.metadata, data.mapping, placeholders};
  for (const MetadataField& field : metadata_fields())
    if (field.number && std::find(placeholders.begin(), placeholders.end(), field.name) != placeholders.end())
      (file.metadata.*field.number).reset();
  return file;
}

std::string definition_text(const std::vector<UnderstoodFile>& files, const std::string& path, Wording words) {
  std::ostringstream out;
  std::vector<std::string> names, missing;
  std::vector<Entries> stated, mapped;
  for (const UnderstoodFile& file : files) {
    names.push_back(shown(file.path));
    stated.push_back(constants_and_rules(file, path));
    mapped.push_back(columns(file));
    for (const std::string& one : file.missing)
      if (std::find(missing.begin(), missing.end(), one) == missing.end()) missing.push_back(one);
  }
  out << "# How " << joined(names) << (names.size() == 1 ? " is" : " are")
      << " read, for other files of this kind: " << words(Remedy::set("definition", shown(path)))
      << ", or a copy beside each, with its name.\n";
  write_entries(files, stated, out);
  for (const std::string& one : missing) out << "# " << one << " = \"...\" is needed\n";
  for (const UnderstoodFile& file : files)
    if (const auto load = stated_text(file.metadata, "load"))
      out << "# load = " << toml_text(*load) << " of " << shown(file.path) << " alone\n";
  if (std::any_of(mapped.begin(), mapped.end(), [](const Entries& one) { return !one.empty(); })) {
    out << "\n[columns]\n";
    write_entries(files, mapped, out);
  }
  return out.str();
}

}  // namespace mixity
