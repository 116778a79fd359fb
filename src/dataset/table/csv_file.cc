#include "dataset/table/csv_file.h"

#include <algorithm>

#include "base/files.h"
#include "base/input_error.h"
#include "base/text.h"
#include "dataset/table/binary_file.h"

namespace mixity {

CsvFile::CsvFile(const std::string& path, Inputs& inputs, const SheetChoice& choice, std::size_t block_bytes)
    : path_(path), stream_(path, inputs), choice_(choice), block_bytes_(block_bytes) {}

/// Reads up to this many bytes, decodes them and appends them to the text.
void CsvFile::read(std::size_t bytes) {
  const std::size_t before = text_.size();
  stream_.read(bytes, text_);
  decode(before);
}

void CsvFile::decode(std::size_t from) {
  if (!decoder_) return;
  const std::string raw = text_.substr(from);
  text_.resize(from);
  decoder_->append(raw, at_end(), text_);
}

/// No data file has a row of this size: it is an endless device, or was damaged by a crash.
void CsvFile::require_a_row() const {
  if (text_.size() > kMostText)
    throw InputError(path_, splitter_ ? splitter_->line() : line_, 1,
                     "a row of more than 256 MB, or a quote never closed");
}

/// Reads another block. If a row is longer than a block, doubles the text.
void CsvFile::read_more() {
  text_.erase(0, at_);
  at_ = 0;
  require_a_row();
  read(text_.size() < block_bytes_ ? block_bytes_ - text_.size() : text_.size());
}

/// Reads the rest of the file, which has its contents at the end, and unpacks it.
void CsvFile::begin_workbook() {
  while (!at_end()) {
    read(text_.size());
    if (text_.size() > kMostText) throw InputError(path_, "is a workbook or an archive of more than 256 MB");
  }
  sheet_ = read_workbook(path_, text_, choice_);
  text_ = std::move(sheet_->text);
  sheet_->text.clear();
}

/// Reads the first block, and finds the encoding and the line ends.
void CsvFile::begin() {
  constexpr std::size_t kForEncoding = 64;  // bytes: a byte order mark and a few characters
  if (begun_) return;
  begun_ = true;
  read(std::max(block_bytes_, kForEncoding));
  if (is_workbook(text_)) return begin_workbook();
  refuse_binary(path_, text_);
  std::string_view marked = text_;
  encoding_ = detect_encoding(marked);
  text_.erase(0, text_.size() - marked.size());
  if (encoding_ != Encoding::utf8) {
    decoder_.emplace(encoding_);
    if (!decoder_->usable())
      throw InputError(path_, "is " + std::string(to_string(encoding_)) + ", which this system's iconv does not know");
    decode(0);
  }
  // A file without line feeds may end its lines with carriage returns, like old Macintosh files: reads on to find out.
  while (text_.find('\n') == std::string::npos && !at_end()) {
    if (text_.find('\r') == std::string::npos) require_a_row();
    read(std::max(block_bytes_, text_.size()));
  }
  if (text_.find('\n') == std::string::npos) format_.line_end = '\r';
}

std::string_view CsvFile::start() {
  begin();
  const std::string_view rest = std::string_view(text_).substr(at_);
  return at_end() ? rest : rest.substr(0, rest.find_last_of("\r\n") + 1);
}

void CsvFile::begin_at(std::size_t offset, std::size_t line, const CsvFormat& format) {
  at_ = offset;
  CsvFormat known = format;
  known.cells = sheet_.has_value();
  splitter_.emplace(path_, known, line);
}

bool CsvFile::next(CsvRow& row) {
  begin();
  while (!splitter_) {
    std::string_view lines = start();
    const bool found = find_first_row(lines, line_, format_);
    at_ = static_cast<std::size_t>(lines.data() - text_.data());
    if (found)
      splitter_.emplace(path_, format_, line_);
    else if (at_end())
      return false;
    else
      read_more();
  }
  for (;;) {
    std::string_view text = std::string_view(text_).substr(at_);
    const bool found = splitter_->next(text, at_end(), row);
    at_ = text_.size() - text.size();
    if (found || at_end()) return found;
    read_more();
  }
}

std::string_view CsvFile::rest_from(std::size_t offset) {
  while (!at_end() && text_.size() <= kMostText) read(std::max(block_bytes_, text_.size()));
  return std::string_view(text_).substr(offset);
}

std::vector<Message> CsvFile::notes() const {
  constexpr std::size_t kShown = 40;
  if (sheet_) return sheet_->notes;
  if (choice_.sheet.empty()) return {};
  return {"the sheet that is stated, '" + printable(choice_.sheet, kShown) + "', is not used: the file is no workbook"};
}

double CsvFile::progress() const {
  if (sheet_) return text_.empty() ? 1 : static_cast<double>(at_) / static_cast<double>(text_.size());
  if (!stream_.size()) return 1;
  return static_cast<double>(stream_.bytes_read() - (text_.size() - at_)) / static_cast<double>(*stream_.size());
}

void read_csv(const std::string& path, Inputs& inputs, const UseRow& use, const SheetChoice& choice) {
  CsvFile file(path, inputs, choice);
  for (CsvRow row; file.next(row);)
    if (!row.is_comment()) use(row);
}

std::string read_text(const std::string& path, const SheetChoice& choice) {
  const std::string bytes = read_file(path);
  if (is_workbook(bytes)) return read_workbook(path, bytes, choice).text;
  if (!choice.sheet.empty()) throw InputError(Remedy::given("sheet"), path + " is no workbook");
  return to_utf8(bytes);
}

void read_csv_text(std::string_view text, const std::string& name, bool comments, const UseRow& use) {
  CsvFormat format;
  format.comments = comments;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  if (text.find('\n') == std::string_view::npos) format.line_end = '\r';
  std::size_t line = 1;
  if (!find_first_row(text, line, format)) return;
  CsvSplitter splitter(name, format, line);
  for (CsvRow row; splitter.next(text, true, row);)
    if (!row.is_comment()) use(row);
}

}  // namespace mixity
