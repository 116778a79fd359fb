// Which decimal sign the numbers of a table have.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "dataset/table/lines.h"

namespace mixity {

/// What the numbers of some columns are with one decimal sign.
struct Reading {
  char decimal = '.';
  std::size_t valid_rows = 0;
  bool grouped = false;  // some numbers have groups of three digits, beyond doubt
  // Numbers with a point or comma, those of them that may be groups of three, and those without.
  std::size_t signs = 0, in_threes = 0, bare = 0;
};

/// Of the lines from the first row on, with this sign: '.' or ','.
Reading read_numbers(const std::vector<Line>& lines, std::size_t first_row, const std::vector<std::size_t>& columns,
                     char decimal);

/// With the sign that makes more rows valid, or that the numbers look like. Throws InputError, which shows a number in
/// both readings, if both signs fit equally well.
Reading read_numbers(const std::string& path, const std::vector<Line>& lines, std::size_t first_row,
                     const std::vector<std::size_t>& columns, const CsvFormat& format);

}  // namespace mixity
