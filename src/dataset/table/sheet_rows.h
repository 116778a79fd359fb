// The cells of a sheet as lines of text.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "dataset/table/workbook.h"

namespace mixity {

/// Merged cells in more than one row; their first column has the value.
struct MergedCells {
  std::size_t column = 0, first_row = 0, last_row = 0;
  friend bool operator==(const MergedCells&, const MergedCells&) = default;
};

/// What is known of a sheet only when all of it has been read.
struct SheetTraits {
  std::vector<MergedCells> merged{};
  std::set<std::size_t> dated{};  // columns whose times have dates
  std::size_t width = 0;          // fields in each row; 0: as many as in the rows above it
  char decimal = '.';             // of numbers in cells of text
  bool one_column = false;        // its cells are lines of a text file
  friend bool operator==(const SheetTraits&, const SheetTraits&) = default;
};

struct SheetRows {
  std::string text;
  SheetTraits traits;            // of the rows that were read
  std::size_t hidden = 0;        // rows with numbers
  std::string hidden_columns{};  // with numbers: "C, D"
};

/// Reads at least this many bytes of the text, or all of it, taking the traits as given. `decimal`: as in SheetChoice.
SheetRows read_rows(const Workbook& book, const Workbook::Sheet& sheet, char decimal, const SheetTraits& given,
                    std::size_t bytes);

}  // namespace mixity
