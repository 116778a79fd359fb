// Text of SVG: numbers, and labels of figures.
#pragma once

#include <string>
#include <string_view>

namespace mixity {

/// Text that grows, with numbers rounded to hundredths.
struct SvgText {
  std::string text{};

  SvgText& operator<<(double value);
  SvgText& operator<<(std::string_view more) {
    text += more;
    return *this;
  }
};

/// As text between elements or as an attribute; control characters become blanks.
std::string xml_escaped(std::string_view text);

/// The content of a text element: what follows _ or ^, a character or {several}, is set lower or higher, and the
/// character behind a \ is taken as it is. `font`: its size.
std::string label_markup(std::string_view label, double font);

/// The width of a label as it is set: that of DejaVu Sans, one of the widest fonts that a page may get.
double label_width(std::string_view label, double font);

}  // namespace mixity
