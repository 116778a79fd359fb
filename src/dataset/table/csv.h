// Rows of comma-separated values (RFC 4180 and variants from laboratories) with their places in the file.
#pragma once

#include <array>
#include <cstddef>
#include <list>
#include <string>
#include <string_view>
#include <vector>

#include "base/input_error.h"

namespace mixity {

struct CsvFormat {
  char delimiter = 0;  // kBlanks: any number of blanks and tabs, and quotes are ordinary characters
  char line_end = '\n', decimal = '.';
  bool grouped = false;       // "1,234" is read as 1234
  bool comments = true;       // lines that start with '#' are not part of the table
  bool cells = false;         // of a sheet: places count its columns, not characters
  bool loose_quotes = false;  // a line with text behind a closing quote is split as if all quotes were letters
};
inline constexpr char kBlanks = ' ';

/// A row or a comment. Its fields are views of the text that it was read from.
class CsvRow {
 public:
  std::size_t line() const { return line_; }  // 1-based; the first line of a row with quoted line ends
  bool is_comment() const { return is_comment_; }
  std::size_t size() const { return fields_.size(); }
  /// Field i, unquoted, without blanks around it.
  std::string_view operator[](std::size_t i) const { return fields_[i]; }
  /// Reads field i as a number in the file's format; false if it is not one.
  bool number(std::size_t i, double& value) const;
  bool blank() const { return fields_.empty() || (fields_.size() == 1 && fields_[0].empty()); }
  /// Fields `first` to `first` + `count` (excluded) as a row, at their places in the file. Views of this row.
  CsvRow part(std::size_t first, std::size_t count) const;
  /// Where field i starts in the file; beyond the last field, the end of the row.
  FilePlace place(std::size_t i) const;
  /// The places of all fields and of the end.
  std::vector<FilePlace> places() const;
  /// The lines of the row as in the file.
  std::string_view raw() const { return raw_; }
  char delimiter() const { return format_.delimiter; }
  char decimal() const { return format_.decimal; }
  bool is_of_cells() const {
    return format_.cells && format_.delimiter == '\t';
  }  // not of a CSV pasted into one column

 private:
  friend class CsvSplitter;
  friend class ArrayRows;

  std::vector<std::string_view> fields_;
  std::vector<double> numbers_;      // of a row of arrays, which has no text; otherwise empty
  std::list<std::string> unquoted_;  // fields that had doubled quotes
  std::string_view raw_;
  std::size_t line_ = 0, first_ = 0;  // first_: of a part, its first field in the row
  bool is_comment_ = false;
  CsvFormat format_;
};

/// Splits a text into rows. A field in quotes may contain delimiters, line ends and doubled quotes; in any other field
/// a quote is a letter (4" wafer).
class CsvSplitter {
 public:
  /// `path`: the file named in messages. `line`: the number of the first line of the text.
  CsvSplitter(const std::string& path, const CsvFormat& format, std::size_t line = 1);

  /// Removes the next row or comment from the front of the text, with blank rows before it. False if no complete row is
  /// left. `is_rest`: the text extends to the end of the file, whose last row may lack a line end. A carriage return
  /// outside quotes ends a row, whatever follows it. Throws InputError for unmatched quotes.
  bool next(std::string_view& text, bool is_rest, CsvRow& row);
  std::size_t line() const { return line_; }  // of the remaining text
  std::size_t loose_rows() const { return loose_rows_; }

 private:
  std::size_t take(std::string_view text, bool is_rest, CsvRow& row);
  std::size_t take_line(std::string_view text, bool is_rest, CsvRow& row);
  std::size_t take_as_line(std::string_view text, bool is_rest, CsvRow& row);
  const char* quoted_field(const char* at, const char* end, CsvRow& row) const;
  bool is_blank(char c) const { return (c == ' ' || c == '\t') && c != format_.delimiter; }
  [[noreturn]] void fail(std::string_view before, const char* message) const;

  std::string path_;
  CsvFormat format_;
  std::size_t line_, loose_rows_ = 0, width_ = 0;  // width_: of the row before
  std::array<bool, 256> ends_field_{};
};

/// All rows and comments of a text that begins at this line of the file, to look for a table: a line such as
/// '"Jim" Smith' is a line of words. Empty if quotes are not closed, unless the text ends within them, or if most
/// lines are such, as with a wrong delimiter.
std::vector<CsvRow> split_rows(std::string_view text, std::size_t first_line, const CsvFormat& format);

/// Removes what comes before the first row (comments, blank lines, Excel's "sep=;") and counts its lines. The delimiter
/// becomes the most frequent one in the row: comma, semicolon or tab. False, with no text left, if there is no row.
bool find_first_row(std::string_view& text, std::size_t& line, CsvFormat& format);

/// Text as a CSV field, in quotes if it would not be read back as one field without them.
std::string csv_field(const std::string& text);

/// The same for tables opened in spreadsheets: puts an apostrophe before a text that would be taken for a formula
/// (starting with = + - @, tab or return), unless it is a number.
std::string spreadsheet_field(const std::string& text);

}  // namespace mixity
