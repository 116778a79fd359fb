// Names of columns in the exports of laboratories: data/headings.toml, and what a user adds to it.
#pragma once

#include <toml++/toml.h>

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "dataset/table/column_kinds.h"

namespace mixity {

class Vocabulary {
 public:
  /// The one that is compiled into the program.
  static const Vocabulary& shipped();
  /// The shipped one and what the TOML at `path` adds. Throws InputError, with line and column, for anything in it that
  /// cannot be understood, or that calls two quantities by one name.
  static Vocabulary with(const std::string& path);

  /// The quantity of a heading without its unit; null if it is not known.
  std::optional<ColumnId> find(std::string_view name) const;

 private:
  void add(const std::string& path, const toml::table& table);

  std::map<std::string, ColumnId, std::less<>> symbols_, names_;       // as written; folded
  std::map<std::string, std::optional<ColumnId>, std::less<>> words_;  // of the names; null: of two quantities
};

}  // namespace mixity
