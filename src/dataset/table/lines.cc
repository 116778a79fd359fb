#include "dataset/table/lines.h"

#include <algorithm>

#include "base/text.h"
#include "dataset/table/number.h"

namespace mixity {
namespace {

/// Whether a line of the text ends outside quotes.
bool holds_a_row(std::string_view text, const CsvFormat& format) {
  bool quoted = false;
  for (std::size_t end = 0; !text.empty(); text.remove_prefix(end)) {
    end = std::min(text.find(format.line_end), text.size() - 1) + 1;
    if (quoted || text[0] != '#' || !format.comments)
      quoted ^= std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '"') % 2 != 0;
    if (!quoted) return true;
  }
  return false;
}

}  // namespace

std::vector<Line> split_lines(std::string_view text, std::size_t first_line, const CsvFormat& format) {
  std::vector<Line> lines;
  const bool is_rest = !text.ends_with(format.line_end);
  CsvSplitter splitter({}, format, first_line);
  std::string_view rest = text;
  try {
    for (CsvRow row; splitter.next(rest, is_rest, row);) {
      const auto offset = static_cast<std::size_t>(row.raw().data() - text.data());
      Line& line = lines.emplace_back(Line{row.line(), offset, {}, std::string(row.raw()), row.is_comment()});
      for (std::size_t i = 0; i < row.size(); ++i) line.fields.emplace_back(row[i]);
    }
  } catch (const InputError&) {
    if (is_rest || holds_a_row(rest, format)) return {};
  }
  return lines;
}

std::vector<FilePlace> places_of(const Line& line, const CsvFormat& format) {
  std::vector<FilePlace> places;
  CsvFormat plain = format;
  plain.comments = false;
  CsvSplitter splitter({}, plain, line.number);
  std::string_view text = line.text;
  try {
    if (CsvRow row; splitter.next(text, true, row))
      for (std::size_t i = 0; i < row.size(); ++i) places.push_back(row.place(i));
  } catch (const InputError&) {  // quotes in a comment
  }
  places.resize(line.fields.size(), {line.number, 1});
  return places;
}

bool is_number(std::string_view field) {
  double value = 0;
  return !trim(field).empty() && (parse_number(field, '.', value) || parse_number(field, ',', value));
}

bool holds_numbers(const Line& line) {
  return !line.comment && std::count_if(line.fields.begin(), line.fields.end(), is_number) >= 2;
}

}  // namespace mixity
