#include "fitting/options.h"

#include <gtest/gtest.h>

namespace mixity {
namespace options_test {

TEST(Options, KnowTheObjectivesByNameAndTheOldOneNoMore) {
  for (const Objective objective : {Objective::toughness, Objective::curve})
    EXPECT_EQ(parse_objective(to_string(objective)), objective);
  EXPECT_FALSE(parse_objective("area"));
  EXPECT_NE(kNoAreaObjective.find("curve"), std::string_view::npos);
  EXPECT_EQ(kNoAreaObjective.find('\n'), std::string_view::npos);
}

TEST(Options, ReadWhatIsHeld) {
  const auto stated = parse_held("r"), valued = parse_held("lambda = 0.3");
  ASSERT_TRUE(stated && valued);
  EXPECT_EQ(stated->name, "r");
  EXPECT_FALSE(stated->value);
  EXPECT_EQ(valued->name, "lambda");
  EXPECT_EQ(valued->value, 0.3);
  for (const char* text : {"", "=0.3", "lambda=", "lambda=nan", "lambda=0.3x"}) EXPECT_FALSE(parse_held(text)) << text;
}

TEST(Options, ForTheValueAloneAskForNothingThatIsOnlyShown) {
  FitOptions options{
      .free = {kModulus}, .loss = Loss::huber, .confidence = 0.9, .influence = true, .profile_points = 8};
  options.bootstrap.replicates = 100;
  const FitOptions value = value_only(options);
  EXPECT_FALSE(value.intervals || value.influence || value.progress);
  EXPECT_EQ(value.bootstrap.replicates + value.profile_points, 0u);
  EXPECT_EQ(value.free, options.free);
  EXPECT_EQ(value.loss, Loss::huber);
}

}  // namespace options_test
}  // namespace mixity
