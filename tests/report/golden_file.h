// Text outputs kept as files in tests/report/golden; MIXITY_UPDATE_GOLDEN=1 writes them anew.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "base/files.h"
#include "cli/flag_words.h"
#include "report/fit_text.h"

namespace mixity {

inline void expect_text_of_file(const std::string& text, const std::string& name) {
  const std::string path = MIXITY_ROOT "/" + name;
  if (std::getenv("MIXITY_UPDATE_GOLDEN")) write_scratch_file(path, text);
  EXPECT_EQ(text, read_file(path)) << name;
}

inline void expect_golden_text(const std::string& text, const std::string& name) {
  expect_text_of_file(text, "tests/report/golden/" + name);
}

inline void expect_golden(const Analysis& result, const std::string& name) {
  Analysis said = result;
  said.request.words = cli::in_flags;
  expect_golden_text(to_text(said), name);
}

}  // namespace mixity
