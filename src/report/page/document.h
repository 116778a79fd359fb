// HTML as text: elements, lists, tables, figures, and a page with its style sheet included.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "report/figures/figure.h"
#include "report/fit_table.h"

namespace mixity {

using Attributes = std::vector<std::pair<const char*, std::string>>;

/// <name attributes>content</name>. `content` is markup; attribute values are text.
std::string element(const char* name, const std::string& content, const Attributes& attributes = {});
/// The same with text content, which is escaped.
std::string text_element(const char* name, const std::string& text, const char* css_class = nullptr);
std::string link_to(const std::string& target, const std::string& text);
/// A list of texts.
std::string list_of(const std::vector<std::string>& items);
/// A list of names and their values.
std::string definitions_of(const std::vector<std::pair<std::string, std::string>>& items);
/// `rows`: markup with as many cells in each row as there are headings.
std::string table_of(const char* css_class, const std::vector<std::string>& headings, const std::string& rows,
                     const std::string& caption = {});

/// The table of fits, or of data sets, that a phone shows as a list. `targets`: what the first line of each row links
/// to.
std::string table_of_cells(const FitTable& table, const std::vector<std::string>& targets = {});
/// A section that is folded until a reader opens it.
std::string folded_section(const std::string& title, const std::string& content);

struct FigurePlace {
  std::string folder;        // of the figure's files: "figures/" or ""
  bool beside_text = false;  // its width is limited
  bool in_file = false;      // the page refers to the figure's file instead of embedding the drawing
  bool printed = true;
};

/// A figure with its caption and links to its files with these extensions. A wide one has a second drawing for phones.
/// `notes`: markup below the caption.
std::string figure_element(const Figure& figure, const std::vector<std::string>& endings, const FigurePlace& place,
                           const std::string& notes = {});

/// The images that a page may load. It loads nothing else, and runs no scripts.
enum class Images { none, of_files_beside };

/// A page. `body`: markup.
std::string html_page(const std::string& title, const std::string& body, Images images = Images::none);

}  // namespace mixity
