// Reading a TOML file with every failure turned into an InputError.
#pragma once

#include <toml++/toml.h>

#include <string>

#include "base/input_error.h"

namespace mixity {

/// Throws InputError: with line and column for a syntax error, and for a file that cannot be read or a line of more
/// than 10,000 characters, on whose nesting the parser could run out of stack.
toml::table read_toml(const std::string& path);

/// A table of columns as a flag has it: "P=Kanal 3 (mN),T=Kanal 4 (N)". Throws InputError for a heading that is no
/// string.
std::string mapping_text(const std::string& path, const toml::table& table);

/// A text as TOML has it, in quotes.
std::string toml_text(const std::string& text);

/// Throws an InputError at the place of a node or key.
template <class Placed>
[[noreturn]] void fail_at(const std::string& path, const Placed& node, const std::string& message) {
  const toml::source_position at = node.source().begin;
  throw InputError(path, at.line, at.column, message);
}

}  // namespace mixity
