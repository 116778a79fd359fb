// The bytes of a text file as UTF-8, whatever the program that wrote it took.
#pragma once

#include <iconv.h>

#include <string>
#include <string_view>

namespace mixity {

enum class Encoding { utf8, utf16_le, utf16_be, windows_1252 };
/// "UTF-8", "UTF-16LE", "UTF-16BE", "Windows-1252".
std::string_view to_string(Encoding encoding);

/// What the first bytes of a file are; takes its byte order mark off. UTF-16 without one is known by its zero bytes;
/// what is neither that nor UTF-8 is Windows-1252, which Latin-1 is a part of. No guess by letter frequencies: of a
/// heading with one "²" they make Windows-1250, of one with "µ" a code page of DOS.
Encoding detect_encoding(std::string_view& start);

/// Turns bytes into UTF-8 by iconv.
class Decoder {
 public:
  explicit Decoder(Encoding from);
  ~Decoder();
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;
  /// False where the system's iconv does not know the encoding.
  bool usable() const { return state_ != reinterpret_cast<iconv_t>(-1); }

  /// Appends what these bytes, behind those of earlier calls, say; the first bytes of a character wait for its last.
  /// What stands for no character becomes U+FFFD.
  void append(std::string_view bytes, std::string& text);
  /// At the end of the file: a character that is not whole becomes U+FFFD.
  void finish(std::string& text);

 private:
  iconv_t state_;
  std::size_t unit_;  // bytes of the smallest character
  std::string waiting_;
};

}  // namespace mixity
