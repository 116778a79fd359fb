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

TEST(NearestName, IsWithinAThirdOfItsLetters) {
  const std::vector<std::string> names{"abcdefghijklmno"};
  EXPECT_EQ(nearest_name("abcdefghijkl", names), names[0]);
  EXPECT_EQ(nearest_name("abcdefghijk", names), std::nullopt);  // four edits, and a third of 15 letters would be five
  EXPECT_EQ(nearest_name("modul", kNames), "modulus");          // 2 of 7
  EXPECT_EQ(nearest_name("modxyz", kNames), std::nullopt);
  EXPECT_EQ(nearest_name("abxyef", {"abcdef"}), "abcdef");  // 2 of 6
  EXPECT_EQ(nearest_name("abxye", {"abcde"}), std::nullopt);
  EXPECT_EQ(nearest_name("abxyef", {"abcdef"}, 1), std::nullopt);
  EXPECT_EQ(nearest_name("ax", {"ab"}), "ab");  // one edit is allowed for short names
  EXPECT_EQ(nearest_name("axy", {"ab"}), std::nullopt);
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

TEST(NearestName, IsFoundInListsThatHaveItTwice) {
  EXPECT_EQ(nearest_name("simga_T", {"sigma_T", "modulus", "sigma_T"}), "sigma_T");
}

TEST(NearestName, StandsBeforeTheListOfKnownNames) {
  EXPECT_EQ(did_you_mean("fitt", kNames), ": did you mean fit?");
  EXPECT_EQ(did_you_mean("colour", kNames), "");
  EXPECT_EQ(known_names("rnu", {"run", "time"}), ": did you mean run? (known: run, time)");
  EXPECT_EQ(known_names("x", {"run", "time"}, "others"), " (known: run, time, others)");
  EXPECT_EQ(unknown_key("rnu", {"run", "time"}), "unknown key \"rnu\": did you mean run? (known: run, time)");
}

}  // namespace nearest_name_test
}  // namespace mixity
