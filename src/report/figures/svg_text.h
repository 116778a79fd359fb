// Text in SVG: numbers, and labels of figures.
#pragma once

#include <string>
#include <string_view>

namespace mixity {

/// Text to append to, with numbers rounded to hundredths.
struct SvgText {
  std::string text{};

  SvgText& operator<<(double value);
  SvgText& operator<<(std::string_view more) {
    text += more;
    return *this;
  }
};

/// Escapes text between elements and in attributes; control characters, and what XML has no character for, become
/// blanks.
std::string xml_escaped(std::string_view text);

/// The content of a text element. A character or {several} after _ or ^ become a subscript or superscript; a character
/// after \ is literal. `font`: font size.
std::string label_markup(std::string_view label, double font);

/// The width of a label in DejaVu Sans, one of the widest fonts that a page may use.
double label_width(std::string_view label, double font);

}  // namespace mixity
