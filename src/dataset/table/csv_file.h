// Tables in files, read row by row.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/inputs.h"
#include "dataset/table/csv.h"
#include "dataset/table/encoding.h"
#include "dataset/table/spreadsheet.h"

namespace mixity {

/// A file of rows in any encoding of encoding.h, with LF, CRLF or CR. Holds one block of it, or its longest row; of a
/// workbook, a whole sheet.
class CsvFile {
 public:
  /// Throws InputError if the file cannot be opened.
  CsvFile(const std::string& path, Inputs& inputs, const SheetChoice& choice = {},
          std::size_t block_bytes = std::size_t{1} << 17);
  /// The complete lines of the first block; valid until another member is called. Throws InputError if the file cannot
  /// be read, begins with a row of more than kMostText bytes, or is a workbook that read_workbook refuses.
  std::string_view start();
  /// Starts the rows at this byte of start() or rest_from(0), and at this line of the file. By default they start where
  /// find_first_row says.
  void begin_at(std::size_t offset, std::size_t line, const CsvFormat& format);
  /// Reads the next row or comment; skips comments above the first row. False at the end. Throws InputError as
  /// CsvSplitter does, if the file cannot be read, and for a row of more than kMostText bytes.
  bool next(CsvRow& row);

  /// Where the row that was read last begins, for begin_at.
  std::size_t offset_of(const CsvRow& row) const { return static_cast<std::size_t>(row.raw().data() - text_.data()); }
  /// Reads the file to its end, or up to kMostText bytes. The text from this byte on; other texts are no longer valid.
  std::string_view rest_from(std::size_t offset);

  // After start():
  Encoding encoding() const { return encoding_; }
  char line_end() const { return format_.line_end; }
  /// The sheet of a workbook, without its text; null for other files.
  const std::optional<Sheet>& sheet() const { return sheet_; }
  /// On how the sheet was chosen and read, or on a sheet that is stated for another file.
  std::vector<Message> notes() const;
  /// Whether the whole file has been read, so that start() is all of it.
  bool at_end() const { return stream_.at_end(); }
  /// The fraction of the file whose rows have been read; 1 if its size is unknown (a pipe).
  double progress() const;
  /// Bytes of memory used for text.
  std::size_t held() const { return text_.capacity(); }

 private:
  void begin();
  void begin_workbook();
  void read(std::size_t bytes);
  void read_more();
  void decode(std::size_t from);
  void require_a_row() const;

  std::string path_;
  InputStream stream_;
  SheetChoice choice_;
  std::size_t block_bytes_, line_ = 1;
  std::string text_;    // decoded
  std::size_t at_ = 0;  // where the next row starts
  CsvFormat format_;
  Encoding encoding_ = Encoding::utf8;
  std::optional<Decoder> decoder_;       // if it is not UTF-8
  std::optional<Sheet> sheet_;           // if it is a workbook
  std::optional<CsvSplitter> splitter_;  // once the first row is found
  bool begun_ = false;
};

using UseRow = std::function<void(const CsvRow&)>;

/// Calls use(row) for each row of a file. Throws what CsvFile throws.
void read_csv(const std::string& path, Inputs& inputs, const UseRow& use, const SheetChoice& choice = {});
inline void read_csv(const std::string& path, const UseRow& use) {
  Inputs inputs;
  read_csv(path, inputs, use);
}

/// The whole text of a file of at most kMostText bytes. Throws what CsvFile throws.
std::string read_text(const std::string& path, const SheetChoice& choice);

/// Calls use(row) for each row of a text. `name`: the file named in messages. Without `comments`, '#' is an ordinary
/// character.
void read_csv_text(std::string_view text, const std::string& name, bool comments, const UseRow& use);

}  // namespace mixity
