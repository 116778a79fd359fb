#include "dataset/table/encoding.h"

#include <utf8proc.h>

#include <algorithm>
#include <array>
#include <cerrno>

namespace mixity {
namespace {

constexpr std::string_view kNoCharacter = "\xEF\xBF\xBD";  // U+FFFD

bool take_mark(std::string_view& text, std::string_view start) {
  if (!text.starts_with(start)) return false;
  text.remove_prefix(start.size());
  return true;
}

/// Checks the start of a text, which may end within a character.
bool is_utf8(std::string_view text) {
  const auto is_ascii = [](char c) { return static_cast<unsigned char>(c) < 0x80; };
  while (true) {
    text.remove_prefix(static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_ascii) - text.begin()));
    if (text.empty()) return true;
    utf8proc_int32_t character = 0;
    const auto* const at = reinterpret_cast<const utf8proc_uint8_t*>(text.data());
    const auto length = utf8proc_iterate(at, static_cast<utf8proc_ssize_t>(text.size()), &character);
    if (length <= 0) {  // the first byte gives the length
      const auto wanted = static_cast<std::size_t>(utf8proc_utf8class[at[0]]);
      if (wanted <= text.size() || wanted < 2) return false;
      for (std::size_t i = 1; i < text.size(); ++i)
        if ((at[i] & 0xC0) != 0x80) return false;
      return true;
    }
    text.remove_prefix(static_cast<std::size_t>(length));
  }
}

unsigned char byte_at(std::string_view text, std::size_t i) { return static_cast<unsigned char>(text[i]); }

/// Most characters of Japanese begin with a byte of 0x81..0x9F, which in Western texts is a quotation mark or a dash.
bool is_shift_jis(std::string_view text) {
  std::size_t pairs = 0, others = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const unsigned char lead = byte_at(text, i);
    if (lead < 0x80) continue;
    const bool single = lead >= 0xA1 && lead <= 0xDF;  // half-width letters
    const bool common = lead > 0x80 && lead < 0xA0;
    if (!single && !common && !(lead >= 0xE0 && lead <= 0xFC)) return false;
    ++(common ? pairs : others);
    if (single || ++i == text.size()) continue;
    const unsigned char trail = byte_at(text, i);
    if (trail < 0x40 || trail == 0x7F || trail > 0xFC) return false;
  }
  return pairs > 1 && pairs > others;
}

/// Bytes above 0x7F stand in pairs, and somewhere two pairs or more stand together.
bool is_chinese(std::string_view text) {
  constexpr unsigned char kFirst = 0xA1, kLast = 0xFE;
  std::size_t longest = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t begin = i;
    for (; i < text.size() && byte_at(text, i) >= 0x80; ++i)
      if (byte_at(text, i) < kFirst || byte_at(text, i) > kLast) return false;
    if ((i - begin) % 2 == 1 && i < text.size()) return false;
    longest = std::max(longest, i - begin);
  }
  return longest > 3;
}

}  // namespace

std::string_view to_string(Encoding encoding) {
  constexpr std::array<std::string_view, 6> kNames{"UTF-8", "UTF-16LE", "UTF-16BE", "Windows-1252", "CP932", "GB18030"};
  return kNames[static_cast<std::size_t>(encoding)];
}

Encoding detect_encoding(std::string_view& start) {
  if (take_mark(start, "\xEF\xBB\xBF")) return Encoding::utf8;
  if (take_mark(start, "\xFF\xFE")) return Encoding::utf16_le;
  if (take_mark(start, "\xFE\xFF")) return Encoding::utf16_be;
  const auto nul = [&](std::size_t i) { return start[i] == '\0'; };
  if (start.size() > 3 && nul(0) != nul(1) && nul(2) == nul(0) && nul(3) == nul(1))
    return nul(0) ? Encoding::utf16_be : Encoding::utf16_le;
  if (is_utf8(start)) return Encoding::utf8;
  return is_shift_jis(start) ? Encoding::shift_jis : is_chinese(start) ? Encoding::gb18030 : Encoding::windows_1252;
}

Decoder::Decoder(Encoding from)
    : state_(iconv_open("UTF-8", std::string(to_string(from)).c_str())),
      unit_(from == Encoding::utf16_le || from == Encoding::utf16_be ? 2 : 1) {}

Decoder::~Decoder() {
  if (usable()) iconv_close(state_);
}

void Decoder::append(std::string_view bytes, bool is_end, std::string& text) {
  waiting_.append(bytes);
  char* in = waiting_.data();
  std::size_t left = waiting_.size();
  std::array<char, 1 << 14> made;
  while (left > 0) {
    char* out = made.data();
    std::size_t room = made.size();
    const bool stopped = iconv(state_, &in, &left, &out, &room) == static_cast<std::size_t>(-1);
    text.append(made.data(), made.size() - room);
    if (!stopped || errno == EINVAL) break;
    if (errno == E2BIG) continue;
    text += kNoCharacter;
    const std::size_t skipped = std::min(unit_, left);
    in += skipped;
    left -= skipped;
  }
  waiting_.erase(0, waiting_.size() - left);
  if (is_end && !waiting_.empty()) text += kNoCharacter;
}

std::string to_utf8(std::string_view bytes) {
  const Encoding encoding = detect_encoding(bytes);
  if (encoding == Encoding::utf8) return std::string(bytes);
  Decoder decoder(encoding);
  if (!decoder.usable()) return std::string(bytes);
  std::string text;
  decoder.append(bytes, true, text);
  return text;
}

}  // namespace mixity
