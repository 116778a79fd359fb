// Finds the table in a file exported by an instrument, and its format: separator, headings, units, decimal sign.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dataset/table/columns.h"
#include "dataset/table/csv.h"
#include "dataset/table/runs_beside.h"

namespace mixity {

struct Table {
  CsvFormat format;
  std::vector<Heading> headings;     // including units from a row of units
  std::size_t offset = 0, line = 1;  // of the first row below the headings: byte in the text, line in the file
  std::size_t header_line = 0, units_line = 0;  // 0: none
  std::vector<std::size_t> passed_over{};       // lines of words between the headings and the numbers
  std::size_t summary_line = 0;                 // the first row that summarises those above; 0: none
  bool only_rows = false;  // all lines that were searched below the first row are rows that begin with numbers
  RunsBeside beside{};     // the headings are those of its first run
};

/// The table in the first lines of a file, or in all of it. The separator and the decimal sign are those with which the
/// headings name most quantities and most rows contain them. Null if no line contains two numbers, or there are no
/// headings. Throws InputError if both decimal signs fit equally well and give different numbers, and for a row of
/// units that contradicts the headings. `decimal`: '.' or ',' if stated, else 0.
std::optional<Table> find_table(const std::string& path, std::string_view start, char line_end,
                                const ColumnRules& rules, char decimal);

/// "semicolons, decimal commas, units in line 2, table from line 5".
std::string describe(const Table& table);

}  // namespace mixity
