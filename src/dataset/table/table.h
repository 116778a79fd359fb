// Where the table of a lab's export begins, and how it is written: what stands before it, the separator, the decimal
// sign, a row of units.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dataset/table/columns.h"
#include "dataset/table/csv.h"

namespace mixity {

struct Table {
  CsvFormat format;
  std::vector<Heading> headings;     // with the units of a row of units
  std::size_t offset = 0, line = 1;  // of the first row below the headings: byte of the text, line of the file
  std::size_t header_line = 0, units_line = 0;  // 0: none
  std::vector<std::size_t> passed_over{};       // lines of words between the headings and the numbers
  std::size_t summary_line = 0;                 // from there on rows say something of those above; 0: none do
};

/// How the start of a file (whole lines, or all of it) is to be read: of all separators and decimal signs the pair by
/// which most rows hold what the headings name. The headings are the line, among the few above the first row of
/// numbers, that names most quantities. Null if no line holds two numbers, or no heading can be told. Throws InputError
/// if two pairs fit equally well and give other numbers; it shows both readings. `decimal`: '.' or ',' where that is
/// stated, else 0.
std::optional<Table> find_table(const std::string& path, std::string_view start, char line_end,
                                const ColumnRules& rules, char decimal);

/// "semicolons, decimal commas, units in line 2, table from line 5".
std::string describe(const Table& table);

}  // namespace mixity
