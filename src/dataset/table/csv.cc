#include "dataset/table/csv.h"

#include <algorithm>

#include "base/text.h"
#include "base/units.h"
#include "dataset/table/number.h"

namespace mixity {
namespace {

std::size_t byte(char c) { return static_cast<unsigned char>(c); }

std::string_view without_line_end(std::string_view line) { return line.substr(0, line.find_last_not_of("\r\n") + 1); }

/// Bytes of the first line with its end: a line feed, or a carriage return that no line feed follows. 0 if its end is
/// missing. `is_rest`: the text goes on to the end of the file.
std::size_t line_size(std::string_view text, char line_end, bool is_rest) {
  const std::size_t end = text.find(line_end);
  const std::size_t last = text.substr(0, end).find_last_not_of(" \t\r\n"), size = last + 1;
  if (const std::size_t inside = text.substr(0, size).find('\r'); inside != std::string_view::npos) return inside + 1;
  if (end == std::string_view::npos) return is_rest ? text.size() : 0;
  return end + 1;
}

/// Splits a line in which quotes are ordinary characters.
void split_line(std::string_view line, char delimiter, std::vector<std::string_view>& fields) {
  if (delimiter == kBlanks) {
    for (line = trim(line); !line.empty(); line = trim(line)) {
      fields.push_back(line.substr(0, line.find_first_of(" \t")));
      line.remove_prefix(fields.back().size());
    }
    return;
  }
  for (;;) {
    const std::size_t end = line.find(delimiter);
    fields.push_back(trim(line.substr(0, end)));
    if (end == std::string_view::npos) return;
    line.remove_prefix(end + 1);
  }
}

/// The one of comma, semicolon and tab that occurs most often outside quotes and brackets of units.
char delimiter_of(std::string_view line) {
  constexpr std::string_view kCandidates = ",;\t";
  std::array<std::size_t, 3> counts{};
  bool quoted = false, bracketed = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (!quoted && (c == '[' || c == '(')) bracketed = true;
    if (!quoted && (c == ']' || c == ')')) bracketed = false;
    const std::size_t which = kCandidates.find(c);
    if (!quoted && !bracketed && which != std::string_view::npos) ++counts[which];
  }
  return kCandidates[static_cast<std::size_t>(std::max_element(counts.begin(), counts.end()) - counts.begin())];
}

/// Whether any line of the text ends outside quotes.
bool has_a_row(std::string_view text, const CsvFormat& format) {
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

CsvRow CsvRow::part(std::size_t first, std::size_t count) const {
  CsvRow part;
  const std::size_t begin = std::min(first, size()), end = std::min(first + count, size());
  part.fields_.assign(fields_.begin() + static_cast<std::ptrdiff_t>(begin),
                      fields_.begin() + static_cast<std::ptrdiff_t>(end));
  part.raw_ = raw_;
  part.line_ = line_;
  part.first_ = first_ + first;
  part.format_ = format_;
  return part;
}

std::vector<FilePlace> CsvRow::places() const {
  std::vector<FilePlace> found;
  const std::size_t last = first_ + size();
  found.reserve(last + 1);
  if (!numbers_.empty() || format_.cells) {
    for (std::size_t i = first_; i <= last; ++i) found.push_back({line_, i + 1});
    return found;
  }
  FilePlace place{line_, 1};
  std::size_t field = 0;
  bool begun = false, has_quotes = false, quoted = false;  // of the field: only quotes at its beginning count
  const auto begins = [&](std::size_t next, const char* at) {
    if (format_.delimiter != kBlanks) return field == next;
    const char* const begin = fields_[next].data();
    const bool elsewhere = begin < raw_.data() || begin > raw_.data() + raw_.size();  // unquoted
    return begin == at || elsewhere;
  };
  for (const char& c : raw_) {
    if (found.size() < last && begins(found.size(), &c)) found.push_back(place);
    if (c == '"') {
      has_quotes |= !begun;
      quoted ^= has_quotes;
    }
    begun |= c != ' ' && c != '\t';
    if (c == format_.delimiter && !quoted) {
      ++field;
      begun = has_quotes = false;
    }
    if (c == format_.line_end)
      place = {place.line + 1, 1};
    else if ((c & 0xC0) != 0x80)
      ++place.column;  // count characters, not the later bytes of UTF-8
  }
  if (found.size() < last) found.resize(last, place);
  found.push_back(place);
  found.erase(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(first_));
  return found;
}

FilePlace CsvRow::place(std::size_t i) const { return places()[std::min(i, size())]; }

bool CsvRow::number(std::size_t i, double& value) const {
  if (!numbers_.empty()) {
    value = numbers_[i];
    return true;
  }
  NumberStyle style;
  return parse_number(fields_[i], format_.decimal, value, &style) && (format_.grouped || !style.doubtful);
}

CsvSplitter::CsvSplitter(const std::string& path, const CsvFormat& format, std::size_t line)
    : path_(path), format_(format), line_(line) {
  for (const char c : {format.delimiter, format.line_end, '\r'}) ends_field_[byte(c)] = true;
}

bool CsvSplitter::next(std::string_view& text, bool is_rest, CsvRow& row) {
  while (!text.empty()) {
    const std::size_t size = take(text, is_rest, row);
    if (size == 0) return false;
    text.remove_prefix(size);
    if (!row.blank()) return true;
  }
  return false;
}

void CsvSplitter::fail(std::string_view before, const char* message) const {
  const auto lines = std::count(before.begin(), before.end(), format_.line_end);
  throw InputError(path_, line_ + static_cast<std::size_t>(lines), 1, message);
}

/// Reads the row at the beginning of the text, blank or not. Returns its length in bytes; 0 if its end is missing.
std::size_t CsvSplitter::take(std::string_view text, bool is_rest, CsvRow& row) {
  row.fields_.clear();
  row.fields_.reserve(width_);
  row.unquoted_.clear();
  row.line_ = line_;
  row.format_ = format_;
  row.is_comment_ = format_.comments && text[0] == '#';
  if (row.is_comment_ || format_.delimiter == kBlanks) return take_line(text, is_rest, row);
  const char *at = text.data(), *const end = at + text.size();
  const auto before = [&] { return text.substr(0, static_cast<std::size_t>(at - text.data())); };
  const auto skip_returns = [&] {
    while (at != end && *at != format_.line_end && (*at == '\r' || is_blank(*at))) ++at;
  };
  bool quotes = false;
  skip_returns();
  if (at != end && *at != format_.line_end && *text.data() == '\r') {  // blank lines that end in carriage returns
    at = text.data() + text.substr(0, before().size()).rfind('\r') + 1;
    line_ += static_cast<std::size_t>(std::count(text.data(), at, '\r'));
    return before().size();
  }
  for (;; ++at) {
    while (at != end && is_blank(*at)) ++at;
    if (at != end && *at == '"') {
      quotes = true;
      at = quoted_field(at, end, row);
      if (!at && is_rest) fail({}, "a quote (\") is opened but not closed before the end of the file");
      if (!at) return 0;
    } else {
      const char* const begin = at;
      at = std::find_if(at, end, [&](char c) { return ends_field_[byte(c)]; });
      row.fields_.push_back(trim({begin, static_cast<std::size_t>(at - begin)}));
    }
    if (at == end || *at != format_.delimiter) break;
  }
  if (at != end && *at != format_.line_end) {
    if (*at != '\r' && format_.loose_quotes) return take_as_line(text, is_rest, row);
    if (*at != '\r') fail(before(), "a quote (\") inside a field is not doubled or not closed");
    const char* const first = at;
    skip_returns();
    if (at != end && *at != format_.line_end) at = first;  // ends the line as a line feed does
  }
  if (at == end && !is_rest) return 0;
  row.raw_ = without_line_end(before());
  width_ = row.size();
  if (at != end) ++at;
  line_ +=
      quotes ? std::max<std::size_t>(1, static_cast<std::size_t>(std::count(text.data(), at, format_.line_end))) : 1;
  return before().size();
}

/// The same for a line in which quotes are ordinary characters.
std::size_t CsvSplitter::take_line(std::string_view text, bool is_rest, CsvRow& row) {
  const std::size_t size = line_size(text, format_.line_end, is_rest);
  if (size == 0) return 0;
  row.raw_ = without_line_end(text.substr(0, size));
  split_line(row.raw_, format_.delimiter, row.fields_);
  ++line_;
  return size;
}

/// The same for a row that was read in part.
std::size_t CsvSplitter::take_as_line(std::string_view text, bool is_rest, CsvRow& row) {
  row.fields_.clear();
  row.unquoted_.clear();
  ++loose_rows_;
  return take_line(text, is_rest, row);
}

/// Reads a field in quotes. Returns the first non-blank character after it; null if the quotes are not closed.
const char* CsvSplitter::quoted_field(const char* at, const char* end, CsvRow& row) const {
  const char* const begin = ++at;
  bool doubled = false;
  for (;; at += 2) {
    at = std::find(at, end, '"');
    if (at == end) return nullptr;
    if (at + 1 == end || at[1] != '"') break;
    doubled = true;
  }
  std::string_view field(begin, static_cast<std::size_t>(at - begin));
  if (doubled) {
    std::string& text = row.unquoted_.emplace_back();
    for (const char* c = begin; c != at; c += *c == '"' ? 2 : 1) text += *c;
    field = text;
  }
  row.fields_.push_back(trim(field));
  for (++at; at != end && is_blank(*at);) ++at;
  return at;
}

std::vector<CsvRow> split_rows(std::string_view text, std::size_t first_line, const CsvFormat& format) {
  std::vector<CsvRow> rows(1);
  const bool is_rest = !text.ends_with(format.line_end);
  CsvFormat loose = format;
  loose.loose_quotes = true;
  CsvSplitter splitter({}, loose, first_line);
  try {
    while (splitter.next(text, is_rest, rows.back())) rows.emplace_back();
  } catch (const InputError&) {
    if (is_rest || has_a_row(text, format)) return {};
  }
  rows.pop_back();
  if (2 * splitter.loose_rows() > rows.size()) return {};
  return rows;
}

bool find_first_row(std::string_view& text, std::size_t& line, CsvFormat& format) {
  for (; !text.empty(); ++line) {
    const std::size_t end = line_size(text, format.line_end, true);
    const std::string_view first = without_line_end(text.substr(0, end));
    const bool comment = format.comments && first.starts_with('#');
    // "sep=" tells Excel the delimiter, which may be a tab
    const bool for_excel = first.starts_with("sep=") && first.size() > 4 && trim(first.substr(5)).empty();
    if (!comment && !for_excel && !trim(first).empty()) {
      format.delimiter = delimiter_of(first);
      return true;
    }
    text.remove_prefix(end);
  }
  return false;
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",;\t\"\n\r#") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

std::string spreadsheet_field(const std::string& text) {
  const bool formula = !text.empty() && std::string_view("=+-@\t\r").find(text[0]) != std::string_view::npos;
  return csv_field(formula && !parse_number(text) ? "'" + text : text);
}

}  // namespace mixity
