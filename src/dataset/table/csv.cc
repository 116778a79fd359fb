#include "dataset/table/csv.h"

#include <csv.h>

#include <algorithm>
#include <array>

#include "base/input_error.h"
#include "base/trim.h"
#include "dataset/table/csv_rows.h"
#include "dataset/table/number.h"

namespace mixity {

FilePlace CsvRow::place(std::size_t i) const {
  FilePlace place{line_, 1};
  std::size_t field = 0;
  bool quoted = false;
  const char* const stop = format_.delimiter != kBlanks ? nullptr
                           : i < fields_.size()         ? fields_[i].data()
                                                        : raw_.data() + raw_.size();
  for (const char& c : raw_) {
    if (stop ? &c == stop : field == i) break;
    if (c == '"') quoted = !quoted;
    if (c == format_.delimiter && !quoted) ++field;
    if (c == format_.line_end)
      place = {place.line + 1, 1};
    else if ((c & 0xC0) != 0x80)
      ++place.column;  // count characters, not the later bytes of UTF-8
  }
  return place;
}

bool CsvRow::number(std::size_t i, double& value) const {
  NumberStyle style;
  return parse_number(fields_[i], format_.decimal, value, &style) && (format_.grouped || !style.doubtful);
}

void CsvRow::begin(std::string_view line, std::size_t number, const CsvFormat& format) {
  line_ = number;
  format_ = format;
  raw_ = {line.data(), 0};
  add(line);
}

void CsvRow::add(std::string_view line) {
  raw_ = {raw_.data(), static_cast<std::size_t>(line.data() - raw_.data()) + line.find_last_not_of("\r\n") + 1};
}

void CsvRow::split(std::string_view line, std::size_t number, const CsvFormat& format) {
  begin(line, number, format);
  fields_.clear();
  if (format.delimiter == kBlanks) {
    for (std::string_view rest = trim(raw_); !rest.empty(); rest = trim(rest)) {
      fields_.push_back(rest.substr(0, rest.find_first_of(" \t")));
      rest.remove_prefix(fields_.back().size());
    }
    return;
  }
  for (std::string_view rest = raw_;;) {
    const std::size_t end = rest.find(format.delimiter);
    fields_.push_back(trim(rest.substr(0, end)));  // as libcsv does
    if (end == std::string_view::npos) return;
    rest.remove_prefix(end + 1);
  }
}

namespace {

/// Comma, semicolon or tab, whichever the line has most of outside quotes and the brackets of units.
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

/// The first line of a text, its end included; takes it off.
std::string_view take_line(std::string_view& text, char line_end) {
  const std::string_view line = text.substr(0, std::min(text.find(line_end), text.size() - 1) + 1);
  text.remove_prefix(line.size());
  return line;
}

/// What follows it in the line would be lost with a comment.
bool has_return_inside(std::string_view line) { return line.find('\r') < line.find_last_not_of("\r\n") + 1; }
constexpr std::string_view kReturnInside = "has a carriage return inside the line";

bool odd_quotes(std::string_view line) { return std::count(line.begin(), line.end(), '"') % 2 != 0; }

}  // namespace

/// Makes rows of lines. For quotes it owns libcsv's state, whose callbacks do not throw: libcsv is C.
struct CsvParser {
  csv_parser state;
  CsvFormat format;
  CsvRow row;
  std::string text;               // the fields libcsv has found, one after the other
  std::vector<std::size_t> ends;  // where each ends in it
  int completed = 0;
  bool stray_return = false, quote_open = false;

  explicit CsvParser(const CsvFormat& of_file) : format(of_file) {
    csv_init(&state, CSV_STRICT | CSV_STRICT_FINI);
    csv_set_delim(&state, static_cast<unsigned char>(format.delimiter));
  }
  ~CsvParser() { csv_free(&state); }
  CsvParser(const CsvParser&) = delete;
  CsvParser& operator=(const CsvParser&) = delete;

  /// True of quotes, and of a carriage return inside the line.
  bool needs_library(std::string_view line) const {
    if (format.delimiter == kBlanks) return false;
    return quote_open || line.find('"') != std::string_view::npos || has_return_inside(line);
  }
  void split(std::string_view line, std::size_t number) { row.split(line, number, format); }

  static void on_field(void* field, std::size_t size, void* self) {
    CsvParser& parser = *static_cast<CsvParser*>(self);
    if (parser.completed > 0) parser.stray_return = true;
    parser.text.append(static_cast<const char*>(field), size);
    parser.ends.push_back(parser.text.size());
  }
  static void on_row(int, void* self) { ++static_cast<CsvParser*>(self)->completed; }

