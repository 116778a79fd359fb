// Which decimal sign the numbers of a table have.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "dataset/table/csv.h"

namespace mixity {

/// What the fields of some columns are if this is the decimal sign.
struct Reading {
  char decimal = '.';
  std::size_t valid_rows = 0;
  bool grouped = false;  // some numbers certainly have groups of three digits
  // Fields with a point or comma, those of them that may be one group of three digits, and numbers without either sign.
  std::size_t signs = 0, in_threes = 0, bare = 0;
};

/// Reads the rows from first_row on with this sign: '.' or ','.
Reading read_numbers(const std::vector<CsvRow>& rows, std::size_t first_row, const std::vector<std::size_t>& columns,
                     char decimal);

/// Reads them with the sign that makes more rows valid, or that the numbers look like. Throws InputError, which shows a
/// number in both readings, if both signs fit equally well.
Reading read_numbers(const std::string& path, const std::vector<CsvRow>& rows, std::size_t first_row,
                     const std::vector<std::size_t>& columns);

}  // namespace mixity
