// Finds the decimal sign of the numbers of a table.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "dataset/table/csv.h"

namespace mixity {

/// What the fields of some columns are when read with this decimal sign.
struct Reading {
  char decimal = '.';
  std::size_t valid_rows = 0;
  bool grouped = false;  // some numbers certainly have groups of three digits
  // Numbers of fields: with a point or comma, of these perhaps one group of three digits, and with neither sign.
  std::size_t signs = 0, in_threes = 0, bare = 0;
};

/// Reads the rows from first_row on with this sign: '.' or ','.
Reading read_numbers(const std::vector<CsvRow>& rows, std::size_t first_row, const std::vector<std::size_t>& columns,
                     char decimal);

/// Reads them with the sign that makes more rows valid, or that the numbers look like. Throws InputError if both signs
/// fit equally well; its message shows a number in both readings.
Reading read_numbers(const std::string& path, const std::vector<CsvRow>& rows, std::size_t first_row,
                     const std::vector<std::size_t>& columns);

}  // namespace mixity
