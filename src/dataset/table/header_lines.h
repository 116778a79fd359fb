// The headings of a table, and a row of units beside them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "dataset/table/column_names.h"
#include "dataset/table/lines.h"

namespace mixity {

struct HeadingLine {
  std::vector<Heading> headings;
  std::size_t first_row;             // index of the first line of numbers
  std::optional<std::size_t> index;  // of the headings; null: there are none, and a mapping names the columns
};

/// The number of fields that most rows of numbers have; 0 if there are none.
std::size_t usual_width(const std::vector<Line>& lines);

/// The line that names most quantities, among the few above the first places where rows of `width` fields begin;
/// without one, a line of words. Null if there is none, and no mapping.
std::optional<HeadingLine> find_headings(const std::string& path, const std::vector<Line>& lines, std::size_t width,
                                         const CsvFormat& format, const ColumnRules& rules);

/// Whether no field is a number, and one at least of the columns at these indices has a unit of something measured; if
/// none are given, half of all columns.
bool is_row_of_units(const Line& line, const std::vector<std::size_t>& columns);

/// Gives the headings the units of that row. Throws InputError for a column that is read if its unit is not known, or
/// not the one of its heading or mapping.
void take_units(const std::string& path, const Line& line, const CsvFormat& format, const ColumnRules& rules,
                std::vector<Heading>& headings);

}  // namespace mixity
