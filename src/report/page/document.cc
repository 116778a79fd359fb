#include "report/page/document.h"

#include <map>
#include <sstream>

#include "report/figures/svg.h"
#include "report/fit_table.h"
#include "report/page/style.h"

namespace mixity {
namespace {

constexpr std::string_view kRawBegin = "<![CDATA[", kRawEnd = "]]>";

/// Adds markup that PageDocument::text does not escape. It must not contain kRawEnd.
void add_raw(pugi::xml_node node, const std::string& text) {
  node.append_child(pugi::node_cdata).set_value(text.c_str());
}

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
  add_raw(add(head, "style"), kPageStyle);
  body_ = add(html, "body");
}

/// HTML has no self-closing elements, and meta has no closing tag.
std::string PageDocument::text() const {
  std::ostringstream out;
  document_.save(out, "", pugi::format_raw | pugi::format_no_declaration | pugi::format_no_empty_element_tags);
  const std::string text = out.str();
  std::string page = "<!DOCTYPE html>\n";
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = std::min(text.find(kRawBegin, at), text.size());
    std::string part = text.substr(at, begin - at);
    for (std::size_t meta = 0; (meta = part.find("</meta>", meta)) != std::string::npos;) part.erase(meta, 7);
    page += part;
    if (begin == text.size()) break;
    const std::size_t end = text.find(kRawEnd, begin);
    page.append(text, begin + kRawBegin.size(), end - begin - kRawBegin.size());
    at = end + kRawEnd.size();
  }
  return page + '\n';
}

pugi::xml_node add(pugi::xml_node parent, const char* element, const std::string& text, const char* css_class) {
  pugi::xml_node node = parent.append_child(element);
  if (css_class) node.append_attribute("class").set_value(css_class);
  if (!text.empty()) node.text().set(text.c_str());
  return node;
}

void add_text(pugi::xml_node node, const std::string& text) {
  node.append_child(pugi::node_pcdata).set_value(text.c_str());
}

void add_link(pugi::xml_node node, const std::string& target, const std::string& text) {
  add(node, "a", text).append_attribute("href").set_value(target.c_str());
}

void add_list(pugi::xml_node parent, const std::vector<std::string>& items) {
  pugi::xml_node list = add(parent, "ul");
  for (const std::string& item : items) add(list, "li", item);
}

void add_definitions(pugi::xml_node parent, const std::vector<std::pair<std::string, std::string>>& items) {
  pugi::xml_node list = add(parent, "dl");
  for (const auto& [name, value] : items) {
    add(list, "dt", name);
    add(list, "dd", value);
  }
}

pugi::xml_node add_table(pugi::xml_node parent, const char* css_class, const std::vector<std::string>& headings,
                         const std::string& caption) {
  pugi::xml_node table = add(parent, "table", {}, css_class);
  if (!caption.empty()) add(table, "caption", caption);
  pugi::xml_node head = add(add(table, "thead"), "tr");
  for (const std::string& heading : headings)
    add(head, "th", with_powers(heading)).append_attribute("scope").set_value("col");
  return add(table, "tbody");
}

pugi::xml_node add_folded(pugi::xml_node parent, const std::string& title) {
  pugi::xml_node folded = add(parent, "details", {}, "part");
  add(folded, "summary", title);
  return folded;
}

pugi::xml_node add_figure(pugi::xml_node parent, const Figure& figure, const std::vector<std::string>& endings,
                          const std::string& folder, bool beside) {
  pugi::xml_node node = add(parent, "figure", {}, figure.wide && !beside ? "wide" : nullptr);
  const bool two = figure.wide && !beside;  // for screens and for phones
  add_raw(add(node, "div", {}, two ? "plot broad" : "plot"), svg(figure, Medium::page, beside));
  if (two) add_raw(add(node, "div", {}, "plot narrow"), svg(figure, Medium::page, true));
  pugi::xml_node caption = add(node, "figcaption");
  add(caption, "strong", with_powers(figure.title) + ". ");
  add_text(caption, with_powers(figure.caption) + " ");
  pugi::xml_node files = add(caption, "span", {}, "files");
  static const std::map<std::string, const char*> kNames{
      {".svg", "SVG"}, {".pdf", "PDF"}, {".png", "PNG"}, {".dat", "data"}, {".gp", "script"}};
  for (const std::string& ending : endings) {
    add_link(files, folder + figure.name + ending, kNames.at(ending));
    add_text(files, " ");
  }
  return caption;
}

}  // namespace mixity
