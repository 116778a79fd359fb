// The start of a file cut by one separator: where its table is, its headings, a row of units, a summary at its end.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dataset/table/table.h"

namespace mixity {

struct Line {
  std::size_t number, offset;
  std::vector<std::string> fields;
  std::string text;
  bool comment;
};

/// A file cut by one separator.
struct Partition {
  std::vector<Line> lines;
  std::size_t first = 0;  // row of numbers
  Table table;
  std::vector<std::size_t> wanted;  // columns of numbers; empty: nothing that is known is named
  std::optional<std::size_t> runs;  // column that names them
};

/// Of the line's fields. Found when they are asked for: of most lines nobody asks.
std::vector<FilePlace> places_of(const Line& line, const CsvFormat& format);

/// Whole lines of a text, the first of which is on this line of the file, cut as `format` says. The headings are the
/// line that names most quantities, among the few above the first rows of numbers. Null if there is no table. Throws
/// InputError for a row of units that has none for a column that is read, or another one than its heading.
std::optional<Partition> part_by(const std::string& path, std::string_view text, std::size_t first_line,
                                 const CsvFormat& format, const ColumnRules& rules);

}  // namespace mixity
