// How a text of whole rows is read: what csv.cc and csv_file.cc share.
#pragma once

#include <string>
#include <string_view>

#include "dataset/table/csv.h"
#include "dataset/table/csv_numbers.h"

namespace mixity {

/// The rows of a text that ends with one; the first line has this number. With `numbers`, rows that it understands go
/// there; with `use_comment`, lines that start with '#', split as rows are.
void read_rows(std::string_view text, std::size_t first_line, const CsvFormat& format, const std::string& path,
               const UseRow& use, const UseRow& use_comment = {}, NumberRows* numbers = nullptr);

/// Where the last whole row of a text ends; 0 if none does. A line end inside quotes ends no row.
std::size_t end_of_rows(std::string_view text, const CsvFormat& format);

/// Where the first row of a text ends.
std::size_t end_of_first_row(std::string_view text, const CsvFormat& format);

/// Drops what comes before the first row (comments, blank lines, Excel's "sep=;") and chooses the delimiter by that
/// row; counts lines. False, with nothing left, if there is no row.
bool find_first_row(std::string_view& text, std::size_t& line, CsvFormat& format);

}  // namespace mixity
