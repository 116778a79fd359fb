#include "report/page/document.h"

#include <sstream>

#include "report/figures/svg.h"
#include "report/fit_table.h"
#include "report/page/html.h"
#include "report/page/style.h"

namespace mixity {
namespace {

constexpr char kStyleMark[] = "mixity-style";

}  // namespace

PageDocument::PageDocument(const std::string& title) {
  pugi::xml_node html = add(document_, "html");
  html.append_attribute("lang").set_value("en");
  pugi::xml_node head = add(html, "head");
  add(head, "meta").append_attribute("charset").set_value("utf-8");
  pugi::xml_node view = add(head, "meta");
  view.append_attribute("name").set_value("viewport");
  view.append_attribute("content").set_value("width=device-width, initial-scale=1");
  add(head, "title", title);
  add(head, "style").append_child(pugi::node_cdata).set_value(kStyleMark);
  body_ = add(html, "body");
}

/// HTML has no self-closing elements, but for meta it has no closing tag either; style is not escaped.
std::string PageDocument::text() const {
  std::ostringstream out;
  document_.save(out, "", pugi::format_raw | pugi::format_no_declaration | pugi::format_no_empty_element_tags);
  std::string page = out.str();
  const auto replace_all = [&](const std::string& old, const std::string& by) {
    for (std::size_t at = 0; (at = page.find(old, at)) != std::string::npos; at += by.size())
      page.replace(at, old.size(), by);
  };
  replace_all("</meta>", "");
  replace_all(std::string("<![CDATA[") + kStyleMark + "]]>", kPageStyle);
  return "<!DOCTYPE html>\n" + page + "\n";
}

pugi::xml_node add_figure(pugi::xml_node parent, const Figure& figure, const std::string& svg,
                          const std::string& narrow, const std::string& folder, bool beside) {
  pugi::xml_node node = add(parent, "figure", {}, figure.wide && !beside ? "wide" : nullptr);
  const auto plot = [&](const std::string& text, const char* css_class) {
    pugi::xml_document drawn;
    drawn.load_string(inline_svg(text).c_str());
    add(node, "div", {}, css_class).append_copy(drawn.document_element());
  };
  if (svg.empty()) add(node, "p", "Not drawn.", "soft");
  const bool one = beside || narrow.empty();  // for screens of any width
  if (!svg.empty()) plot(beside && !narrow.empty() ? narrow : svg, one ? "plot" : "plot broad");
  if (!one) plot(narrow, "plot narrow");
  pugi::xml_node caption = add(node, "figcaption");
  add(caption, "strong", with_powers(figure.title) + ". ");
  add_text(caption, with_powers(figure.caption) + " ");
  pugi::xml_node files = add(caption, "span", {}, "files");
  const auto link = [&](const char* ending, const char* text) {
    add_link(files, folder + figure.name + ending, text);
    add_text(files, " ");
  };
  if (!svg.empty()) link(".svg", "SVG");
  if (!figure.drawn.empty()) return caption;
  if (!svg.empty()) {
    link(".pdf", "PDF");
    link(".png", "PNG");
  }
  link(".dat", "data");
  link(".gp", "script");
  return caption;
}

}  // namespace mixity
