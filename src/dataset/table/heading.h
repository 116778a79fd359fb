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
  std::optional<std::string> unit;  // as written in the last bracket, without these; null without brackets
  bool closed = true;               // false of an opening bracket that is not closed at the heading's end
  FilePlace place;
};

Heading split_heading(std::string_view text, FilePlace place);
std::vector<Heading> headings_of(const CsvRow& header);

/// As trim, and of no-break and zero-width spaces and byte order marks, which come from spreadsheets and web pages.
std::string_view trim_name(std::string_view text);

/// A name in one spelling: its letters and digits, in lower case, without accents. Empty if the text is no UTF-8.
std::string folded(std::string_view name);

/// The words of a name, folded and sorted, without articles and prepositions: the same for "area reale di contatto" and
/// "area di contatto reale".
std::string sorted_words(std::string_view name);

/// The text between the brackets around it; itself if there are none.
std::string_view without_brackets(std::string_view text);

}  // namespace mixity
