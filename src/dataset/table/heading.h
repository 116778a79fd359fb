// One heading of a table: its name and its unit.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dataset/table/csv.h"

namespace mixity {

/// "T [mN]", "T (mN)" or "T".
struct Heading {
  std::string text;                 // as written
  std::string name;                 // before the first bracket, without TeX's $ and braces
  std::optional<std::string> unit;  // as written in the last brackets; null: there are none
  bool closed = true;               // false: the last bracket is not closed
  FilePlace place;
};

Heading split_heading(std::string_view text, FilePlace place);
std::vector<Heading> headings_of(const CsvRow& header);

/// Like trim; also removes the no-break spaces, zero-width spaces and byte order marks that spreadsheets and web pages
/// add.
std::string_view trim_name(std::string_view text);

/// The letters and digits of a name, in lower case, without accents. Empty if the text is not UTF-8.
std::string folded(std::string_view name);

/// The common part of "P1" and "P2", or "P" and "P.1".
std::string letters_of(std::string_view name);

/// The words of a name, folded and sorted, without articles and prepositions: equal for "area reale di contatto" and
/// "area di contatto reale".
std::string sorted_words(std::string_view name);

/// The text inside a pair of brackets, or the text itself if none surround it.
std::string_view without_brackets(std::string_view text);

}  // namespace mixity
