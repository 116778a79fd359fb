// HTML as a tree of elements.
#pragma once

#include <pugixml.hpp>
#include <string>
#include <vector>

namespace mixity {

inline pugi::xml_node add(pugi::xml_node parent, const char* element, const std::string& text = {},
                          const char* css_class = nullptr) {
  pugi::xml_node node = parent.append_child(element);
  if (css_class) node.append_attribute("class").set_value(css_class);
  if (!text.empty()) node.text().set(text.c_str());
  return node;
}

/// Appends text after what is already in the node.
inline void add_text(pugi::xml_node node, const std::string& text) {
  node.append_child(pugi::node_pcdata).set_value(text.c_str());
}

inline void add_link(pugi::xml_node node, const std::string& target, const std::string& text) {
  add(node, "a", text).append_attribute("href").set_value(target.c_str());
}

inline void add_list(pugi::xml_node parent, const std::vector<std::string>& items) {
  pugi::xml_node list = add(parent, "ul");
  for (const std::string& item : items) add(list, "li", item);
}

/// A section that a reader opens.
inline pugi::xml_node add_folded(pugi::xml_node parent, const std::string& title) {
  pugi::xml_node folded = add(parent, "details", {}, "part");
  add(folded, "summary", title);
  return folded;
}

}  // namespace mixity
