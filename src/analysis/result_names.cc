#include "analysis/result_names.h"

#include <filesystem>
#include <map>

#include "base/files.h"
#include "base/text.h"

namespace mixity {

void make_names_unique(std::vector<Analysis>& results) {
  const auto place = [](const Dataset& data) { return std::filesystem::absolute(data.path).lexically_normal(); };
  std::map<std::string, std::set<std::filesystem::path>> places;  // of the data sets with each name
  for (const Analysis& result : results) places[result.data.name].insert(place(result.data));
  for (Analysis& result : results) {
    if (places[result.data.name].size() == 1) continue;
    const std::string folder = printable(place(result.data).parent_path().filename().string(), std::string::npos);
    result.data.name = folder + '/' + result.data.name;
  }
}

std::string file_stem(const Analysis& result, std::set<std::string>& taken) {
  const std::string name = plain_file_name(result.data.name);
  std::string stem = name;
  for (int i = 2; !taken.insert(stem).second; ++i) stem = name + "-" + std::to_string(i);
  return stem;
}

}  // namespace mixity
