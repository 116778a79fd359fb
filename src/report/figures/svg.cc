#include "report/figures/svg.h"

#include <charconv>
#include <cstdio>
#include <pugixml.hpp>
#include <sstream>

#include "base/output_file.h"

namespace mixity {
namespace {

constexpr std::size_t kColors = 8;

pugi::xml_document parsed(const std::string& svg) {
  pugi::xml_document document;
  if (!document.load_string(svg.c_str()) || !document.child("svg")) throw OutputError("gnuplot wrote no SVG");
  return document;
}

std::string text_of(const pugi::xml_document& document) {
  std::ostringstream out;
  document.save(out, "", pugi::format_raw | pugi::format_no_declaration);
  return out.str();
}

/// Calls visit(node) for every element, children first, so that visit may remove it.
template <class Visit>
void for_each_element(pugi::xml_node node, const Visit& visit) {
  for (pugi::xml_node child = node.first_child(); child;) {
    const pugi::xml_node next = child.next_sibling();
    if (child.type() == pugi::node_element) {
      for_each_element(child, visit);
      visit(child);
    } else if (child.type() == pugi::node_pcdata &&
               std::string_view(child.value()).find_first_not_of(" \t\r\n") == std::string_view::npos) {
      node.remove_child(child);
    }
    child = next;
  }
}

std::string attributes_of(const pugi::xml_node& node) {
  std::string text;
  for (const pugi::xml_attribute& attribute : node.attributes())
    text += std::string(attribute.name()) + '=' + attribute.value() + '\n';
  return text;
}

/// gnuplot opens a group for each symbol: neighbours that say the same become one, which halves a figure of points.
void join_groups(pugi::xml_node node) {
  for (pugi::xml_node child = node.first_child(); child; child = child.next_sibling()) {
    join_groups(child);
    const auto joins = [](const pugi::xml_node& one) {
      return std::string_view(one.name()) == "g" && !one.attribute("id") && !one.child("title");
    };
    if (!joins(child)) continue;
    const std::string attributes = attributes_of(child);
    for (pugi::xml_node next = child.next_sibling(); joins(next) && attributes_of(next) == attributes;
         next = child.next_sibling()) {
      while (const pugi::xml_node moved = next.first_child()) child.append_move(moved);
      node.remove_child(next);
    }
  }
}

/// The hover text within gnuplot's call of its own script: showHypertext(evt,'TEXT').
std::string hover_text(std::string_view call) {
  const std::size_t begin = call.find("evt,'"), end = call.rfind("')");
  return begin == std::string_view::npos || end == std::string_view::npos || end < begin + 5
             ? std::string()
             : std::string(call.substr(begin + 5, end - begin - 5));
}

/// "rgb(  0, 114, 178)", "#0072b2" or "black" as "#0072b2"; empty if it is none.
std::string hexadecimal(const std::string& value) {
  if (value == "black") return "#000000";
  int r = 0, g = 0, b = 0;
  if (std::sscanf(value.c_str(), "rgb(%d,%d,%d)", &r, &g, &b) == 3) {
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", r & 255, g & 255, b & 255);
    return text;
  }
  return value.size() == 7 && value[0] == '#' ? value : std::string();
}

std::string themed(const std::string& value) {
  const std::string hex = hexadecimal(value);
  if (hex == "#FFFFFF" || hex == "#ffffff") return "var(--paper)";
  if (hex == "#000000") return "var(--ink)";
  for (std::size_t i = 0; i < kColors; ++i)
    if (hex == color(i)) return "var(--color-" + std::to_string(i) + ")";
  return value;
}

}  // namespace

std::string readable_svg(const std::string& text, const Figure& figure) {
  pugi::xml_document document = parsed(text);
  pugi::xml_node svg = document.child("svg");
  svg.remove_child("title");
  svg.remove_child("desc");
  const std::string prefix = figure.name + "-";
  for_each_element(svg, [&](pugi::xml_node node) {
    if (const pugi::xml_attribute call = node.attribute("onmousemove")) {
      const std::string hover = hover_text(call.value());
      for (const char* handler : {"onmousemove", "onmouseout", "onclick"}) node.remove_attribute(handler);
      node.child("title").text().set(hover.c_str());
    } else if (const pugi::xml_node title = node.child("title")) {
      node.remove_child(title);  // the name of a plot, on all of its line
    }
    if (pugi::xml_attribute id = node.attribute("id")) id.set_value((prefix + id.value()).c_str());
    for (const char* name : {"xlink:href", "clip-path"})
      if (pugi::xml_attribute reference = node.attribute(name)) {
        std::string target = reference.value();
        if (const std::size_t hash = target.find('#'); hash != std::string::npos) target.insert(hash + 1, prefix);
        reference.set_value(target.c_str());
      }
    if (std::string_view(node.name()) == "g" && !node.first_child()) node.parent().remove_child(node);
  });
  join_groups(svg);
  pugi::xml_node description = svg.prepend_child("desc");
  description.text().set(figure.caption.c_str());
  pugi::xml_node title = svg.prepend_child("title");
  title.text().set(figure.title.c_str());
  svg.append_attribute("role").set_value("img");
  svg.append_attribute("aria-label").set_value((figure.title + ". " + figure.caption).c_str());
  return "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n" + text_of(document) + "\n";
}

std::optional<Figure> kept_figure(const std::string& text) {
  pugi::xml_document document;
  if (!document.load_string(text.c_str()) || !document.child("svg")) return std::nullopt;
  pugi::xml_node svg = document.child("svg");
  Figure figure{"", svg.child("title").text().get(), {}, {}, {}};
  figure.caption = svg.child("desc").text().get();
  const auto clean = [](pugi::xml_node node) {
    const std::string_view name = node.name();
    if (name == "script" || name == "foreignObject" || name == "image" || name == "style" || name == "a") {
      node.parent().remove_child(node);
      return;
    }
    for (pugi::xml_attribute attribute = node.first_attribute(); attribute;) {
      const pugi::xml_attribute next = attribute.next_attribute();
      const std::string_view key = attribute.name(), value = attribute.value();
      if (key.starts_with("on") || (key.ends_with("href") && !value.starts_with("#"))) node.remove_attribute(attribute);
      attribute = next;
    }
  };
  for_each_element(svg, clean);
  clean(svg);
  for (const char* own : {"role", "aria-label"}) svg.remove_attribute(own);  // readable_svg gives them
  figure.drawn = text_of(document);
  return figure;
}

std::string inline_svg(const std::string& text) {
  pugi::xml_document document = parsed(text);
  pugi::xml_node svg = document.child("svg");
  for (pugi::xml_node child = document.first_child(); child;) {
    const pugi::xml_node next = child.next_sibling();
    if (child != svg) document.remove_child(child);
    child = next;
  }
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
  return text_of(document);
}

}  // namespace mixity
