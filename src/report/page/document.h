// HTML as text: elements, lists, tables, figures, and a page with its style in it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "report/figures/figure.h"

namespace mixity {

using Attributes = std::vector<std::pair<const char*, std::string>>;

/// <name attributes>content</name>. `content` is markup, the values of attributes are text.
std::string element(const char* name, const std::string& content, const Attributes& attributes = {});
/// The same with a text, which is escaped.
std::string text_element(const char* name, const std::string& text, const char* css_class = nullptr);
std::string link_to(const std::string& target, const std::string& text);
/// Of texts.
std::string list_of(const std::vector<std::string>& items);
/// Of names and values.
std::string definitions_of(const std::vector<std::pair<std::string, std::string>>& items);
/// `rows`: markup, each with as many cells as there are headings.
std::string table_of(const char* css_class, const std::vector<std::string>& headings, const std::string& rows,
                     const std::string& caption = {});
/// A section that a reader opens.
std::string folded_section(const std::string& title, const std::string& content);

struct FigurePlace {
  std::string folder;        // of the figure's files: "figures/" or ""
  bool beside_text = false;  // where it is never wide
  bool in_file = false;      // the page shows the figure's file and does not hold the drawing
};

/// A figure with its caption and links to its files, which have these endings. A wide one has a second drawing for
/// phones. `notes`: markup below the caption.
std::string figure_element(const Figure& figure, const std::vector<std::string>& endings, const FigurePlace& place,
                           const std::string& notes = {});

/// What a page may load; nothing else, and it runs nothing.
enum class Images { none, of_files_beside };

/// A page. `body`: markup.
std::string html_page(const std::string& title, const std::string& body, Images images = Images::none);

}  // namespace mixity
