#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "base/input_error.h"
#include "dataset/table/csv.h"
#include "dataset/table/csv_rows.h"

namespace mixity {

CsvFile::CsvFile(const std::string& path, std::size_t block_bytes)
    : path_(path), file_(std::fopen(path.c_str(), "rb"), &std::fclose), block_bytes_(block_bytes) {
  if (!file_) throw InputError(path, std::string("cannot be opened: ") + std::strerror(errno));
}

std::optional<std::size_t> CsvFile::bytes() const {
  std::error_code problem;
  const auto size = std::filesystem::file_size(path_, problem);
  return problem ? std::nullopt : std::optional<std::size_t>(size);
}

/// Appends what up to so many bytes say. False at the end of the file.
bool CsvFile::read(std::string& text, std::size_t bytes) {
  const std::size_t before = text.size();
  text.resize(before + bytes);
  const std::size_t got = std::fread(text.data() + before, 1, bytes, file_.get());
  text.resize(before + got);
  if (std::ferror(file_.get())) throw InputError(path_, std::string("cannot be read: ") + std::strerror(errno));
  at_end_ = got < bytes;
  if (decoder_) {
    const std::string raw = text.substr(before);
    text.resize(before);
    decoder_->append(raw, text);
    if (at_end_) decoder_->finish(text);
  }
  return got > 0;
}

/// Nothing that is data comes near: a device without end, or what a crash left of a file.
void CsvFile::require_a_row_within(const std::string& text) const {
  if (text.size() > kMostText) throw InputError(path_, line_, 1, "a row of more than 256 MB, or a quote never closed");
}

constexpr std::size_t kForEncoding = 64;  // bytes, which a mark and a few characters have room in

/// What is known from the file's first bytes on.
void CsvFile::begin() {
  if (begun_) return;
  begun_ = true;
  std::string& text = rest_;
  read(text, std::max(block_bytes_, kForEncoding));
  for (const std::string_view magic : {"PK\x03\x04", "\xD0\xCF\x11\xE0"})
    if (text.starts_with(magic))
      throw InputError(path_, "is a workbook or an archive; export its sheet as CSV (Excel: Save As, CSV UTF-8)");
  std::string_view marked = text;
  encoding_ = detect_encoding(marked);
  text.erase(0, text.size() - marked.size());
  if (encoding_ != Encoding::utf8) {
    decoder_.emplace(encoding_);
    if (!decoder_->usable())
      throw InputError(path_, "is " + std::string(to_string(encoding_)) + ", which this system's iconv does not know");
    std::string raw;
    std::swap(raw, text);
    decoder_->append(raw, text);
    if (at_end_) decoder_->finish(text);
  }
  // A file without a single line feed is one of the old Macintosh: that takes reading to the first, or to the end.
  while (text.find('\n') == std::string::npos && !at_end_) {
    if (text.find('\r') == std::string::npos) require_a_row_within(text);
    read(text, std::max(block_bytes_, text.size()));
  }
  if (text.find('\n') == std::string::npos) format_.line_end = '\r';
}

std::string_view CsvFile::start() {
  begin();
  const std::string_view text = rest_;
  return at_end_ ? text : text.substr(0, text.rfind(format_.line_end) + 1);
}

void CsvFile::begin_at(std::size_t offset, std::size_t line, const CsvFormat& format) {
  rest_.erase(0, offset);
  line_ = line;
  format_ = format;
}

bool CsvFile::next(CsvBlock& block) {
  begin();
  std::string& text = block.text_;
  text.assign(rest_);
  rest_.clear();
  if (text.size() < block_bytes_ && !at_end_) read(text, block_bytes_ - text.size());
  std::size_t end = end_of_rows(text, format_);
  for (; end == 0 && !at_end_; end = end_of_rows(text, format_)) {  // a row of many lines
    require_a_row_within(text);
    read(text, text.size());
  }
  if (at_end_) end = text.size();
  if (end == 0) return false;
  block.first_line_ = line_;
  std::size_t begin = 0;
  if (format_.delimiter == 0) {
    std::string_view rows = std::string_view(text).substr(0, end);
    find_first_row(rows, block.first_line_, format_);
    begin = end - rows.size();
    end = begin + end_of_first_row(rows, format_);
  }
  rest_.assign(text, end);
  text.resize(end);
  block.lines_ = static_cast<std::size_t>(std::count(text.begin(), text.end(), format_.line_end));
  line_ += block.lines_;
  text.erase(0, begin);
  block.path_ = path_;
  block.format_ = format_;
  return true;
}

void CsvBlock::rows(const UseRow& use, const UseRow& use_comment) const {
  read_rows(text_, first_line_, format_, path_, use, use_comment);
}

void CsvBlock::rows(const CsvWanted& wanted, const UseNumbers& use_numbers, const UseRow& use_row,
                    const UseRow& use_comment) const {
  NumberRows numbers(wanted, format_, use_numbers);
  read_rows(text_, first_line_, format_, path_, use_row, use_comment, &numbers);
}

void read_csv(const std::string& path, const UseRow& use, const UseRow& use_comment) {
  CsvFile file(path);
  for (CsvBlock block; file.next(block);) block.rows(use, use_comment);
}

void read_csv_text(std::string_view text, const std::string& name, bool comments, const UseRow& use) {
  CsvFormat format;
  format.comments = comments;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  if (text.find('\n') == std::string_view::npos) format.line_end = '\r';
  std::size_t line = 1;
  if (find_first_row(text, line, format)) read_rows(text, line, format, name, use);
}

}  // namespace mixity
