#include <algorithm>
#include <cctype>
#include <cstdio>
#include <pugixml.hpp>
#include <set>
#include <sstream>
#include <string_view>

#include "base/phrases.h"
#include "base/text.h"
#include "report/figures/svg.h"

namespace mixity {
namespace {

constexpr std::size_t kColors = 8;

std::string text_of(const pugi::xml_node& svg) {
  std::ostringstream out;
  svg.print(out, "", pugi::format_raw);
  return out.str();
}

/// Calls visit(node) for every element, children first, so that visit may remove it.
template <class Visit>
void for_each_element(pugi::xml_node node, const Visit& visit) {
  for (pugi::xml_node child = node.first_child(); child;) {
    const pugi::xml_node next = child.next_sibling();
    if (child.type() == pugi::node_element) for_each_element(child, visit);
    child = next;
  }
  visit(node);
}

/// "rgb(  0, 114, 178)", "#0072B2" or "black" as "#0072b2"; else as it is.
std::string hexadecimal(std::string value) {
  if (value == "black") return "#000000";
  int r = 0, g = 0, b = 0;
  if (std::sscanf(value.c_str(), "rgb(%d,%d,%d)", &r, &g, &b) == 3) {
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", r & 255, g & 255, b & 255);
    return text;
  }
  for (char& c : value) c = c >= 'A' && c <= 'F' ? static_cast<char>(c - 'A' + 'a') : c;
  return value;
}

// The elements and attributes of our own drawings.
constexpr std::string_view kElements = " circle desc g line path polygon polyline rect svg text title tspan ";
constexpr std::string_view kAttributes =
    " cx cy d dx dy fill fill-opacity font-family font-size font-style font-weight height lengthAdjust points r rx ry "
    "stroke stroke-dasharray stroke-linecap stroke-linejoin stroke-opacity stroke-width text-anchor textLength "
    "transform viewBox width x x1 x2 y y1 y2 ";

/// `name`: an XML name, without blanks.
bool is_one_of(std::string_view list, const std::string& name) {
  return list.find(' ' + name + ' ') != std::string_view::npos;
}

/// Whether a value has only numbers, names, colours and lists of them, and no references.
bool is_plain(std::string_view value) {
  const bool plain = std::all_of(value.begin(), value.end(), [](unsigned char c) {
    return std::isalnum(c) || std::string_view(" \t\r\n").find(static_cast<char>(c)) != std::string_view::npos ||
           std::string_view("#.,()%+-").find(static_cast<char>(c)) != std::string_view::npos;
  });
  const auto same = [](char x, char y) { return std::tolower(static_cast<unsigned char>(x)) == y; };
  constexpr std::string_view kAddress = "url";
  return plain && std::search(value.begin(), value.end(), kAddress.begin(), kAddress.end(), same) == value.end();
}

/// Whether a viewBox is four numbers and neither side is far longer than the other, as a page would make room for it.
bool has_shape_of_a_drawing(const char* box) {
  constexpr double kLongest = 5;
  double x = 0, y = 0, width = 0, height = 0;
  int read = 0;
  return is_plain(box) && std::sscanf(box, "%lf%*[ ,]%lf%*[ ,]%lf%*[ ,]%lf%n", &x, &y, &width, &height, &read) == 4 &&
         box[read] == '\0' && width > 0 && height > 0 && width < kLongest * height && height < kLongest * width;
}

/// One line of characters that XML allows; long texts are cut.
std::string plain_text(std::string text) {
  constexpr std::size_t kLongest = 4000;  // ours have some 200
  for (char& c : text)
    if (c == '\n' || c == '\t' || c == '\r') c = ' ';
  return printable(text, kLongest);
}

/// Copies the allowed parts of an element and of its descendants.
class Copier {
 public:
  /// False if elements are nested more deeply than in a drawing.
  bool copy(const pugi::xml_node& from, pugi::xml_node to, int depth = 0) {
    constexpr int kDeepest = 32;  // ours have 5 levels
    if (depth == kDeepest) return false;
    for (const pugi::xml_attribute& attribute : from.attributes()) copy(attribute, to, depth == 0);
    const std::string_view name = from.name();
    const bool holds_text = name == "text" || name == "tspan" || name == "title" || name == "desc";
    for (const pugi::xml_node& child : from.children()) {
      if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata) {
        if (holds_text) to.append_child(pugi::node_pcdata).set_value(plain_text(child.value()).c_str());
      } else if (child.type() != pugi::node_element) {
        continue;
      } else if (!is_one_of(kElements, child.name()) || child.name() == std::string_view("svg")) {
        drop(child.name());
      } else if (!copy(child, to.append_child(child.name()), depth + 1)) {
        return false;
      }
    }
    return true;
  }
  std::vector<std::string> dropped() const {
    constexpr std::size_t kMost = 20;
    std::vector<std::string> names;
    for (const std::string& name : dropped_)
      if (names.size() < kMost) names.push_back(name);
    if (dropped_.size() > kMost) names.push_back(counted(dropped_.size() - kMost, "other"));
    return names;
  }

