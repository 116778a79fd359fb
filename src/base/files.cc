#include "base/files.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

#include "base/inputs.h"
#include "base/text.h"

namespace mixity {

std::string read_file(const std::string& path) {
  Inputs inputs;
  return inputs.read(path);
}

std::string plain_file_name(std::string_view name) {
  std::string result;
  while (!name.empty()) {
    const std::size_t length = character_length(name);
    const bool letter = length > 1 || std::isalnum(static_cast<unsigned char>(name[0])),
               sign = !result.empty() && std::string_view(" ._-+=,()").find(name[0]) != std::string_view::npos;
    result += length > 0 && (letter || sign) ? name.substr(0, length) : "_";
    name.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result;
}

std::optional<std::string> named_twice(const std::vector<std::string>& paths) {
  std::set<std::filesystem::path> seen;
  for (const std::string& path : paths) {
    std::error_code none;
    const auto place = std::filesystem::weakly_canonical(path, none);
    if (!seen.insert(std::filesystem::is_regular_file(place, none) ? place : std::filesystem::path(path)).second)
      return path;
  }
  return std::nullopt;
}

std::string relative_to(const std::string& from, const std::string& file) {
  std::error_code unread;
  // Links are not resolved: constants are read from the link's folder. The folder of `from` need not exist yet.
  const std::filesystem::path folder = std::filesystem::absolute(from).lexically_normal().parent_path(),
                              whole = std::filesystem::absolute(file).lexically_normal(),
                              relative = std::filesystem::weakly_canonical(folder, unread) == folder
                                             ? whole.lexically_proximate(folder)
                                             : whole;
  return (unread ? std::filesystem::absolute(file) : relative).string();
}

}  // namespace mixity
