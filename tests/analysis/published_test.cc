// The regression tests against published values, made from fits/*.toml: whoever adds a definition adds a test, and
// whoever replaces reconstructed points by digitised ones is judged by the same numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "analysis/fit_definition.h"
#include "analysis/judgement.h"
#include "analysis/run.h"

namespace mixity {
namespace published_test {

std::vector<std::string> definitions() {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(MIXITY_ROOT "/fits"))
    if (entry.path().extension() == ".toml") paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// Measured data that no law describes within the stated errors: their fits say so.
const std::set<std::string> kUndescribed{"im7_8552_mmb", "snow_weak_layers_manual", "snow_weak_layers_video"};

class Published : public ::testing::TestWithParam<std::string> {};

TEST_P(Published, ValuesAreFoundAgain) {
  const Analysis result = run(read_fit_definition(GetParam()));
  std::size_t compared = 0;
  // of mergel2018, models a and b are left far behind by c
  EXPECT_EQ(can_be_believed(result), !kUndescribed.contains(std::filesystem::path(GetParam()).stem().string()));
  for (const FitResult& fit : result.fits) {
    for (const Agreement& agreement : compare(fit, result.request)) {
      ++compared;
      EXPECT_TRUE(agreement.agrees) << "model " << fit.model << ": published " << agreement.published.name << " = "
                                    << agreement.published.value << " +- " << agreement.published.tolerance;
    }
  }
  std::size_t stated = 0;
  for (const auto& [model, numbers] : result.request.published) stated += numbers.size();
  EXPECT_EQ(compared, stated) << "a published number belongs to a model that the definition does not fit";
}

INSTANTIATE_TEST_SUITE_P(Fits, Published, ::testing::ValuesIn(definitions()),
                         [](const auto& test) { return std::filesystem::path(test.param).stem().string(); });

TEST(Published, EveryShippedDataSetHasADefinition) {
  for (const auto& entry : std::filesystem::directory_iterator(MIXITY_ROOT "/data"))
    if (entry.path().extension() == ".csv" && entry.path().stem() != "shear_log") {  // of which `runs` makes one
      EXPECT_TRUE(std::filesystem::exists(std::string(MIXITY_ROOT "/fits/") + entry.path().stem().string() + ".toml"));
    }
}

}  // namespace published_test
}  // namespace mixity