  /// Feeds one line with its line end; a quoted field may run over several, and the row then counts as the first.
  bool feed(std::string_view line, std::size_t number) {
    if (quote_open) {
      row.add(line);
    } else {
      row.begin(line, number, format);
      text.clear();
      ends.clear();
      completed = 0;
    }
    if (csv_parse(&state, line.data(), line.size(), on_field, on_row, this) != line.size()) return false;
    if (odd_quotes(line)) quote_open = !quote_open;
    if (completed > 0 && quote_open) stray_return = true;  // a field began after the row's end
    return true;
  }
  bool finish() { return csv_fini(&state, on_field, on_row, this) == 0; }

  /// The fields that libcsv has found become the row's.
  void gather() {
    row.fields_.clear();
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const std::size_t begin = i == 0 ? 0 : ends[i - 1];
      row.fields_.push_back(trim(std::string_view(text).substr(begin, ends[i] - begin)));
    }
  }
};

void read_rows(std::string_view text, std::size_t first_line, const CsvFormat& format, const std::string& path,
               const UseRow& use, const UseRow& use_comment, NumberRows* numbers) {
  CsvParser parser(format);
  std::size_t number = first_line;
  // Of most files this can be said at once, which saves looking through each of their lines for what none has.
  const bool unquoted = format.delimiter == kBlanks || text.find('"') == std::string_view::npos;
  const bool plain = unquoted && text.find('\r') == std::string_view::npos;
  const auto hand_over = [&] {
    if (parser.stray_return) throw InputError(path, number, 1, std::string(kReturnInside));
    if (parser.completed == 0) return;
    parser.gather();
    if (!parser.row.blank()) use(parser.row);
  };
  const char* const whole_lines = text.data() + (text.find_last_of(format.line_end) + 1);  // npos + 1 is 0
  bool fed = false;
  for (; !text.empty(); ++number) {
    if (numbers && unquoted) {
      number += numbers->take(text, whole_lines, number);
      if (text.empty()) break;
    }
    const std::string_view line = take_line(text, format.line_end);
    if (format.comments && line.starts_with('#') && !parser.quote_open) {
      if (!plain && has_return_inside(line)) throw InputError(path, number, 1, std::string(kReturnInside));
      if (!use_comment) continue;
      parser.split(line, number);
      use_comment(parser.row);
      continue;
    }
    fed = !plain && parser.needs_library(line);
    if (!fed) {
      parser.split(line, number);
      if (!parser.row.blank()) use(parser.row);
      continue;
    }
    if (!parser.feed(line, number))
      throw InputError(path, number, 1, "a quote (\") inside a field is not doubled or not closed");
    hand_over();
  }
  if (!fed || parser.completed > 0) return;
  if (!parser.finish())
    throw InputError(path, parser.row.line(), 1, "a quote (\") is opened but not closed before the end of the file");
  hand_over();
}

std::size_t end_of_rows(std::string_view text, const CsvFormat& format) {
  if (format.delimiter == kBlanks || text.find('"') == std::string_view::npos)
    return text.find_last_of(format.line_end) + 1;  // npos + 1 is 0
  std::size_t end = 0;
  bool quote_open = false;
  for (std::string_view rest = text; !rest.empty();) {
    const std::string_view line = take_line(rest, format.line_end);
    if (!(format.comments && line.starts_with('#') && !quote_open) && odd_quotes(line)) quote_open = !quote_open;
    if (!quote_open && line.back() == format.line_end) end = text.size() - rest.size();
  }
  return end;
}

std::size_t end_of_first_row(std::string_view text, const CsvFormat& format) {
  bool quote_open = false;
  for (std::string_view rest = text; !rest.empty();) {
    if (odd_quotes(take_line(rest, format.line_end))) quote_open = !quote_open;
    if (!quote_open) return text.size() - rest.size();
  }
  return text.size();
}

bool find_first_row(std::string_view& text, std::size_t& line, CsvFormat& format) {
  for (; !text.empty(); ++line) {
    std::string_view after = text;
    const std::string_view first = take_line(after, format.line_end);
    const bool comment = format.comments && first.starts_with('#') && !has_return_inside(first);
    // how Excel would be told the delimiter, which may be a tab
    const std::string_view bare = first.substr(0, first.find_last_not_of("\r\n") + 1);
    const bool for_excel = bare.starts_with("sep=") && bare.size() > 4 && trim(bare.substr(5)).empty();
    if (!comment && !for_excel && first.find_first_not_of(" \t\r\n") != std::string_view::npos) {
      format.delimiter = delimiter_of(first);
      return true;
    }
    text = after;
  }
  return false;
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",;\t\"\n\r#") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

}  // namespace mixity
