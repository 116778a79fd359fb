// Remedies in the words of the command line: flags.
#pragma once

#include <algorithm>
#include <cctype>
#include <string>

#include "base/message.h"

namespace mixity::cli {

/// `--free=modulus`, `--pixel="1.7 um"`; switches are written without a value.
inline std::string flag_text(const Remedy::Choice& choice) {
  const auto& [option, value, placeholder] = choice;
  const auto plain = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
  if (value.empty() || value == "true") return "--" + option;
  const bool bare = placeholder || std::all_of(value.begin(), value.end(), plain);
  return "--" + option + "=" + (bare ? value : '"' + value + '"');
}

/// A Wording (base/message.h).
inline std::string in_flags(const Remedy& remedy) {
  if (remedy.kind == Remedy::Kind::given) return flag_text(remedy.choices[0]) + ": ";
  const bool state = remedy.kind == Remedy::Kind::state, several = remedy.choices.size() > 1;
  std::string flags;
  for (const Remedy::Choice& choice : remedy.choices)
    flags += (flags.empty() ? "" : state ? ", " : " ") + flag_text(choice);
  if (state)
    return std::string(": state ") + (several ? "them" : "it") + " in " + remedy.file + " or by " +
           (several ? "flags (" : "a flag (") + flags + ")";
  return remedy.kind == Remedy::Kind::set_or_key ? flags + ", or the key " + remedy.choices[0].option : flags;
}

}  // namespace mixity::cli
