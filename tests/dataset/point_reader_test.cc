#include "dataset/point_reader.h"

#include <gtest/gtest.h>

#include <tuple>

#include "dataset/load_text.h"

namespace mixity {
namespace point_reader_test {

constexpr std::size_t kRows = 3000;

/// Rows of measurements, among them all kinds that are left out.
std::string measured_rows(const std::string& header, const std::vector<std::string>& odd, const std::string& behind) {
  std::string text = header;
  for (std::size_t i = 0; i < kRows; ++i) {
    // the last run is sheared the other way, the others about zero
    const double shear = 0.01 * static_cast<double>(i % 977), T = i < 2000 ? shear - 0.05 : 0.05 - shear,
                 size = 2.2 + 0.0007 * static_cast<double>(i % 1009);
    std::string row = std::to_string(0.1 * static_cast<double>(i % 3 + 1)) + ',' + std::to_string(T) + ',' +
                      std::to_string(size) + ",0.5," + std::to_string(0.001 * static_cast<double>(i % 7)) + ",run " +
                      std::to_string(i / 1000);
    if (i % 50 == 7) row = odd[i / 50 % odd.size()];
    text += row + behind;
  }
  return text;
}

std::size_t points_below_zero(const Dataset& data) {
  std::size_t below = 0;
  for (const Point& point : data.points) below += point.T < 0;
  return below;
}

/// One reading of -9999 would turn the sign of its run, and lie far from all others.
TEST(PointReader, LeavesOutNumbersAndWordsThatStandForMissingOnes) {
  for (const char* missing :
       {"-9999", "-9999.0", "-99999", "9.9E37", "-9.90E+37", "9.91E37", "OVL", "O.L", "OVERLOAD"}) {
    const Dataset data = load_text("P [mN],T [mN],A [mm^2]\n5,0,0.4\n5," + std::string(missing) + ",0.39\n5,20,0.38\n",
                                   "radius = \"9.42 mm\"\nmodulus = \"2.133 MPa\"\ntoughness = \"27 mJ/m^2\"\n");
    ASSERT_EQ(data.points.size(), 2u) << missing;
    EXPECT_GT(data.points[1].T, 0) << missing;
    ASSERT_EQ(data.excluded.size(), 1u) << missing;
    EXPECT_EQ(data.excluded[0].reason, "T is missing") << missing;
  }
  // a large reading is one
  EXPECT_EQ(load_text("P,T,A\n9,0,60\n9,9999,59\n").points.size(), 2u);
}

TEST(PointReader, AColumnThatIncludesEachRowChangesNothing) {
  const std::vector<std::string> odd{"1,-1,3,0,0,x",    "1,1,0,0,0,x",     "1,1,-3,0,0,x",      "1,1,1,0,0,x",
                                     "1,,3,0,0,x",      "1,nan,3,0,0,x",   "1,1e200,3,0,0,x",   "-1e90,1,3,0,0,x",
                                     "1,1,1e60,0,0,x",  "1,1,1e-60,0,0,x", "0,0,1e-60,0,0,x",   "1,1,3,-1,0,x",
                                     "1,1,3,,,x",       "1,1,3,0,1e400,x", "1,1,3,1e-90,0,x",   "1,1e70,3,0,0,x",
                                     "1e400,1,3,0,0,x", "+1,1,3,0,0,x",    "-2.5,1e-80,3,0,0,x"};
  const std::string stated = "radius = \"9.42 mm\"\nmodulus = \"2.133 MPa\"\ntoughness = \"27 mJ/m^2\"\n";
  std::size_t below = 0, reversed = 0;
  for (const std::string header :
       {"P,T,a,sigma_T,sigma_A,curve", "P [mN],T [mN],a [mm],sigma_T [%],sigma_A [mm^2],curve",
        "P [mN],T [uN],A [mm^2],sigma_T [mN],sigma_A [%],curve", "P,T,A,x,y,z"}) {
    const std::string constants = header.find('[') == std::string::npos ? "" : stated;
    const Dataset several = load_text(measured_rows(header + "\n", odd, "\n"), constants),
                  single = load_text(measured_rows(header + ",include\n", odd, ",1\n"), constants);
    EXPECT_EQ(several.rows, kRows);
    ASSERT_EQ(several.points.size(), single.points.size()) << header;
    EXPECT_GT(several.points.size(), kRows / 2);
    ASSERT_EQ(several.errors.size(), single.errors.size());
    for (std::size_t i = 0; i < several.points.size(); ++i) {
      const Point &p = several.points[i], &q = single.points[i];
      ASSERT_EQ(std::tuple(p.line, p.curve, p.P, p.T, p.A), std::tuple(q.line, q.curve, q.P, q.T, q.A)) << header;
      const PointErrors e = several.errors_of(i), f = single.errors_of(i);
      ASSERT_EQ(std::tuple(e.T, e.A, e.ratio), std::tuple(f.T, f.A, f.ratio)) << header << p.line;
    }
    EXPECT_GT(several.excluded.size(), kRows / 100);
    ASSERT_EQ(several.excluded.size(), single.excluded.size());
    for (std::size_t i = 0; i < several.excluded.size(); ++i) {
      EXPECT_EQ(several.excluded[i].line, single.excluded[i].line);
      EXPECT_EQ(several.excluded[i].reason, single.excluded[i].reason);
    }
    EXPECT_EQ(several.curves, single.curves);
    EXPECT_EQ(texts_of(several.notes), texts_of(single.notes));
    below += points_below_zero(several);
    for (const std::string& note : texts_of(several.notes))
      reversed += note.find("reversed (T -> -T)") != std::string::npos;
  }
  EXPECT_GT(below, 0);
  EXPECT_GT(reversed, 0);
}

}  // namespace point_reader_test
}  // namespace mixity
