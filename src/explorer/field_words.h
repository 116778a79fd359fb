// Remedies in the words of the page: its fields. Options without a field appear as options of the program.
#pragma once

#include <string>

#include "base/message.h"

namespace mixity::explorer {

/// A Wording (base/message.h). Missing constants and given options get no words: the message is beside their fields.
inline std::string in_fields(const Remedy& remedy) {
  if (remedy.kind == Remedy::Kind::given || remedy.kind == Remedy::Kind::state) return "";
  const auto& [first, value, placeholder] = remedy.choices[0];
  if (first == "columns") return "write " + value + " under “Take other columns”";
  if (first == "load" || first == "pixel" || first == "sheet") return '"' + value + "\" under “More of the file”";
  std::string options;
  for (const Remedy::Choice& one : remedy.choices)
    options += (options.empty() ? "" : ", ") + one.option + (one.value.empty() ? "" : "=\"" + one.value + '"');
  return options + " in the program";
}

}  // namespace mixity::explorer
