#include "dataset/table/heading.h"

#include <utf8proc.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <iterator>
#include <memory>
#include <vector>

#include "base/text.h"
#include "dataset/table/number.h"

namespace mixity {

std::string_view trim_name(std::string_view text) {
  for (std::size_t before = text.size() + 1; text.size() < before;) {
    before = text.size();
    text = trim(text);
    for (const std::string_view unseen : {"\xC2\xA0", "\xE2\x80\xAF", "\xE2\x80\x8B", "\xEF\xBB\xBF"}) {
      if (text.starts_with(unseen)) text.remove_prefix(unseen.size());
      if (text.ends_with(unseen)) text.remove_suffix(unseen.size());
    }
  }
  return text;
}

namespace {

/// "$F_\mathrm{N}$ ($\mu$m$^{2}$)" without the signs and commands of TeX: "F_N (µm^2)".
std::string without_tex(std::string_view text) {
  std::string plain;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '\\' && at + 1 < text.size()) {
      std::size_t end = at + 1;
      while (end < text.size() && std::isalpha(static_cast<unsigned char>(text[end]))) ++end;
      const std::string_view command = text.substr(at + 1, end - at - 1);
      const bool micro = command == "mu" || command == "upmu" || command == "textmu";
      const bool style = command.starts_with("math") || command.starts_with("text") || command == "rm" ||
                         command == "left" || command == "right";
      const bool space = command.empty() && std::string_view(",;:!").find(text[at + 1]) != std::string_view::npos;
      if (micro) plain += "µ";
      if (micro || style || space) {
        at = space ? at + 1 : end - 1;
        if (!space && end < text.size() && text[end] == ' ') ++at;  // which ends the command
        continue;
      }
    }
    if (text[at] != '$' && text[at] != '{' && text[at] != '}') plain += text[at];
  }
  return plain;
}

}  // namespace

Heading split_heading(std::string_view whole, FilePlace place) {
  const std::string written(trim_name(whole)), plain = without_tex(written);
  Heading heading{written, {}, {}, true, place};
  const std::string_view text = trim_name(plain);
  heading.name = text;
  const std::size_t open = text.find_first_of("[(");
  if (open == std::string_view::npos) return heading;
  heading.name = trim_name(text.substr(0, open));
  // "P (load) [mN]": the last brackets contain the unit
  const std::size_t last = text.back() == ']'   ? text.rfind('[')
                           : text.back() == ')' ? text.rfind('(')
                                                : std::string_view::npos;
  heading.closed = last != std::string_view::npos;
  const std::size_t unit = (heading.closed ? last : open) + 1;
  heading.unit = trim_name(text.substr(unit, text.size() - unit - (heading.closed ? 1 : 0)));
  return heading;
}

std::vector<Heading> headings_of(const CsvRow& header) {
  std::vector<Heading> headings;
  const std::vector<FilePlace> places = header.places();
  for (std::size_t i = 0; i < header.size(); ++i) headings.push_back(split_heading(header[i], places[i]));
  return headings;
}

std::string folded(std::string_view name) {
  std::string kept;
  if (std::all_of(name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; })) {
    for (const char c : name)
      if (const char lower = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
          is_digit(lower) || (lower >= 'a' && lower <= 'z'))
        kept += lower;
    return kept;
  }
  utf8proc_uint8_t* mapped = nullptr;
  const auto size = utf8proc_map(
      reinterpret_cast<const utf8proc_uint8_t*>(name.data()), static_cast<utf8proc_ssize_t>(name.size()), &mapped,
      static_cast<utf8proc_option_t>(UTF8PROC_DECOMPOSE | UTF8PROC_COMPAT | UTF8PROC_CASEFOLD | UTF8PROC_STRIPMARK));
  if (size < 0) return {};
  const std::unique_ptr<utf8proc_uint8_t, void (*)(void*)> owned(mapped, std::free);
  for (utf8proc_ssize_t at = 0; at < size;) {
    utf8proc_int32_t character = 0;
    const auto length = utf8proc_iterate(mapped + at, size - at, &character);
    if (length <= 0) return {};
    const auto category = utf8proc_category(character);
    const bool letter = category >= UTF8PROC_CATEGORY_LU && category <= UTF8PROC_CATEGORY_LO;
    if (letter || category == UTF8PROC_CATEGORY_ND)
      kept.append(reinterpret_cast<const char*>(mapped + at), static_cast<std::size_t>(length));
    at += length;
  }
  return kept;
}

std::string letters_of(std::string_view name) {
  std::string letters = folded(name);
  std::erase_if(letters, is_digit);
  return letters;
}

std::string sorted_words(std::string_view name) {
  constexpr std::string_view kSkipped[] = {"of", "the", "a",   "de",    "du",  "des", "la",  "le", "l",
                                           "d",  "di",  "del", "della", "der", "die", "das", "el"};
  std::vector<std::string> words;
  while (!name.empty()) {
    const std::size_t end = std::min(name.find_first_of(" _-'./"), name.size());
    std::string word = folded(name.substr(0, end));
    if (!word.empty() && std::find(std::begin(kSkipped), std::end(kSkipped), word) == std::end(kSkipped))
      words.push_back(std::move(word));
    name.remove_prefix(std::min(end + 1, name.size()));
  }
  std::sort(words.begin(), words.end());
  words.erase(std::unique(words.begin(), words.end()), words.end());
  std::string joined;
  for (const std::string& word : words) joined += (joined.empty() ? "" : " ") + word;
  return joined;
}

std::string_view without_brackets(std::string_view text) {
  text = trim_name(text);
  if (text.size() >= 2 && ((text.front() == '[' && text.back() == ']') || (text.front() == '(' && text.back() == ')')))
    return trim_name(text.substr(1, text.size() - 2));
  return text;
}

}  // namespace mixity
