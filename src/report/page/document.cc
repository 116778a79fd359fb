#include "report/page/document.h"

#include <map>

#include "report/figures/drawn_figures.h"
#include "report/figures/layout.h"
#include "report/figures/svg.h"
#include "report/figures/svg_text.h"
#include "report/page/sentence.h"
#include "report/page/style.h"

namespace mixity {

std::string element(const char* name, const std::string& content, const Attributes& attributes) {
  std::string tag = name;
  for (const auto& [key, value] : attributes) tag += std::string(" ") + key + "=\"" + xml_escaped(value) + '"';
  return "<" + tag + ">" + content + "</" + name + ">";
}

std::string text_element(const char* name, const std::string& text, const char* css_class) {
  return element(name, xml_escaped(text), css_class ? Attributes{{"class", css_class}} : Attributes{});
}

std::string link_to(const std::string& target, const std::string& text) {
  return element("a", xml_escaped(text), {{"href", target}});
}

std::string list_of(const std::vector<std::string>& items) {
  std::string content;
  for (const std::string& item : items) content += element("li", sentence(item));
  return element("ul", content);
}

std::string definitions_of(const std::vector<std::pair<std::string, std::string>>& items) {
  std::string content;
  for (const auto& [name, value] : items) content += element("dt", sentence(name)) + element("dd", sentence(value));
  return element("dl", content);
}

std::string table_of(const char* css_class, const std::vector<std::string>& headings, const std::string& rows,
                     const std::string& caption) {
  std::string head;
  for (const std::string& heading : headings) head += element("th", sentence(heading), {{"scope", "col"}});
  return element("table",
                 (caption.empty() ? "" : text_element("caption", caption)) + element("thead", element("tr", head)) +
                     element("tbody", rows),
                 {{"class", css_class}});
}

std::string table_of_cells(const FitTable& table, const std::vector<std::string>& targets) {
  std::string rows;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto& row = table.rows[i];
    std::string cells;
    for (std::size_t column = 0; column < row.size(); ++column) {
      Attributes attributes;
      if (row[column].alert) attributes.emplace_back("class", "alert");
      if (column == 0) attributes.emplace_back("scope", "row");
      if (!row[column].lines.empty()) attributes.emplace_back("data-label", table.headings[column]);
      std::string lines;
      for (const std::string& line : row[column].lines)
        lines += element("div",
                         column == 0 && lines.empty() && !targets.empty() ? link_to(targets[i], line) : sentence(line));
      cells += element(column == 0 ? "th" : "td", lines, attributes);
    }
    rows += element("tr", cells);
  }
  return table_of("fits", table.headings, rows);
}

std::string folded_section(const std::string& title, const std::string& content) {
  return element("details", text_element("summary", title) + content, {{"class", "part"}});
}

namespace {

/// Refers to the figure's file, which opens alone with tooltips of its points. It is loaded when it comes into view.
std::string shown_file(const Figure& figure, const std::string& file, bool narrow) {
  std::string size;  // kept drawings state theirs
  if (figure.drawn.empty()) {
    const Layout layout = lay_out(figure, narrow);
    size = " width=\"" + std::to_string(layout.width) + "\" height=\"" + std::to_string(layout.height) + '"';
  }
  return element("a",
                 "<img loading=\"lazy\" src=\"" + xml_escaped(file) + "\" alt=\"" +
                     xml_escaped(with_powers(figure.title)) + '"' + size + "/>",
                 {{"href", file}});
}

std::string drawing(const Figure& figure, const FigurePlace& place, bool narrow) {
  const bool apart = narrow && figure.wide;
  return place.in_file ? shown_file(figure, place.folder + (apart ? narrow_file(figure) : figure.name + ".svg"), narrow)
                       : svg(figure, Medium::page, narrow);
}

}  // namespace

std::string figure_element(const Figure& figure, const std::vector<std::string>& endings, const FigurePlace& place,
                           const std::string& notes) {
  static const std::map<std::string, const char*> kNames{
      {".svg", "SVG"}, {".pdf", "PDF"}, {".png", "PNG"}, {".dat", "data"}, {".gp", "script"}};
  const bool two = figure.wide && !place.beside_text;  // for screens and for phones
  std::string content =
      element("div", drawing(figure, place, place.beside_text), {{"class", two ? "plot broad" : "plot"}});
  if (two) content += element("div", drawing(figure, place, true), {{"class", "plot narrow"}});
  std::string files;
  for (const std::string& ending : endings)
    files += link_to(place.folder + figure.name + ending, kNames.at(ending)) + " ";
  content += element("figcaption", element("strong", sentence(figure.title) + ". ") + sentence(figure.caption) + " " +
                                       element("span", files, {{"class", "files"}}) + notes);
  std::string classes = two ? "wide" : "";
  if (!place.printed) classes += two ? " screen" : "screen";
  return element("figure", content, classes.empty() ? Attributes{} : Attributes{{"class", classes}});
}

std::string html_page(const std::string& title, const std::string& body, Images images) {
  // a page of text and drawings: no scripts run, and only drawings from its folder are loaded
  const std::string policy = std::string("default-src 'none'; ") +
                             (images == Images::of_files_beside ? "img-src 'self' file:; " : "") +
                             "style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'";
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"" +
         policy + "\">" + text_element("title", title) + element("style", kPageStyle) + "</head>" +
         element("body", body) + "</html>\n";
}

}  // namespace mixity
