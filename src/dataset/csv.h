// Rows of a CSV file with the places they came from. The reader is libcsv; this adds what it leaves to its caller:
// line numbers, byte order mark, delimiter, ragged rows.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace mixity {

class CsvRow {
 public:
  std::size_t line() const { return line_; }          // 1-based
  std::size_t size() const { return ends_.size(); }   // number of fields
  std::string_view operator[](std::size_t i) const {  // field i, unquoted
    const std::size_t begin = i == 0 ? 0 : ends_[i - 1];
    return std::string_view(text_).substr(begin, ends_[i] - begin);
  }
  bool blank() const { return text_.empty() && ends_.size() <= 1; }
  /// 1-based character column at which field i starts in the file.
  std::size_t column(std::size_t i) const;

 private:
  friend struct CsvParser;
  std::string text_;               // the fields, one after the other
  std::vector<std::size_t> ends_;  // where each ends in text_
  std::string_view raw_;           // the line as it stands in the file
  std::size_t line_ = 0;
  char delimiter_ = ',';
};

/// Calls use(row) for each row that is not blank and does not start with '#'. UTF-8 with or without byte order
/// mark; LF or CRLF; comma, semicolon or tab, whichever the first row has most of. The row is valid during the
/// call only. Throws InputError for a file that cannot be read or whose quotes do not match.
void read_csv(const std::string& path, const std::function<void(const CsvRow&)>& use);

/// The same for text that is already there; `name` stands for the file in messages. Without comments, '#' starts a
/// field like any other character.
void read_csv_text(std::string_view text, const std::string& name, bool comments,
                   const std::function<void(const CsvRow&)>& use);

/// Text as a CSV field, quoted where it must be to be read back as one field.
std::string csv_field(const std::string& text);

/// Whole file as a string; throws InputError if it cannot be read.
std::string read_file(const std::string& path);

}  // namespace mixity
