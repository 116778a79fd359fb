// Reads TOML files; every failure is an InputError.
#pragma once

#include <toml++/toml.h>

#include <string>
#include <vector>

#include "base/input_error.h"
#include "base/inputs.h"
#include "base/nearest_name.h"

namespace mixity {

/// Throws InputError for a file that cannot be read, for a syntax error (with line and column), and for a line of more
/// than 10,000 characters, because deep nesting could exhaust the parser's stack.
toml::table read_toml(const std::string& path, Inputs& inputs);

/// A table of columns in the syntax of the option columns: "P=Kanal 3 (mN),T=Kanal 4 (N)". Throws InputError for a
/// heading that is not a string.
std::string mapping_text(const std::string& path, const toml::table& table);

/// A text as a quoted TOML string.
std::string toml_text(const std::string& text);

/// Throws an InputError at the place of a node or key.
template <class Placed>
[[noreturn]] void fail_at(const std::string& path, const Placed& node, const std::string& message) {
  const toml::source_position at = node.source().begin;
  throw InputError(path, at.line, at.column, message);
}

/// The same for a key that is none of the known ones.
[[noreturn]] inline void fail_at_unknown(const std::string& path, const toml::key& key,
                                         const std::vector<std::string>& known) {
  fail_at(path, key, unknown_key(key.str(), known));
}

}  // namespace mixity
