#include "dataset/csv.h"

#include <csv.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "dataset/input_error.h"

namespace mixity {

std::size_t CsvRow::column(std::size_t i) const {
  std::size_t column = 1, field = 0;
  bool quoted = false;
  for (const char c : raw_) {
    if (field == i) break;
    if (c == '"') quoted = !quoted;
    if (c == delimiter_ && !quoted) ++field;
    if ((c & 0xC0) != 0x80) ++column;  // count characters, not the later bytes of UTF-8
  }
  return column;
}

/// Owns libcsv's state and collects its callbacks into a row. The callbacks do not throw: libcsv is C.
struct CsvParser {
  csv_parser state;
  CsvRow row;
  int completed = 0;
  bool stray_return = false, quote_open = false;

  explicit CsvParser(char delimiter) {
    csv_init(&state, CSV_STRICT | CSV_STRICT_FINI);
    csv_set_delim(&state, static_cast<unsigned char>(delimiter));
    row.delimiter_ = delimiter;
  }
  ~CsvParser() { csv_free(&state); }
  CsvParser(const CsvParser&) = delete;
  CsvParser& operator=(const CsvParser&) = delete;

  static void on_field(void* field, std::size_t size, void* self) {
    CsvParser& parser = *static_cast<CsvParser*>(self);
    if (parser.completed > 0) parser.stray_return = true;
    parser.row.text_.append(static_cast<const char*>(field), size);
    parser.row.ends_.push_back(parser.row.text_.size());
  }
  static void on_row(int, void* self) { ++static_cast<CsvParser*>(self)->completed; }

  /// Feeds one line with its line end; a quoted field may run over several, and the row then counts as the first.
  bool feed(std::string_view line, std::size_t number) {
    if (completed > 0) {
      row.text_.clear();
      row.ends_.clear();
      completed = 0;
    }
    if (!quote_open) {
      row.line_ = number;
      row.raw_ = line.substr(0, line.find_last_not_of("\r\n") + 1);
    }
    if (csv_parse(&state, line.data(), line.size(), on_field, on_row, this) != line.size()) return false;
    if (std::count(line.begin(), line.end(), '"') % 2 != 0) quote_open = !quote_open;
    if (completed > 0 && quote_open) stray_return = true;  // a field began after the row's end
    return true;
  }
  bool finish() { return csv_fini(&state, on_field, on_row, this) == 0; }
};

std::string read_file(const std::string& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) throw InputError(path, std::string("cannot be opened: ") + std::strerror(errno));
  std::string text;
  std::array<char, 1 << 14> part;
  while (const std::size_t got = std::fread(part.data(), 1, part.size(), file.get())) text.append(part.data(), got);
  if (std::ferror(file.get())) throw InputError(path, std::string("cannot be read: ") + std::strerror(errno));
  return text;
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",;\t\"\n\r#") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

void read_csv(const std::string& path, const std::function<void(const CsvRow&)>& use) {
  read_csv_text(read_file(path), path, true, use);
}

namespace {

/// Comma, semicolon or tab, whichever the line has most of outside quotes.
char delimiter_of(std::string_view line) {
  constexpr std::string_view kCandidates = ",;\t";
  std::array<std::size_t, 3> counts{};
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    const std::size_t which = kCandidates.find(c);
    if (!quoted && which != std::string_view::npos) ++counts[which];
  }
  return kCandidates[static_cast<std::size_t>(std::max_element(counts.begin(), counts.end()) - counts.begin())];
}

}  // namespace

void read_csv_text(std::string_view text, const std::string& path, bool comments,
                   const std::function<void(const CsvRow&)>& use) {
  std::string_view rest = text;
  if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
  if (rest.starts_with("\xFF\xFE") || rest.starts_with("\xFE\xFF"))
    throw InputError(path, 1, 1, "is UTF-16; save it as UTF-8");
  const char line_end = rest.find('\n') == std::string_view::npos ? '\r' : '\n';

  std::unique_ptr<CsvParser> parser;
  std::size_t number = 0;
  const auto hand_over = [&] {
    if (parser->stray_return) throw InputError(path, number, 1, "has a carriage return inside the line");
    if (parser->completed > 0 && !parser->row.blank()) use(parser->row);
  };
  while (!rest.empty()) {
    ++number;
    const std::size_t end = std::min(rest.find(line_end), rest.size() - 1) + 1;
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end);
    if (!parser) {
      if ((comments && line.starts_with('#')) || line.find_first_not_of(" \t\r\n") == std::string_view::npos) continue;
      parser = std::make_unique<CsvParser>(delimiter_of(line));
    } else if (comments && line.starts_with('#') && !parser->quote_open) {
      continue;
    }
    if (!parser->feed(line, number))
      throw InputError(path, number, 1, "a quote (\") inside a field is not doubled or not closed");
    hand_over();
  }
  if (!parser || parser->completed > 0) return;
  if (!parser->finish())
    throw InputError(path, parser->row.line(), 1, "a quote (\") is opened but not closed before the end of the file");
  hand_over();
}

}  // namespace mixity