 private:
  void drop(std::string_view name) {
    constexpr std::size_t kLongest = 40;
    dropped_.insert("'" + printable(name, kLongest) + "'");
  }
  void copy(const pugi::xml_attribute& attribute, pugi::xml_node& to, bool outermost) {
    const std::string name = attribute.name();
    // The page sets the drawing's size; name and text alternative are our own.
    if (outermost && (name == "width" || name == "height" || name == "role" || name == "aria-label")) return;
    if (name == "xmlns" || name.starts_with("xmlns:")) return;  // no name with a prefix is kept
    if (is_one_of(kAttributes, name) && is_plain(attribute.value()) && !to.attribute(name.c_str()))
      to.append_attribute(name.c_str()).set_value(attribute.value());
    else
      drop(name);
  }

  std::set<std::string> dropped_;
};

}  // namespace

KeptFigure kept_figure(const std::string& text, const std::string& name) {
  constexpr std::size_t kLargest = std::size_t{1} << 22;  // ours have at most some 200 kB
  if (text.size() > kLargest) return {{}, "is larger than a drawing, 4 MB", {}};
  pugi::xml_document document, rebuilt;
  if (!document.load_string(text.c_str()) || !document.child("svg")) return {{}, "is no SVG", {}};
  const pugi::xml_node from = document.child("svg");
  if (!from.attribute("viewBox")) return {{}, "has no viewBox", {}};
  if (!has_shape_of_a_drawing(from.attribute("viewBox").value()))
    return {{}, "has a viewBox that is not that of a drawing", {}};
  pugi::xml_node svg = rebuilt.append_child("svg");
  svg.append_attribute("xmlns").set_value("http://www.w3.org/2000/svg");
  Copier copier;
  if (!copier.copy(from, svg)) return {{}, "is nested more deeply than a drawing", {}};
  Figure figure{name, svg.child("title").text().get(), {}, {}, {}};
  figure.caption = svg.child("desc").text().get();
  svg.append_attribute("role").set_value("img");
  svg.append_attribute("aria-label").set_value((figure.title + ". " + figure.caption).c_str());
  figure.drawn = text_of(svg);
  return {std::move(figure), {}, copier.dropped()};
}

std::string themed(const std::string& value) {
  const std::string hex = hexadecimal(value);
  if (hex == "#ffffff") return "var(--paper)";
  if (hex == "#000000") return "var(--ink)";
  for (std::size_t i = 0; i < kColors; ++i)
    if (hex == color(i)) return "var(--color-" + std::to_string(i) + ")";
  return value;
}

std::string themed_svg(const std::string& text) {
  pugi::xml_document document;
  document.load_string(text.c_str());
  pugi::xml_node svg = document.child("svg");
  // The background is the first rectangle or polygon of all, filled with white.
  for (const char* shape : {"rect", "polygon"})
    if (const pugi::xml_node found =
            svg.find_node([&](const pugi::xml_node& node) { return node.name() == std::string_view(shape); }))
      if (themed(found.attribute("fill").value()) == "var(--paper)") {
        found.parent().remove_child(found);
        break;
      }
  for_each_element(svg, [&](const pugi::xml_node& node) {
    for (const char* name : {"stroke", "fill", "color"})
      if (pugi::xml_attribute paint = node.attribute(name)) paint.set_value(themed(paint.value()).c_str());
  });
  return text_of(svg);
}

}  // namespace mixity
