#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cli/run_program.h"

namespace mixity::cli {
namespace command_points_test {

TEST(PointsCommand, PrintsPhaseAngleAndToughnessRatioOfEachPoint) {
  const TemporaryFolder folder;
  const ProgramResult result = run_program({"points", folder.write("d.csv", "P,T,A\n3,10,20\n3,1,0.1\n")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const std::vector<std::string> lines = lines_of(result.out);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0], "line,curve,P,T,A,psi [deg],Gc_over_GIc");
  const std::vector<std::string> fields = fields_of(lines[1]);
  ASSERT_EQ(fields.size(), 7u);
  EXPECT_EQ(fields[0], "2");
  // from 40 digits; a dozen roundings
  EXPECT_NEAR(std::stod(fields[5]), 28.500906449115015, 1e-12);
  EXPECT_NEAR(std::stod(fields[6]), 1.0878996687103277, 1e-14);
  EXPECT_TRUE(lines[2].ends_with(",,")) << lines[2];  // an area below that of Hertz has no phase angle
}

TEST(PointsCommand, NeedsOneFile) {
  const ProgramResult result = run_program({"points"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.complaint(), "mixity: points needs one data CSV (see mixity help points)");
}

}  // namespace command_points_test
}  // namespace mixity::cli
