#include "dataset/table/sheet_xml.h"

#include <algorithm>
#include <charconv>

#include "base/input_error.h"
#include "base/text.h"

namespace mixity {
namespace {

constexpr unsigned kParsed = pugi::parse_default | pugi::parse_ws_pcdata;  // a run of a text may be one blank

[[noreturn]] void fail(const Archive& archive, const std::string& part) {
  throw InputError(archive.path(), "is damaged: its part '" + printable(part, 60) + "' is not whole; save it again");
}

/// Where the next of these elements lies in a text.
struct Extent {
  std::size_t begin = 0, end = 0;
  bool whole = false;
};

/// From `at` on. Not whole: it extends beyond the text; or, if it begins at the end, there is none.
Extent next_element(std::string_view text, std::size_t at, std::initializer_list<std::string_view> names) {
  for (;;) {
    const std::size_t begin = text.find('<', at), behind = text.find_first_of(" \t\r\n/>", begin + 1);
    if (begin == std::string_view::npos) return {text.size(), 0, false};
    const std::size_t closed = text.find('>', begin);
    if (behind == std::string_view::npos || closed == std::string_view::npos) return {begin, 0, false};
    const std::string_view name = text.substr(begin + 1, behind - begin - 1);
    at = behind;
    if (std::find(names.begin(), names.end(), local_name(name)) == names.end()) continue;
    if (text[closed - 1] == '/') return {begin, closed + 1, true};
    const std::size_t end_tag = text.find("</" + std::string(name) + ">", closed);
    if (end_tag == std::string_view::npos) return {begin, 0, false};
    return {begin, end_tag + name.size() + 3, true};
  }
}

/// Writers state characters that XML does not allow, and line ends, as "_x000D_".
std::string without_escapes(std::string text) {
  for (std::size_t at = text.find("_x"); at != std::string::npos; at = text.find("_x", at + 1)) {
    unsigned code = 0;
    const char *const begin = text.data() + at + 2, *const end = begin + 4;
    if (text.size() < at + 7 || text[at + 6] != '_' || std::from_chars(begin, end, code, 16).ptr != end) continue;
    if (code < 0x80) text.replace(at, 7, 1, static_cast<char>(code));
  }
  return text;
}

}  // namespace

std::string_view local_name(std::string_view name) { return name.substr(name.find(':') + 1); }

pugi::xml_node child_of(pugi::xml_node parent, std::string_view name) {
  return parent.find_child([&](const pugi::xml_node& child) { return local_name(child.name()) == name; });
}

std::string text_of(pugi::xml_node string) {
  std::string text;
  for (const pugi::xml_node child : string.children()) {
    if (local_name(child.name()) == "t") text += child.child_value();
    if (local_name(child.name()) == "r") text += child_of(child, "t").child_value();
  }
  return without_escapes(std::move(text));
}

void read_xml(const Archive& archive, const std::string& part, pugi::xml_document& document) {
  const std::string text = archive.read(part);
  if (!document.load_buffer(text.data(), text.size())) fail(archive, part);
}

void for_each_element(const Archive& archive, const std::string& part, std::initializer_list<std::string_view> names,
                      const std::function<bool(pugi::xml_node)>& use) {
  constexpr std::size_t kMostElement = std::size_t{1} << 26;  // bytes
  std::string text;
  std::size_t at = 0;
  bool more = true;
  archive.read(part, [&](std::string_view piece) {
    text.erase(0, at);
    text += piece;
    at = 0;
    while (more) {
      const Extent next = next_element(text, at, names);
      at = next.begin;
      if (!next.whole) break;
      pugi::xml_document fragment;
      if (!fragment.load_buffer(text.data() + next.begin, next.end - next.begin, kParsed, pugi::encoding_utf8))
        fail(archive, part);
      at = next.end;
      more = use(fragment.first_child());
    }
    if (text.size() - at > kMostElement) fail(archive, part);
    return more;
  });
  if (more && at < text.size()) fail(archive, part);
}

}  // namespace mixity
