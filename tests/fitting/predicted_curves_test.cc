// Curves and states of a fit in the numbers of its readings.
#include "fitting/predicted_curves.h"

#include <gtest/gtest.h>

#include "fitting/fit.h"
#include "fitting/misread_data.h"

namespace mixity {
namespace predicted_curves_test {

/// A point that was read on a drawn curve is a state of the contact.
TEST(PredictedCurves, PassThroughTheReadings) {
  FitOptions options;
  options.intervals = false;
  options.objective = Objective::toughness;
  for (auto& [constant, data] : misread_mergel())
    for (const bool reversed : {false, true}) {
      if (reversed)  // T -> -T in the file
        for (std::size_t i = 0; i < data.points.size(); ++i) {
          const ConstantsScale by(data.stated_constants());
          data.points[i].T = -by.measured_shear(-by.shear(data.points[i].T));
        }
      data.shear_reversed.assign(data.curves.size(), reversed);
      const FitResult fit = fit_model(data, "c", options);
      const ConstantsScale by(data.stated_constants());
      const double lambda = *fit.parameters[0].value, sign = reversed ? -1 : 1;
      const auto off = [&](double P, double T, double A) {
        const double a = radius_from_area(by.true_area(A));
        if (edge_load(a, by.load(P)) < 1e-2) return 0.0;  // a difference of larger numbers
        const auto point = toughness_of_area(by.load(P), by.shear(sign * T), by.true_area(A));
        const double s = point->mixity.sin;
        return point->ratio * (1 + (lambda - 1) * s * s) - 1;
      };
      for (const StableState& state : stable_states(data, options, fit, 0, 20))
        EXPECT_NEAR(off(data.curve_loads[0], state.T, state.A), 0, 1e-6) << constant;
      const DrawnCurve drawn = drawn_curve(data, options, fit, data.curve_loads[0], 100, sign);
      const double force = data.display.force_scale, area = data.display.area_scale;
      ASSERT_FALSE(drawn.points.empty());
      for (const DrawnPoint& q : drawn.points)
        EXPECT_NEAR(off(data.curve_loads[0], q.T / force, q.A / area), 0, 1e-6) << constant;
    }
}

/// u = 3/4 T/a of the true T and a, whatever factor areas are read with.
TEST(PredictedCurves, HaveTheDisplacementOfTheContact) {
  const Dataset data = mergel({{"area_scale", "1.1"}});
  FitOptions options;
  options.intervals = false;
  options.objective = Objective::toughness;
  const FitResult fit = fit_model(data, "c", options);
  for (const DrawnPoint& q : drawn_curve(data, options, fit, data.curve_loads[0], 100).points) {
    const double T = q.T / data.display.force_scale, a = radius_from_area(1.1 * q.A / data.display.area_scale);
    EXPECT_NEAR(q.u, 0.75 * T / a * data.contact->displacement_unit() * 1e6, 1e-9 * (1 + q.u));
  }
}

}  // namespace predicted_curves_test
}  // namespace mixity
