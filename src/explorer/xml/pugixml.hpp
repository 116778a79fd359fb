// What dataset/table uses of pugixml, by Boost.PropertyTree: Debian has pugixml compiled for its own machines alone,
// and Boost as headers. The table room of the explorer's build finds this file in place of pugixml's.
#pragma once

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mixity::explorer::xml {

using Tree = boost::property_tree::ptree;
using Entry = Tree::value_type;  // name and content

enum : unsigned { parse_default = 0, parse_ws_pcdata = 0, encoding_utf8 = 0 };

class xml_attribute {
 public:
  xml_attribute() = default;
  explicit xml_attribute(const Entry& entry) : entry_(&entry) {}
  const char* name() const { return entry_ ? entry_->first.c_str() : ""; }
  const char* value() const { return as_string(); }
  const char* as_string(const char* otherwise = "") const { return entry_ ? entry_->second.data().c_str() : otherwise; }
  bool as_bool() const { return std::string_view("1tTyY").find(*value()) != std::string_view::npos && *value() != 0; }
  unsigned as_uint(unsigned otherwise = 0) const {
    return entry_ ? static_cast<unsigned>(std::strtoul(value(), nullptr, 10)) : otherwise;
  }

 private:
  const Entry* entry_ = nullptr;
};

/// A node without an entry has no name, text and children.
class xml_node {
 public:
  xml_node() = default;
  explicit xml_node(const Entry& entry) : entry_(&entry) {}

  explicit operator bool() const { return entry_; }
  const char* name() const { return entry_ ? entry_->first.c_str() : ""; }
  const char* child_value() const { return entry_ ? entry_->second.data().c_str() : ""; }
  std::vector<xml_node> children() const {
    std::vector<xml_node> list;
    if (entry_)
      for (const Entry& one : entry_->second)
        if (!one.first.starts_with('<')) list.emplace_back(one);  // attributes and comments have such names
    return list;
  }
  std::vector<xml_attribute> attributes() const {
    std::vector<xml_attribute> list;
    if (const auto stated = entry_ ? entry_->second.get_child_optional("<xmlattr>") : boost::none)
      for (const Entry& one : *stated) list.emplace_back(one);
    return list;
  }
  xml_attribute attribute(std::string_view name) const {
    for (const xml_attribute one : attributes())
      if (one.name() == name) return one;
    return {};
  }
  xml_node find_child(const auto& fits) const {
    for (const xml_node one : children())
      if (fits(one)) return one;
    return {};
  }
  xml_node first_child() const {
    return find_child([](const xml_node&) { return true; });
  }
  xml_node document_element() const { return first_child(); }

 private:
  const Entry* entry_ = nullptr;
};

/// The text as Boost reads it as pugixml does: with line ends of one character, as XML asks for, and a reference for a
/// blank that is all that an element contains, which Boost would skip.
inline std::string prepared(std::string text) {
  for (std::size_t at = text.find('\r'); at != std::string::npos; at = text.find('\r', at))
    text.replace(at, text[at + 1] == '\n' ? 2 : 1, 1, '\n');
  constexpr std::string_view kBlanks = " \t\n";
  for (std::size_t at = text.find("</"); at != std::string::npos; at = text.find("</", at + 2)) {
    const std::size_t last = at == 0 ? std::string::npos : text.find_last_not_of(kBlanks, at - 1);
    if (last == std::string::npos || last + 1 == at || text[last] != '>') continue;
    const std::size_t tag = text.rfind('<', last);
    if (tag == std::string::npos || text[tag + 1] == '/' || text[last - 1] == '/') continue;
    const std::string reference = "&#" + std::to_string(static_cast<int>(text[last + 1])) + ";";
    text.replace(last + 1, 1, reference);
    at += reference.size() - 1;
  }
  return text;
}

class xml_document : public xml_node {
 public:
  xml_document() : xml_node(entry_) {}
  xml_document(const xml_document&) = delete;
  xml_document& operator=(const xml_document&) = delete;

  /// False for what is no XML.
  bool load_buffer(const char* text, std::size_t size, unsigned = parse_default, unsigned = encoding_utf8) {
    std::istringstream in(prepared(std::string(text, size)));
    try {
      boost::property_tree::read_xml(in, entry_.second);
    } catch (const boost::property_tree::xml_parser_error&) {
      return false;
    }
    return !children().empty();
  }

 private:
  Entry entry_{};
};

}  // namespace mixity::explorer::xml

namespace pugi = mixity::explorer::xml;
