// The jump that a model predicts is the fold's: in closed form for model c.
#include "analysis/predicted_peaks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analysis/run.h"
#include "base/number_text.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace predicted_peaks_test {

constexpr double kLambda = 0.15;

double jump_of_c(double P) {
  constexpr double y = 3 * std::numbers::pi;
  return std::sqrt(y * (y + 2 * P) / kLambda);
}

TEST(PredictedPeaks, AreTheFoldsOfModelC) {
  const TemporaryFolder folder;
  std::string points = "P,T,A\n", peaks = "P,T_peak\n";
  for (const double P : {1.0, 3.0, 6.0}) {
    for (int i = 0; i < 12; ++i) {
      const double T = 0.08 * i * jump_of_c(P);
      // from the printed equation: y on the circle of S0, a^3 = 3/4 (y + P)
      const double square = 9 * std::pow(std::numbers::pi, 2) + 6 * std::numbers::pi * P;
      const double y = 3 * std::numbers::pi + std::sqrt(square - kLambda * T * T);
      points +=
          shortest(P) + "," + shortest(T) + "," + shortest(std::numbers::pi * std::pow(0.75 * (y + P), 2.0 / 3)) + "\n";
    }
    peaks += shortest(P) + "," + shortest(0.9 * jump_of_c(P)) + "\n";
  }
  FitRequest request;
  request.data_path = folder.write("run.csv", points);
  request.models = {"c"};
  const Analysis result = run(request);
  const PeakForces forces = load_peak_forces(folder.write("peaks.csv", peaks));
  const auto predicted = predict_peaks(result, forces);
  ASSERT_EQ(predicted.size(), 1u);
  ASSERT_EQ(predicted[0].loads.size(), 3u);
  for (const PredictedPeak& load : predicted[0].loads) {
    const double hertz = std::numbers::pi * std::pow(0.75 * load.P, 2.0 / 3);
    EXPECT_NEAR(load.stress * hertz, jump_of_c(load.P), 1e-6 * jump_of_c(load.P));  // lambda is fitted to 1e-7 or so
    EXPECT_LE(load.low, load.stress);
    EXPECT_GE(load.high, load.stress);
  }
  EXPECT_NEAR(predicted[0].ratio.value(), 0.9, 1e-6);
  EXPECT_LT(predicted[0].ratio_error.value(), 1e-6);
}

TEST(PredictedPeaks, OfPeaksInOtherUnitsThanTheDataAreNone) {
  const TemporaryFolder folder;
  FitRequest request;
  request.data_path = folder.write("run.csv", "P,T,A\n3,0,21.87\n3,5,21.4\n3,10,20\n3,15,17.5\n");
  request.models = {"c"};
  folder.write("peaks.toml", "radius = \"9.42 mm\"\nmodulus = \"2.133 MPa\"\n");
  const PeakForces forces = load_peak_forces(folder.write("peaks.csv", "P [mN],T_peak [mN]\n2,7\n"));
  EXPECT_TRUE(predict_peaks(run(request), forces).empty());
}

}  // namespace predicted_peaks_test
}  // namespace mixity
