// Converts text files to UTF-8.
#pragma once

#include <iconv.h>

#include <string>
#include <string_view>

namespace mixity {

enum class Encoding { utf8, utf16_le, utf16_be, windows_1252 };
/// "UTF-8", "UTF-16LE", "UTF-16BE", "Windows-1252".
std::string_view to_string(Encoding encoding);

/// Detects the encoding by the first bytes of a file, and removes its byte order mark. UTF-16 without one is recognised
/// by its zero bytes; everything else that is not UTF-8 is Windows-1252, of which Latin-1 is a part. Letter frequencies
/// are not used: for a heading with one "²" they find Windows-1250, for one with "µ" a code page of DOS.
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

  /// Converts bytes that follow those of earlier calls and appends them to the text; an incomplete character waits for
  /// its last bytes. An invalid one becomes U+FFFD.
  void append(std::string_view bytes, std::string& text);
  /// Ends the file: an incomplete character becomes U+FFFD.
  void finish(std::string& text);

 private:
  iconv_t state_;
  std::size_t unit_;  // bytes of the smallest character
  std::string waiting_;
};

}  // namespace mixity
