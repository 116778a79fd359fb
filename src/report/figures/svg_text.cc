#include "report/figures/svg_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

#include "base/text.h"

namespace mixity {
namespace {

constexpr double kScript = 0.72;  // size of subscripts and superscripts

struct Piece {
  std::string text;
  int shift;  // 1: raised, -1: lowered
};

std::vector<Piece> pieces_of(std::string_view label) {
  std::vector<Piece> pieces;
  int shift = 0;
  bool in_braces = false;
  while (!label.empty()) {
    const char c = label[0];
    const bool literal = c == '\\' && label.size() > 1;
    if (!literal && !in_braces && shift == 0 && (c == '_' || c == '^') && label.size() > 1) {
      shift = c == '^' ? 1 : -1;
      in_braces = label[1] == '{';
      label.remove_prefix(in_braces ? 2 : 1);
      continue;
    }
    if (!literal && in_braces && c == '}') {
      in_braces = false;
      shift = 0;
      label.remove_prefix(1);
      continue;
    }
    if (literal) label.remove_prefix(1);
    const std::size_t length = std::max<std::size_t>(character_length(label), 1);
    if (pieces.empty() || pieces.back().shift != shift) pieces.push_back({{}, shift});
    pieces.back().text += label.substr(0, length);
    label.remove_prefix(length);
    if (!in_braces) shift = 0;
  }
  return pieces;
}

/// Width relative to the font size.
double character_width(char c) {
  const auto in = [c](std::string_view set) { return set.find(c) != std::string_view::npos; };
  if (in(" ',.IJijl-/:;\\f|")) return 0.36;
  if (in("!()[]rt*\"")) return 0.43;
  if (in("mwMW%@#+<=>~^&OQ")) return 0.9;
  return c >= 'A' && c <= 'Z' ? 0.72 : 0.64;
}

}  // namespace

SvgText& SvgText::operator<<(double value) {
  char digits[32]{};
  const char* end = std::to_chars(digits, digits + sizeof digits, std::llround(100 * std::abs(value))).ptr;
  const auto n = static_cast<std::size_t>(end - digits);
  if (value < 0 && digits[0] != '0') text += '-';
  if (n <= 2) {
    text += n == 1 && digits[0] == '0' ? "0" : n == 1 ? "0.0" : "0.";
    if (digits[0] != '0') text.append(digits, digits[n - 1] == '0' ? n - 1 : n);
    return *this;
  }
  text.append(digits, n - 2);
  if (digits[n - 1] == '0' && digits[n - 2] == '0') return *this;
  text += '.';
  text.append(end - 2, digits[n - 1] == '0' ? 1 : 2);
  return *this;
}

std::string xml_escaped(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  std::size_t kept = 0;  // text before this is already in `out`
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    // XML has no U+FFFE and U+FFFF
    const bool none = c == '\xEF' && (text.substr(i, 3) == "\xEF\xBF\xBE" || text.substr(i, 3) == "\xEF\xBF\xBF"),
               control = none || static_cast<unsigned char>(c) < ' ';
    if (!control && c != '&' && c != '<' && c != '>' && c != '"') continue;
    out += text.substr(kept, i - kept);
    out += control ? " " : c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : "&quot;";
    if (none) i += 2;
    kept = i + 1;
  }
  return out += text.substr(kept);
}

std::string label_markup(std::string_view label, double font) {
  std::string out;
  int before = 0;
  for (const auto& [text, shift] : pieces_of(label)) {
    const auto below = [&](int at) { return static_cast<int>(at > 0 ? -0.4 * font : at < 0 ? 0.25 * font : 0); };
    const int lower = below(shift) - below(before);
    before = shift;
    if (lower == 0 && shift == 0) {
      out += xml_escaped(text);
      continue;
    }
    out += "<tspan dy=\"" + std::to_string(lower) + '"';
    if (shift != 0) out += " font-size=\"" + std::to_string(static_cast<int>(kScript * font + 0.5)) + '"';
    out += '>' + xml_escaped(text) + "</tspan>";
  }
  return out;
}

double label_width(std::string_view label, double font) {
  double width = 0;
  for (const auto& [text, shift] : pieces_of(label))
    for (const char c : text)
      if ((static_cast<unsigned char>(c) & 0xC0) != 0x80) width += (shift == 0 ? 1 : kScript) * character_width(c);
  return width * font;
}

}  // namespace mixity
