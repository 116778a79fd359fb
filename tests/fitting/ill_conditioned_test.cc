// Fits whose condition number, the standard error of lambda in units of the noise, is next to 1/eps.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fitting/fit.h"
#include "fitting/synthetic.h"
#include "many_digits.h"

namespace mixity {
namespace ill_conditioned_test {

/// d(ln f)/d(lambda) = psi^2: a solver that takes small slopes for none stays where it started.
TEST(IllConditioned, LambdaIsFoundAtSmallAngles) {
  for (const double last : {1e-2, 1e-4, 1e-6, 3e-7}) {
    const Dataset data = synthetic("c", {0.35}, angles_up_to(last, 80));
    const FitResult fit = fit_model(data, "c");
    ASSERT_TRUE(fit.parameters[0].value) << last << fit.message.text();
    // f is rounded to eps: of 80 points as many parts of psi^2, at most
    EXPECT_NEAR(*fit.parameters[0].value, 0.35, 1e-8 + 4 * 2.2e-16 / (last * last)) << last;
  }
}

/// At lambda = 2 the slope of b vanishes by symmetry, which is no reason to end there.
TEST(IllConditioned, ABoundWithoutSlopeIsNoMinimum) {
  for (const double last : {4.6e-7, 3e-7, 2e-7}) {
    const Dataset data = synthetic("b", {1.3}, angles_up_to(last, 90));
    const FitResult fit = fit_model(data, "b");
    ASSERT_TRUE(fit.parameters[0].value) << last;
    EXPECT_NEAR(*fit.parameters[0].value, 1.3, 4 * 2.2e-16 / (0.35 * last * last)) << last;
  }
}

/// Where the cost is little more than rounding its slopes contradict it: no reason to call it infinite.
TEST(IllConditioned, RoundingIsNotCalledInfinite) {
  for (const double last : {1e-8, 3e-8, 6e-8, 1e-7, 1.8e-7})
    for (const double lambda : {0.0, 0.06, 1.0}) {
      const Dataset data = synthetic("b", {lambda}, angles_up_to(last, 39),
                                     [&](std::size_t i) { return 0.2 * last * last * scatter(i); });
      for (const char* model : {"a", "b", "c"}) {
        const FitResult fit = fit_model(data, model);
        EXPECT_NE(fit.status, FitStatus::not_converged) << last << ' ' << lambda << ' ' << model << fit.message.text();
      }
    }
}

/// Points next to pi/2 put all of the answer between two places of the scan.
TEST(IllConditioned, ABasinBetweenTwoPlacesOfTheScanIsSeen) {
  for (const double lambda : {0.013, 0.37, 1.1, 1.7}) {
    const Dataset data =
        synthetic("b", {lambda}, {1.57, 1.5700001}, [](std::size_t i) { return 1e-6 * static_cast<double>(i); });
    const FitResult fit = fit_model(data, "b");
    ASSERT_TRUE(fit.parameters[0].value) << lambda << fit.message.text();
    EXPECT_NEAR(*fit.parameters[0].value, lambda, 1e-5) << lambda;
  }
}

/// f = 1 + (1 - lambda) tan^2(psi): next to pi/2 lambda matters by its distance from 1, to a few hundred of its last
/// digits. Against the printed cost in 50 digits at the doubles around.
TEST(IllConditioned, LambdaNextToOneIsFoundToItsLastDigits) {
  std::vector<double> angles(60);
  for (std::size_t i = 0; i < angles.size(); ++i)
    angles[i] = 1.5707963267948966 - std::pow(10.0, -7 + static_cast<double>(i) / 20);
  for (const double distance : {1e-10, 1e-12, 1.3e-13, 3e-14}) {
    const Dataset data = synthetic("a", {1 - distance}, angles, [](std::size_t i) { return 0.3 * scatter(i); });
    const FitResult fit = fit_model(data, "a");
    EXPECT_EQ(fit.status, FitStatus::ok) << fit.message.text();
    EXPECT_TRUE(fit.parameters[0].stderr_) << distance;
    const auto cost = [&](const truth::Digits50& lambda) {
      truth::Digits50 sum = 0;
      for (const ToughnessPoint& point : data.converted) {
        const truth::Digits50 t = truth::Digits50(point.mixity.sin) / point.mixity.cos;
        const truth::Digits50 r = log(truth::Digits50(1 + (1 - lambda) * t * t)) - log(truth::Digits50(point.ratio));
        sum += r * r;
      }
      return sum;
    };
    const double found = *fit.parameters[0].value, digit = 0.5 * std::numeric_limits<double>::epsilon();
    const truth::Digits50 here = cost(found);
    for (int step = 2; step < 2000; step += 1 + step / 10) {  // within two of the last digit no double is lower
      EXPECT_GT(cost(found - step * digit), here) << distance << ' ' << step;
      if (found + step * digit >= 1) break;
      EXPECT_GT(cost(found + step * digit), here) << distance << ' ' << step;
    }
  }
}

}  // namespace ill_conditioned_test
}  // namespace mixity
