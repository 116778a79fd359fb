// Rows of a CSV file with the places they came from. What is in quotes is read by libcsv; lines without any, nearly all
// of what instruments write, are split where the delimiter stands. This adds what both leave to their caller: line
// numbers, byte order mark, delimiter, comments, ragged rows, and blocks that several threads can read.
#pragma once

#include <array>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "base/input_error.h"
#include "dataset/table/encoding.h"

namespace mixity {

struct CsvFormat {
  char delimiter = 0;  // kBlanks: any number of blanks and tabs; quotes are then characters like others
  char line_end = '\n', decimal = '.';
  bool grouped = false;  // "1,234" is a thousand and more, as other numbers of the file show
  bool comments = true;  // a line that starts with '#' is none of the table's
};
inline constexpr char kBlanks = ' ';

class CsvRow {
 public:
  std::size_t line() const { return line_; }  // 1-based; the first of a row that quotes line ends
  std::size_t size() const { return fields_.size(); }
  /// Field i, unquoted, without blanks around it.
  std::string_view operator[](std::size_t i) const { return fields_[i]; }
  /// Field i as one number, written as the file's format has it; false if it is none.
  bool number(std::size_t i, double& value) const;
  bool blank() const { return fields_.empty() || (fields_.size() == 1 && fields_[0].empty()); }
  /// Where field i starts in the file; beyond the last field, the row's end.
  FilePlace place(std::size_t i) const;
  /// The row's lines as they stand in the file.
  std::string_view raw() const { return raw_; }
  char delimiter() const { return format_.delimiter; }
  char decimal() const { return format_.decimal; }

 private:
  friend struct CsvParser;
  friend class CsvNumbers;
  friend class ArrayRows;
  void begin(std::string_view line, std::size_t number, const CsvFormat& format);
  /// One more line of the same text, right behind the last.
  void add(std::string_view line);
  /// A line without quotes, which may still have its end.
  void split(std::string_view line, std::size_t number, const CsvFormat& format);

  std::vector<std::string_view> fields_;
  std::string_view raw_;
  std::size_t line_ = 0;
  CsvFormat format_;
};

using UseRow = std::function<void(const CsvRow&)>;

/// Which fields of a row are wanted as numbers and which as text, by their place in it; others are passed over.
struct CsvWanted {
  std::vector<std::size_t> numbers, texts;
  std::size_t count = 0;  // fields of a row
};

/// Rows on consecutive lines in which each wanted number is one and nothing is quoted, missing or too much.
class CsvNumbers {
 public:
  static constexpr std::size_t kMost = 256;
  std::size_t size() const { return size_; }
  std::size_t line(std::size_t i) const { return first_line_ + i; }
  /// Of all rows, field CsvWanted::numbers[k].
  const double* numbers(std::size_t k) const { return numbers_[k].data(); }
  /// Of row i, field CsvWanted::texts[k], without blanks around it.
  std::string_view text(std::size_t k, std::size_t i) const { return texts_[k][i]; }
  /// Row i as any other; valid until the next call.
  const CsvRow& row(std::size_t i) const;

 private:
  friend class NumberRows;
  friend class ArrayRows;
  std::size_t first_line_ = 1, size_ = 0;
  std::vector<std::array<double, kMost>> numbers_;
  std::vector<std::array<std::string_view, kMost>> texts_;
  std::array<const char*, kMost + 1> begins_;        // of each row in the file's text, and of what follows
  std::function<std::string(std::size_t)> write_{};  // row i as text, where it was never written; else empty
  mutable std::string written_;
  CsvFormat format_;
  mutable CsvRow row_;
};

using UseNumbers = std::function<void(const CsvNumbers&)>;

/// Whole rows of a file. Its parts may be read on several threads at once.
class CsvBlock {
 public:
  /// Calls use(row) for each row that is not blank, and use_comment for what a line that starts with '#' would be as a
  /// row. The row is valid during the call only. Throws InputError for quotes that do not match.
  void rows(const UseRow& use, const UseRow& use_comment = {}) const;
  /// The same, but most rows come as numbers, and only those that cannot come one by one. All in the file's order.
  void rows(const CsvWanted& wanted, const UseNumbers& use_numbers, const UseRow& use_row,
            const UseRow& use_comment = {}) const;
  std::size_t bytes() const { return text_.size(); }
  std::size_t lines() const { return lines_; }

 private:
  friend class CsvFile;
  std::string text_, path_;
  std::size_t first_line_ = 1, lines_ = 0;
  CsvFormat format_;
};

/// A file cut between rows. No more of it is held than a block, or its longest row.
class CsvFile {
 public:
  /// Throws InputError if the file cannot be opened.
  explicit CsvFile(const std::string& path, std::size_t block_bytes = std::size_t{1} << 17);
  /// The file's first lines, whole ones of a block or all; valid until anything else is called. Throws InputError if
  /// the file cannot be read, is a workbook, or has a first row of more than kMostText bytes.
  std::string_view start();
  /// What is before this byte of start() is no row; there, rows of this format begin, on this line of the file.
  void begin_at(std::size_t offset, std::size_t line, const CsvFormat& format);
  /// Makes the block hold the next rows, without begin_at the first of all by itself; false at the end. Throws
  /// InputError if the file cannot be read or has a row of more than kMostText bytes. A block used again spares the
  /// memory of a new one.
  bool next(CsvBlock& block);
  /// After start().
  Encoding encoding() const { return encoding_; }
  char line_end() const { return format_.line_end; }
  /// Whether start() holds the whole file.
  bool at_end() const { return at_end_; }
  /// Of the file; null where that is not known beforehand (a pipe).
  std::optional<std::size_t> bytes() const;

 private:
  bool read(std::string& text, std::size_t bytes);
  void require_a_row_within(const std::string& text) const;
  void begin();

  std::string path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::size_t block_bytes_;
  std::string rest_;  // read, but not handed out
  std::size_t line_ = 1;
  CsvFormat format_;
  Encoding encoding_ = Encoding::utf8;
  std::optional<Decoder> decoder_;  // where it is not UTF-8
  bool begun_ = false, at_end_ = false;
};

/// Calls use(row) for each row that is not blank and does not start with '#', and use_comment as CsvBlock::rows. Any
/// encoding that CsvFile reads; LF or CRLF; comma, semicolon or tab, whichever the first row has most of; a line
/// "sep=;" before that is no row. The row is valid during the call only. Throws InputError for a file that cannot be
/// read or whose quotes do not match.
void read_csv(const std::string& path, const UseRow& use, const UseRow& use_comment = {});

/// The same for text that is already there; `name` stands for the file in messages. Without comments, '#' starts a
/// field like any other character.
void read_csv_text(std::string_view text, const std::string& name, bool comments, const UseRow& use);

/// Text as a CSV field, quoted where it must be to be read back as one field.
std::string csv_field(const std::string& text);

}  // namespace mixity
