#include "analysis/readers_units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "analysis/run.h"
#include "base/number_text.h"
#include "dataset/load_text.h"

namespace mixity {
namespace readers_units_test {

/// The same points in these units, fitted.
Analysis fitted(const std::string& force, double in_newton, const std::string& area, double in_square_metre) {
  const double loads[] = {7.7e-3, 2.9e-3}, shears[] = {0, 0.03, 0.05, 0.07, 0.08};  // N
  const double areas[] = {0.457e-6, 0.449e-6, 0.444e-6, 0.432e-6, 0.425e-6,
                          0.319e-6, 0.309e-6, 0.289e-6, 0.262e-6, 0.241e-6};
  std::ostringstream csv;
  csv << "P [" << force << "],T [" << force << "],A [" << area << "]\n";
  for (std::size_t i = 0; i < 10; ++i)
    csv << shortest(loads[i / 5] / in_newton) << ',' << shortest(shears[i % 5] / in_newton) << ','
        << shortest(areas[i] / in_square_metre) << '\n';
  const Dataset data =
      load_text(csv.str(), "radius = \"9.42 mm\"\nmodulus = \"2.133 MPa\"\ntoughness = \"27 mJ/m^2\"\n");
  FitRequest request;
  request.models = {"c"};
  request.options.free = {kLoadOffset};
  return run(request, data);
}

TEST(ReadersUnits, AreThoseOfTheFileWhereAPersonWouldTakeThem) {
  EXPECT_FALSE(in_readers_units(fitted("mN", 1e-3, "mm^2", 1e-6)));
}

TEST(ReadersUnits, OfLargeAndSmallNumbersHaveAnotherPrefix) {
  const Analysis result = fitted("Newton", 1, "m^2", 1), expected = fitted("mN", 1e-3, "mm^2", 1e-6);
  const auto shown = in_readers_units(result);
  ASSERT_TRUE(shown);
  EXPECT_EQ(shown->data.display.force, "mN");
  EXPECT_EQ(shown->data.display.area, "mm^2");
  EXPECT_NEAR(shown->data.points[3].T * shown->data.display.force_scale, 70, 1e-9);  // rounding
  EXPECT_NEAR(shown->data.points[3].A * shown->data.display.area_scale, 0.432, 1e-12);
  // two fits of the same points differ by what the solver leaves
  const FitResult &one = shown->fits[0], &other = expected.fits[0];
  const FittedParameter &offset = *find_parameter(one.parameters, "load_offset"),
                        &right = *find_parameter(other.parameters, "load_offset");
  EXPECT_EQ(offset.unit, "mN");
  EXPECT_NEAR(*offset.value, *right.value, 1e-4 * std::abs(*right.stderr_));
  EXPECT_NEAR(*offset.stderr_, *right.stderr_, 1e-4 * *right.stderr_);
  EXPECT_NEAR(*offset.interval->high, *right.interval->high, 1e-4 * *right.stderr_);
  EXPECT_NEAR(offset.upper, right.upper, 1e-9 * right.upper);
  EXPECT_NEAR(one.area->rmse, other.area->rmse, 1e-4 * other.area->rmse);
  ASSERT_EQ(one.budget->exact.size(), other.budget->exact.size());
  for (std::size_t i = 0; i < one.budget->exact.size(); ++i) {
    EXPECT_EQ(one.budget->exact[i].unit, other.budget->exact[i].unit);
    EXPECT_NEAR(one.budget->exact[i].step, other.budget->exact[i].step, 1e-9 * other.budget->exact[i].step);
  }
  // the result itself stays in the units of the file
  EXPECT_EQ(result.data.display.force, "Newton");
  EXPECT_EQ(find_parameter(result.fits[0].parameters, "load_offset")->unit, "Newton");
}

TEST(ReadersUnits, OfAMicroscopeAreNoMillionsOfSquareMicrometres) {
  const auto shown = in_readers_units(fitted("mN", 1e-3, "um^2", 1e-12));
  ASSERT_TRUE(shown);
  EXPECT_EQ(shown->data.display.force, "mN");
  EXPECT_EQ(shown->data.display.area, "mm^2");
}

}  // namespace readers_units_test
}  // namespace mixity
