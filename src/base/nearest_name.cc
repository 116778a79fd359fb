#include "base/nearest_name.h"

#include <algorithm>

#include "base/phrases.h"

namespace mixity {
namespace {

std::string plain_letters(std::string_view name) {
  std::string letters;
  for (const char c : name)
    if (c != '-' && c != '_') letters += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return letters;
}

/// Damerau-Levenshtein distance, in which no letter is edited twice.
std::size_t edits(std::string_view one, std::string_view other) {
  // rows of the table of distances between the beginnings of both texts
  std::vector<std::size_t> before_last(other.size() + 1), last(before_last), row(before_last);
  for (std::size_t j = 0; j <= other.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= one.size(); ++i) {
    before_last.swap(last);
    last.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= other.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (one[i - 1] != other[j - 1])});
      if (i > 1 && j > 1 && one[i - 1] == other[j - 2] && one[i - 2] == other[j - 1])
        row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row[other.size()];
}

}  // namespace

std::optional<std::string> nearest_name(std::string_view given, const std::vector<std::string>& names,
                                        std::size_t most) {
  const std::string letters = plain_letters(given);
  std::optional<std::string> nearest;
  std::size_t least = most + 1;
  for (const std::string& name : names) {
    if (name == given) return std::nullopt;
    const std::string other = plain_letters(name);
    const std::size_t longer = std::max(letters.size(), other.size());
    const std::size_t limit = std::clamp<std::size_t>(other.size() / 3, 1, most);
    if (longer > std::min(letters.size(), other.size()) + limit) continue;  // a long text is not compared
    const std::size_t distance = edits(letters, other);
    if (distance > std::min(limit, least) || distance >= longer) continue;
    nearest = distance < least || nearest == name ? std::optional(name) : std::nullopt;  // a name given twice is no tie
    least = distance;
  }
  return nearest;
}

std::string did_you_mean(std::string_view given, const std::vector<std::string>& names) {
  const auto nearest = nearest_name(given, names);
  return nearest ? ": did you mean " + *nearest + "?" : "";
}

std::string known_names(std::string_view given, const std::vector<std::string>& names, std::string_view more) {
  return did_you_mean(given, names) + " (known: " + joined(names) + (more.empty() ? "" : ", ") + std::string(more) +
         ")";
}

std::string unknown_key(std::string_view key, const std::vector<std::string>& names) {
  return "unknown key \"" + std::string(key) + "\"" + known_names(key, names);
}

}  // namespace mixity
