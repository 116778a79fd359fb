// Finds the headings of a table, and a row of units beside them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "dataset/table/column_names.h"
#include "dataset/table/csv.h"

namespace mixity {

struct HeadingLine {
  std::vector<Heading> headings;
  std::size_t first_row;             // index of the first row of numbers
  std::optional<std::size_t> index;  // the line of headings; null: there is none, and a mapping names the columns
  std::size_t named = 0;             // quantities that the headings name
};

std::size_t count_filled(const CsvRow& row);  // its fields that are not empty
/// Whether a field is a number, with any decimal sign.
bool has_a_number(const CsvRow& row);

/// Whether the row is not a comment and has two numbers.
bool is_row_of_numbers(const CsvRow& row);

/// Whether its first field that is filled holds words.
bool begins_with_words(const CsvRow& row);

/// Whether a mapping names columns by their numbers.
bool counts_columns(const ColumnRules& rules);

struct NumberRows {
  std::vector<bool> are;  // whether each line is a row of numbers
  /// The numbers of fields that they have, that of most rows first. Rows that begin with words, as lines of a head do
  /// ("Samples 39 39"), count only if they are most.
  std::vector<std::size_t> widths;
  std::size_t only_from = 0;  // all lines from this index on are rows that begin with numbers
  explicit NumberRows(const std::vector<CsvRow>& lines);
};

/// The line that names most quantities, among the few lines above each of the first places where rows of the usual
/// width begin, or of another, as a comma in the name of a run makes its rows wider. Mappings by number do not count,
/// and a line of units is not one of headings. If no line names a quantity, a line of words is taken. Null if there is
/// none either, and no mapping.
std::optional<HeadingLine> find_headings(const std::string& path, const std::vector<CsvRow>& lines,
                                         const NumberRows& rows, const ColumnRules& rules);

/// Whether the row has no numbers, and at least one of these columns has a unit that is not just a number. If no
/// columns are given, half of all fields must be units.
bool is_row_of_units(const CsvRow& row, const std::vector<std::size_t>& columns);

/// Adds the units in that row to the headings. Throws InputError if the unit of a column that is read is unknown or
/// contradicts its heading or mapping.
void take_units(const std::string& path, const CsvRow& row, const ColumnRules& rules, std::vector<Heading>& headings);

}  // namespace mixity
