// What every page is made of: a document with the style in it, and a figure with its caption and files.
#pragma once

#include <pugixml.hpp>
#include <string>

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

/// A figure as it was drawn, empty where it could not be, `narrow` for a phone where it is a wide one; its files lie
/// in `folder` ("figures/" or ""). `beside`: text, where it is never wide. Returns the caption's node.
pugi::xml_node add_figure(pugi::xml_node parent, const Figure& figure, const std::string& svg,
                          const std::string& narrow, const std::string& folder, bool beside = false);

}  // namespace mixity
