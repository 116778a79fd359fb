// Alarms of noise alone, where T scatters so widely that A(T) is curved within its error.
#include "fitting/noise_alone.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "fitting/consistency.h"
#include "fitting/fit.h"
#include "fitting/synthetic_runs.h"

namespace mixity {
namespace noise_alone_test {

/// Eight runs of model c; T has an error of 3 % of the largest one, A one of 0.2 %.
struct NoisyShear {
  Dataset data;
  FitOptions options{.sigma_A = *parse_quantity("0.2%"), .intervals = false};

  explicit NoisyShear(unsigned seed) {
    SeededNoise noise(seed, 0.002), shear(seed + 1000, 1);
    data = synthetic_runs("c", {0.15}, {-1.5, -0.2, 1.7, 3, 5, 9, 12, 24}, 100, 0.97, noise);
    data.contact = Contact{0.01, 2e6, 0.03};
    double error = 0;
    for (const Point& point : data.points) error = std::max(error, 0.03 * point.T);
    for (Point& point : data.points) point.T += error * shear();
    options.sigma_T = parse_quantity(std::to_string(1e6 * error * data.contact->force_unit()) + " uN");
  }
};

TEST(NoiseAlone, OfAWideErrorOfTMakesNoAlarm) {
  int ok = 0, simulated = 0;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const NoisyShear noisy(seed);
    const FitResult fit = fit_model(noisy.data, "c", noisy.options);
    ok += fit.status == FitStatus::ok;
    simulated += fit.message.text().find("simulated") != std::string::npos;
    EXPECT_NEAR(*fit.parameters[0].value, 0.15, 4 * *fit.parameters[0].stderr_) << seed;
  }
  EXPECT_EQ(ok, 8);
  EXPECT_GE(simulated, 4);  // these would be suspect otherwise
}

TEST(NoiseAlone, Zcount) {
  int n=0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const NoisyShear noisy(seed);
    const FitResult fit = fit_and_test(noisy.data, "c", noisy.options);
    const auto& t = fit.consistency->residuals;
    if (fit.status != FitStatus::ok) { ++n; std::cerr << seed << " " << failed_test(noisy.data, fit).text() << " " << t.runs_p << " " << t.correlation_p <<" " << t.trend_p << " " << t.ends_p << " " << t.course_p << " chi " << *fit.consistency->chi2_per_freedom << " z " << (*fit.parameters[0].value-0.15)/ *fit.parameters[0].stderr_ << "\n";}
  }
  std::cerr << n << "\n";
}
TEST(NoiseAlone, DoesNotExcuseAWrongModel) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const NoisyShear noisy(seed);
    EXPECT_EQ(fit_model(noisy.data, "a", noisy.options).status, FitStatus::suspect) << seed;
  }
}

TEST(NoiseAlone, ExcusesNoFindingThatHasItsOwnMessage) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const NoisyShear noisy(seed);
    FitResult fit = fit_and_test(noisy.data, "c", noisy.options);
    if (fit.status != FitStatus::suspect) continue;
    fit.message = "too wide";
    find_cause(noisy.data, fit, noisy.options);
    EXPECT_EQ(fit.status, FitStatus::suspect);
    EXPECT_TRUE(fit.message.text().starts_with("too wide")) << fit.message.text();
    return;
  }
  FAIL() << "no fit is suspect";
}

/// Noise of 1 % bends nothing: no experiment is simulated for a fault.
TEST(NoiseAlone, IsNotAskedWhereNoCurvatureMatters) {
  SeededNoise noise(1, 0.01);
  Dataset data = synthetic_runs("c", {0.15}, {0.5, 5, 20}, 20, 0.8, noise);
  const FitResult fit = fit_and_test(data, "a", {.intervals = false});
  EXPECT_FALSE(noise_alone_fails_alike(data, fit, {}));
}

}  // namespace noise_alone_test
}  // namespace mixity
