// Outputs that the documents show, compared with what the program prints.
#pragma once

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "cli/run_program.h"

namespace mixity::cli {

/// From this heading of a document to the next heading of second level.
inline std::string section_of(const std::string& document, const std::string& heading) {
  const std::string text = content_of(MIXITY_ROOT "/" + document);
  const std::size_t begin = text.find(heading + "\n");
  EXPECT_NE(begin, std::string::npos) << heading;
  return begin == std::string::npos ? "" : text.substr(begin, text.find("\n## ", begin) - begin);
}

/// Checks that each line that is indented by four spaces, up to "..." at its end, is printed; the number of these lines.
/// Lines that begin with a command are not counted.
inline int count_of_shown_lines(const std::string& section, const std::string& printed) {
  std::istringstream lines(section);
  int shown = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("    ") || line.starts_with("    mixity ")) continue;
    if (line.ends_with("...")) line.resize(line.size() - 3);
    line.erase(0, 4);
    EXPECT_NE(printed.find(line), std::string::npos) << line;
    ++shown;
  }
  return shown;
}

}  // namespace mixity::cli
