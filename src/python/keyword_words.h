// Remedies in the words of the Python module: keyword arguments.
#pragma once

#include <algorithm>
#include <string>

#include "base/message.h"

namespace mixity {

/// `free="modulus"`, `columns={"P": "1 (mN)"}`, `units={"P": "mN"}`. The program's option format becomes to_dict().
inline std::string keyword_text(const Remedy::Choice& choice) {
  const auto& [option, value, placeholder] = choice;
  if (option == "format" && value == "json") return "to_dict()";
  if (value.empty()) return option;
  if (value == "true" || value == "false") return option + (value == "true" ? "=True" : "=False");
  if (placeholder) return option + "=" + value;
  if (option != "columns" && option != "units") return option + "=\"" + value + "\"";
  std::string entries;  // P=1 (mN),T=2 (mN)
  for (std::size_t begin = 0; begin < value.size();) {
    const std::size_t end = std::min(value.find(',', begin), value.size()), middle = value.find('=', begin);
    entries += (entries.empty() ? "\"" : ", \"") + value.substr(begin, middle - begin) + "\": \"" +
               value.substr(middle + 1, end - middle - 1) + '"';
    begin = end + 1;
  }
  return option + "={" + entries + "}";
}

/// A Wording (base/message.h).
inline std::string in_keywords(const Remedy& remedy) {
  if (remedy.kind == Remedy::Kind::given) return remedy.choices[0].option + ": ";
  std::string keywords;
  for (const Remedy::Choice& choice : remedy.choices) keywords += (keywords.empty() ? "" : ", ") + keyword_text(choice);
  if (remedy.kind == Remedy::Kind::state)
    return (remedy.choices.size() > 1 ? ": state them" : ": state it") +
           (remedy.file.empty() ? "" : " in " + remedy.file + ", or here") + ": " + keywords;
  return remedy.kind == Remedy::Kind::set_or_key ? keywords + ", or the key " + remedy.choices[0].option : keywords;
}

}  // namespace mixity
