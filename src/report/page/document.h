// What every page is made of: elements, a document with the style in it, and a figure with its caption and files.
#pragma once

#include <pugixml.hpp>
#include <string>
#include <utility>
#include <vector>

#include "report/figures/figure.h"

namespace mixity {

/// An HTML page of one file, with an empty body to fill.
class PageDocument {
 public:
  explicit PageDocument(const std::string& title);
  pugi::xml_node body() { return body_; }
  std::string text() const;

 private:
  pugi::xml_document document_;
  pugi::xml_node body_;
};

pugi::xml_node add(pugi::xml_node parent, const char* element, const std::string& text = {},
                   const char* css_class = nullptr);
/// Appends text after what is already in the node.
void add_text(pugi::xml_node node, const std::string& text);
void add_link(pugi::xml_node node, const std::string& target, const std::string& text);
void add_list(pugi::xml_node parent, const std::vector<std::string>& items);
/// Names and values.
void add_definitions(pugi::xml_node parent, const std::vector<std::pair<std::string, std::string>>& items);
/// A table with these headings of its columns, in the order of the rows' cells. Returns its empty body.
pugi::xml_node add_table(pugi::xml_node parent, const char* css_class, const std::vector<std::string>& headings,
                         const std::string& caption = {});
/// A section that a reader opens.
pugi::xml_node add_folded(pugi::xml_node parent, const std::string& title);

/// A figure with its caption and links to its files, which have these endings and lie in `folder` ("figures/" or "").
/// A wide one has a second drawing for phones. `beside`: beside text, where it is never wide. Returns the caption.
pugi::xml_node add_figure(pugi::xml_node parent, const Figure& figure, const std::vector<std::string>& endings,
                          const std::string& folder, bool beside = false);

}  // namespace mixity
