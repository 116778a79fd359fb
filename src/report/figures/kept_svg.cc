#include <cstdio>
#include <pugixml.hpp>
#include <sstream>

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

}  // namespace

std::optional<Figure> kept_figure(const std::string& text, const std::string& name) {
  pugi::xml_document document;
  if (!document.load_string(text.c_str()) || !document.child("svg")) return std::nullopt;
  pugi::xml_node svg = document.child("svg");
  Figure figure{name, svg.child("title").text().get(), {}, {}, {}};
  figure.caption = svg.child("desc").text().get();
  for_each_element(svg, [&](pugi::xml_node node) {
    const std::string_view element = node.name();
    if (element == "script" || element == "foreignObject" || element == "image" || element == "style" ||
        element == "a") {
      node.parent().remove_child(node);
      return;
    }
    for (pugi::xml_attribute attribute = node.first_attribute(); attribute;) {
      const pugi::xml_attribute next = attribute.next_attribute();
      const std::string_view key = attribute.name();
      std::string value = attribute.value();
      const std::size_t hash = value.find('#');
      if (key.starts_with("on") || (key.ends_with("href") && hash != 0)) {
        node.remove_attribute(attribute);
      } else if (key == "id") {
        attribute.set_value((name + '-' + value).c_str());
      } else if (key.ends_with("href") || (key == "clip-path" && hash != std::string::npos)) {
        attribute.set_value(value.insert(hash + 1, name + '-').c_str());
      }
      attribute = next;
    }
  });
  for (const char* own : {"role", "aria-label"}) svg.remove_attribute(own);
  svg.append_attribute("role").set_value("img");
  svg.append_attribute("aria-label").set_value((figure.title + ". " + figure.caption).c_str());
  figure.drawn = text_of(svg);
  return figure;
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
