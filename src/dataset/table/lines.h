// The first lines of a file, cut into fields, in which its table is looked for.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "dataset/table/csv.h"

namespace mixity {

struct Line {
  std::size_t number, offset;  // of the line in the file; its first byte in the text
  std::vector<std::string> fields;
  std::string text;
  bool comment;
};

/// The lines of a text, the first of which is on this line of the file. None if quotes do not match, as with a wrong
/// separator, unless they are still open at the end of the text.
std::vector<Line> split_lines(std::string_view text, std::size_t first_line, const CsvFormat& format);

/// Where the fields of a line start.
std::vector<FilePlace> places_of(const Line& line, const CsvFormat& format);

/// With either decimal sign.
bool is_number(std::string_view field);

/// Whether two fields are numbers, and it is no comment.
bool holds_numbers(const Line& line);

}  // namespace mixity
