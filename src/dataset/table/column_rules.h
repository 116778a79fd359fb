// How the columns of a table are to be read.
#pragma once

#include <map>
#include <optional>
#include <string>

namespace mixity {

/// What is stated beside a table.
struct ColumnRules {
  std::map<std::string, std::string>
      mapping{};                  // quantity -> heading, with or without its unit, or the column's number
  std::string headings{};         // a TOML that adds to the vocabulary; empty: none
  bool load_stated = false;       // the table needs no column P
  std::optional<double> pixel{};  // m, the side of one
  bool vocabulary = true;         // false: the program's own names alone
  bool log = false;               // the table needs a column of times, and T or A; times are read of logs alone
};

}  // namespace mixity
