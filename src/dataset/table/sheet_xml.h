// The XML of workbooks, by pugixml. Names are compared without their prefixes, which differ between writers.
#pragma once

#include <functional>
#include <initializer_list>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "dataset/table/archive.h"

namespace mixity {

/// A name without its prefix: "row" of "x:row".
std::string_view local_name(std::string_view name);

/// The first child of this name; null if there is none.
pugi::xml_node child_of(pugi::xml_node parent, std::string_view name);

/// The text of a string: its `t`, or those of its runs in different fonts, without the readings of Japanese texts.
std::string text_of(pugi::xml_node string);

/// Reads a part as a whole. Throws InputError if it is not XML.
void read_xml(const Archive& archive, const std::string& part, pugi::xml_document& document);

/// Calls use(element) for each element of these names in a part, until it returns false. Holds one element at a time.
void for_each_element(const Archive& archive, const std::string& part, std::initializer_list<std::string_view> names,
                      const std::function<bool(pugi::xml_node)>& use);

}  // namespace mixity
