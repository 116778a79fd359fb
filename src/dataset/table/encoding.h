// Converts text files to UTF-8.
#pragma once

#include <iconv.h>

#include <string>
#include <string_view>

namespace mixity {

enum class Encoding { utf8, utf16_le, utf16_be, windows_1252, shift_jis, gb18030 };
/// As iconv calls it: "UTF-8", "UTF-16LE", "UTF-16BE", "Windows-1252", "CP932", "GB18030".
std::string_view to_string(Encoding encoding);

/// Detects the encoding by the first bytes of a file, and removes its byte order mark. UTF-16 without a mark is
/// recognised by its zero bytes, Japanese Shift-JIS and Chinese GB18030 by their pairs of bytes. Everything else that
/// is not UTF-8 is Windows-1252, which includes Latin-1. Letter frequencies are not used: they mistake a heading with
/// one "²" for Windows-1250, one with "µ" for a code page of DOS.
Encoding detect_encoding(std::string_view& start);

/// Converts bytes to UTF-8 by iconv.
class Decoder {
 public:
  explicit Decoder(Encoding from);
  ~Decoder();
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;
  /// False if the system's iconv does not support the encoding.
  bool usable() const { return state_ != reinterpret_cast<iconv_t>(-1); }

  /// Converts the next bytes and appends them to the text. Keeps an incomplete character until its last bytes come; at
  /// the end of the file it becomes U+FFFD, as an invalid one does.
  void append(std::string_view bytes, bool is_end, std::string& text);

 private:
  iconv_t state_;
  std::size_t unit_;  // bytes of the smallest character
  std::string waiting_;
};

/// A whole file as UTF-8, without its byte order mark.
std::string to_utf8(std::string_view bytes);

}  // namespace mixity
