#include "dataset/table/runs_beside.h"

#include <algorithm>
#include <set>

#include "base/text.h"

namespace mixity {

std::size_t width_of_runs(const std::vector<Heading>& headings) {
  constexpr std::size_t kFewest = 2;  // columns of a run
  const std::size_t n = headings.size();
  const auto same = [&](std::size_t i, std::size_t width) {  // as in the run before
    const std::size_t before = i - width;
    return i < n ? headings[i].text == headings[before].text : headings[before].text.empty();
  };
  for (std::size_t width = kFewest; width < n; ++width) {
    const std::size_t end = (n + width - 1) / width * width;  // empty headings at the end of the line are not there
    std::size_t i = width, named = 0;
    while (i < end && same(i, width)) ++i;
    for (std::size_t k = 0; k < width; ++k) named += !headings[k].text.empty();
    if (end > width && i == end && named >= kFewest) return width;
  }
  return 0;
}

std::vector<std::string> names_of_runs(const std::vector<CsvRow>& lines, std::size_t headings, std::size_t width,
                                       std::size_t count) {
  constexpr std::size_t kAbove = 4, kLongest = 60;  // lines; bytes of a name
  for (std::size_t k = headings; k-- > headings - std::min(headings, kAbove);) {
    std::vector<std::string> names;
    for (std::size_t run = 0; run < count; ++run) {
      std::string name;
      for (std::size_t i = run * width; i < std::min((run + 1) * width, lines[k].size()); ++i)
        if (!lines[k][i].empty()) name += (name.empty() ? "" : " ") + std::string(lines[k][i]);
      if (!name.empty()) names.push_back(printable(name, kLongest));
    }
    if (names.size() == count && std::set<std::string>(names.begin(), names.end()).size() == count) return names;
  }
  std::vector<std::string> numbers;
  for (std::size_t run = 0; run < count; ++run) numbers.push_back("run " + std::to_string(run + 1));
  return numbers;
}

}  // namespace mixity
