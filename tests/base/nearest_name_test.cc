#include "base/nearest_name.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace mixity {
namespace nearest_name_test {

const std::vector<std::string> kNames{"radius", "modulus", "youngs_modulus", "toughness", "sigma_T", "fit", "check"};

TEST(NearestName, IsFoundForEachKindOfSlip) {
  for (const char* given : {"radus", "raddius", "rodius", "raduis", "radious"})
    EXPECT_EQ(nearest_name(given, kNames), "radius") << given;
  EXPECT_EQ(nearest_name("fitt", kNames), "fit");
  EXPECT_EQ(nearest_name("hceck", kNames), "check");
}

TEST(NearestName, IgnoresCaseHyphensAndUnderscores) {
  for (const char* given : {"sigmaT", "SIGMA-T", "Sigma_t"}) EXPECT_EQ(nearest_name(given, kNames), "sigma_T") << given;
  EXPECT_EQ(nearest_name("youngs-moduls", kNames), "youngs_modulus");
  EXPECT_EQ(nearest_name("C", {"a", "b", "c"}), "c");
}

TEST(NearestName, IsWithinAThirdOfTheGivenLetters) {
  const std::vector<std::string> names{"abcdefghijklmno"};
  EXPECT_EQ(nearest_name("abcdefghijkl", names), names[0]);     // 3 of 12 letters
  EXPECT_EQ(nearest_name("abcdefghijk", names), std::nullopt);  // 4 of 11: more than three edits
  EXPECT_EQ(nearest_name("abcdefghijklmnopqrs", names), std::nullopt);
  EXPECT_EQ(nearest_name("abxyef", {"abcdef"}), "abcdef");       // 2 of 6
  EXPECT_EQ(nearest_name("axydef", {"abcdefg"}), std::nullopt);  // 3 of 6
  EXPECT_EQ(nearest_name("ab", {"abc"}), "abc");                 // one edit is allowed for the shortest names
  EXPECT_EQ(nearest_name("ax", {"abc"}), std::nullopt);
  EXPECT_EQ(nearest_name("abxyef", {"abcdef"}, 1), std::nullopt);
}

TEST(NearestName, IsNoneWhereSeveralAreEquallyNear) {
  EXPECT_EQ(nearest_name("sigma_P", {"sigma_T", "sigma_A"}), std::nullopt);
  EXPECT_EQ(nearest_name("sigma_P", {"sigma_T", "sigma_A", "sigma_p"}), "sigma_p");
  EXPECT_EQ(nearest_name("sigma_P", {"sigma_p", "sigma_T", "sigma_A"}), "sigma_p");
}

TEST(NearestName, IsNoneWhereNothingOfTheGivenOneRemains) {
  EXPECT_EQ(nearest_name("z", {"c"}), std::nullopt);
  EXPECT_EQ(nearest_name("", {"c"}), std::nullopt);
  EXPECT_EQ(nearest_name("--", {"c"}), std::nullopt);
  EXPECT_EQ(nearest_name("z", {}), std::nullopt);
}

TEST(NearestName, IsNoneForANameThatIsRight) { EXPECT_EQ(nearest_name("fit", {"fit", "fits"}), std::nullopt); }

TEST(NearestName, StandsBeforeTheListOfKnownNames) {
  EXPECT_EQ(did_you_mean("fitt", kNames), ": did you mean fit?");
  EXPECT_EQ(did_you_mean("colour", kNames), "");
  EXPECT_EQ(known_names("rnu", {"run", "time"}), ": did you mean run? (known: run, time)");
  EXPECT_EQ(known_names("x", {"run", "time"}, "others"), " (known: run, time, others)");
  EXPECT_EQ(unknown_key("rnu", {"run", "time"}), "unknown key \"rnu\": did you mean run? (known: run, time)");
}

}  // namespace nearest_name_test
}  // namespace mixity
