#include "report/page/sentence.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "base/text.h"
#include "report/figures/svg_text.h"

namespace mixity {
namespace {

using Signs = std::pair<std::string_view, std::string_view>;

constexpr std::array kLetters{Signs{"lambda", "λ"}, Signs{"psi", "ψ"}, Signs{"delta", "δ"}, Signs{"alpha", "α"},
                              Signs{"tau", "τ"},    Signs{"nu", "ν"},  Signs{"eta", "η"},   Signs{"chi", "χ"}};
constexpr std::array kSubscripts{Signs{"Gc", "G_c"}, Signs{"GIc", "G_Ic"}};
constexpr std::array<std::string_view, 10> kBelow{"I", "II", "III", "c", "Ic", "IIc", "0", "A", "T", "u"};
constexpr std::array kOthers{Signs{"^2", "²"}, Signs{"^3", "³"}, Signs{"+/-", "±"}};

bool is_plain(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// The length of the word at the beginning: letters, Greek ones among them, digits and _.
std::size_t word_length(std::string_view text) {
  std::size_t length = 0;
  while (length < text.size()) {
    const bool greek = text[length] == '\xCE' || text[length] == '\xCF';
    if (!greek && !is_plain(text[length])) break;
    length += greek ? 2 : 1;
  }
  return std::min(length, text.size());
}

/// Whether a name of the data or an option has the word: --free=lambda, file.lambda.
bool is_typed(std::string_view before, std::string_view after) {
  const auto joins = [](char c) { return c == '=' || c == '.' || c == '\''; };
  return (!before.empty() && (joins(before.back()) || before.ends_with("--"))) ||
         (after.size() > 1 && joins(after[0]) && is_plain(after[1]));
}

/// The Greek letter of a name; else the name.
std::string_view letter(std::string_view name) {
  for (const auto& [plain, greek] : kLetters)
    if (name == plain) return greek;
  return name;
}

/// The word with Greek letters and its subscript: a symbol of one letter, and what stands behind _, or 0.
std::string with_signs(std::string_view word) {
  for (const auto& [plain, below] : kSubscripts)
    if (word == plain) word = below;
  const bool zero = word.size() > 1 && word.ends_with('0');
  const std::size_t cut = std::min(word.find('_'), zero ? word.size() - 1 : word.size());
  const std::string_view symbol = letter(word.substr(0, cut)),
                         below = word.substr(cut + (word.substr(cut).starts_with('_') ? 1 : 0));
  const bool one_letter = !std::isdigit(static_cast<unsigned char>(word[0])) &&
                          std::count_if(symbol.begin(), symbol.end(), [](char c) { return (c & 0xC0) != 0x80; }) == 1;
  if (cut == word.size()) return xml_escaped(symbol);
  // names of runs, as S_1 or tau_file, are no symbols
  const bool known = std::find(kBelow.begin(), kBelow.end(), below) != kBelow.end();
  return one_letter && known ? xml_escaped(symbol) + "<sub>" + xml_escaped(below) + "</sub>" : xml_escaped(word);
}

}  // namespace

std::string sentence(std::string_view text) {
  std::string out;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size();) {
    const std::string_view rest = text.substr(i);
    std::size_t length = word_length(rest);
    if (length > 0) {
      const bool kept = quoted || is_typed(text.substr(0, i), rest.substr(length));
      out += kept ? xml_escaped(rest.substr(0, length)) : with_signs(rest.substr(0, length));
    } else {
      const auto other = std::find_if(kOthers.begin(), kOthers.end(), [&](const Signs& one) {
        const std::string_view behind = rest.substr(std::min(one.first.size(), rest.size()));
        const bool number_goes_on = one.first[0] == '^' && !behind.empty() &&
                                    std::isdigit(static_cast<unsigned char>(behind[0])) != 0;  // 10^25
        return !quoted && !number_goes_on && rest.starts_with(one.first);
      });
      length = other != kOthers.end() ? other->first.size() : std::max<std::size_t>(character_length(rest), 1);
      out += other != kOthers.end() ? std::string(other->second) : xml_escaped(rest.substr(0, length));
      if (rest[0] == '"') quoted = !quoted;
    }
    i += length;
  }
  return out;
}

}  // namespace mixity
