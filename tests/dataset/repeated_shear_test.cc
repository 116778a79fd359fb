// Runs at one load that follow each other in a file without a column of names.
#include <gtest/gtest.h>

#include "dataset/load_text.h"
#include "dataset/unnamed_runs.h"

namespace mixity {
namespace repeated_shear_test {

/// The runs of points at one load with these T.
std::vector<std::string> runs_of(const std::vector<double>& T) {
  std::string text = "P,T,A\n";
  for (const double one : T) text += "10," + std::to_string(one) + ",30\n";
  return load_text(text).curves;
}

const std::vector<std::string> kOne{"P=10"}, kTwo{"P=10", "P=10 (2)"};

TEST(RepeatedShear, ThatBeginsAnewIsAnotherRun) {
  EXPECT_EQ(runs_of({0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5}), kTwo);
  EXPECT_EQ(runs_of({0.1, 1, 2, 3, 4, 5, -0.1, 1, 2, 3, 4}), kTwo);
  EXPECT_EQ(runs_of({0, -1, -2, -3, -4, -5, 0, 1, 2, 3, 4, 5}), kTwo);
}

TEST(RepeatedShear, ThatFallsAndStaysOrComesInNoOrderIsOneRun) {
  EXPECT_EQ(runs_of({0, 1, 2, 3, 4, 5, 6, 7}), kOne);
  EXPECT_EQ(runs_of({0, 1, 2, 3, 4, 5, 0, 0.1, 0, 0.1, 0, 0.1}), kOne);        // the contact is lost
  EXPECT_EQ(runs_of({0, 1, 2, 3, 4, 5, 4, 3, 2, 1, 0, 1, 2, 3, 4, 5}), kOne);  // unloaded and loaded again
  EXPECT_EQ(runs_of({0, 2, 4, 6, 8, 5, 6, 7, 8, 5, 6, 7, 8}), kOne);           // stick and slip
  EXPECT_EQ(runs_of({3, 0, 5, 1, 4, 0, 2, 5, 1, 3, 0, 4, 2, 5, 0, 3}), kOne);  // in no order
}

TEST(RepeatedShear, AtANoisyLoadIsParted) {
  std::string text = "P,T,A\n";
  for (int run = 0; run < 2; ++run)
    for (int i = 0; i < 20; ++i) text += std::to_string(30 + 0.1 * ((7 * i) % 5)) + "," + std::to_string(i) + ",60\n";
  const Dataset data = load_text(text);
  EXPECT_EQ(data.curves.size(), 2u);
  EXPECT_EQ(data.points[20].curve, 1u);
  EXPECT_NEAR(data.curve_loads[1], 30.2, 1e-9);
}

TEST(RepeatedShear, OfAFileThatNamesItsRunsOrStatesOneLoadIsLeftAsItIs) {
  const std::string rows[] = {"0", "1", "2", "3", "4", "0", "1", "2", "3", "4"};
  std::string named = "curve,P,T,A\n", stated = "T [mN],A [mm^2]\n";
  for (const std::string& T : rows) {
    named += "x,10," + T + ",30\n";
    stated += T + ",0.3\n";
  }
  EXPECT_EQ(load_text(named).curves, std::vector<std::string>{"x"});
  EXPECT_EQ(
      load_text(stated, "load = \"5 mN\"\nradius = \"9.42 mm\"\nmodulus = \"2.133 MPa\"\ntoughness = \"27 mJ/m^2\"\n")
          .curves.size(),
      1u);
}

}  // namespace repeated_shear_test
}  // namespace mixity
