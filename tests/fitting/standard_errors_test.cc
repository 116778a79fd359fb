#include "fitting/standard_errors.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/input_error.h"
#include "dataset/load_text.h"
#include "fitting/synthetic_runs.h"

namespace mixity {
namespace standard_errors_test {

constexpr const char* kMetadata =
    "radius = \"10 mm\"\nmodulus = \"2 MPa\"\ntoughness = \"30 mJ/m^2\"\nprovenance = \"measured\"\n";

constexpr const char* kPlain = "P,T,A\n1,0,19.6\n1,5,19.2\n1,10,18\n";
constexpr const char* kColumns = "P,T,A,sigma_T,sigma_A\n1,0,19.6,0.1,0.2\n1,5,19.2,0.3,0.4\n1,10,18,0.5,0.6\n";
constexpr const char* kDimensional = "P [mN],T [mN],A [mm^2]\n1,0,0.35\n1,1,0.34\n1,2,0.33\n";

StatedError stated(const char* text) { return *parse_quantity(text); }

TEST(StandardErrors, ComeFromTheColumnsOfTheFile) {
  const StandardErrors errors = standard_errors(load_text(kColumns), {}, {});
  EXPECT_EQ(errors.A, (std::vector<double>{0.2, 0.4, 0.6}));
  EXPECT_EQ(errors.T, (std::vector<double>{0.1, 0.3, 0.5}));
  EXPECT_EQ(errors.source_A, ErrorSource::columns);
  EXPECT_EQ(errors.source_T, ErrorSource::columns);
  EXPECT_FALSE(errors.scatter);
  EXPECT_TRUE(errors.absolute());
}

TEST(StandardErrors, OfAPercentageAreThatOfEachValue) {
  const StandardErrors errors = standard_errors(load_text(kPlain), stated("2%"), stated("0.5 %"));
  for (std::size_t i = 0; i < 3; ++i) {
    const double T[] = {0, 5, 10}, A[] = {19.6, 19.2, 18};
    EXPECT_DOUBLE_EQ(errors.T[i], 0.02 * T[i]);
    EXPECT_DOUBLE_EQ(errors.A[i], 0.005 * A[i]);
  }
  EXPECT_EQ(errors.source_A, ErrorSource::stated);
  EXPECT_TRUE(errors.absolute());
}

TEST(StandardErrors, StatedOnesWinOverColumns) {
  const StandardErrors errors = standard_errors(load_text(kColumns), {}, stated("0.25"));
  EXPECT_EQ(errors.A, (std::vector<double>{0.25, 0.25, 0.25}));
  EXPECT_EQ(errors.T, (std::vector<double>{0.1, 0.3, 0.5}));
  EXPECT_EQ(errors.source_A, ErrorSource::stated);
  EXPECT_EQ(errors.source_T, ErrorSource::columns);
}

TEST(StandardErrors, WithAUnitAreMadeDimensionlessAsTheDataAre) {
  const Dataset data = load_text(kDimensional, kMetadata);
  const StandardErrors one = standard_errors(data, stated("0.01 mN"), stated("0.002 mm^2"));
  const StandardErrors other = standard_errors(data, stated("10 µN"), stated("2000 um2"));
  // R G_Ic = 0.3 mN; (R/xi)^2 with xi = (2e6 * 0.01/0.03)^(1/3); both to the roundings of a product
  EXPECT_NEAR(one.T[1], 0.01 / 0.3, 1e-15);
  EXPECT_NEAR(one.A[1], 0.002e-6 / std::pow(0.01 / std::cbrt(2e4 / 0.03), 2), 1e-15);
  EXPECT_NEAR(one.T[1], other.T[1], 1e-15);
  EXPECT_NEAR(one.A[1], other.A[1], 1e-15);
}

TEST(StandardErrors, TakeTAsExactWhereOnlyAHasOneAndOneAxisCounts) {
  const StandardErrors errors = standard_errors(load_text(kPlain), {}, stated("1%"));
  EXPECT_EQ(errors.source_T, ErrorSource::exact);
  EXPECT_EQ(errors.T, (std::vector<double>{0, 0, 0}));
  EXPECT_TRUE(errors.absolute());
}

/// However densely T is sampled, and where it is stepped: readings that differ by less than their noise.
TEST(StandardErrors, EstimatedFromTheScatterDoNotDependOnTheSampling) {
  const double P = 4, last = 0.9 * shear_to_lose_area("c", {0.01}, P);
  const ContactModel model = model_named("c");
  const auto estimate = [&](std::size_t steps, std::size_t readings) {
    SeededNoise noise(5, 0.01), jitter(6, 1e-4);
    Dataset data = empty_runs();
    data.curves.push_back("one");
    data.curve_loads.push_back(P);
    for (std::size_t k = 0; k < steps * readings; ++k) {
      const double T = last * static_cast<double>(k / readings) / static_cast<double>(steps - 1);
      const double A =
          area_from_radius(radius_from_edge_load(model.equilibria(ParameterValues{0.01}, P, {&T, 1}).at[0].y, P)) *
          (1 + noise());
      data.points.push_back({k + 2, 0, P, T * (1 + jitter()), A});
    }
    return *standard_errors(data, {}, {}).scatter;
  };
  // areas alone are noisy here, so that the error common to both axes is a little less; the median of n values is known
  // to 1.2/sqrt(2 n) of itself
  for (const std::size_t n : {100u, 400u, 1600u, 20000u}) EXPECT_NEAR(estimate(n, 1), 0.0095, 0.0016) << n;
  EXPECT_NEAR(estimate(10, 6), 0.0095, 0.0035);
  EXPECT_NEAR(estimate(10, 200), 0.0095, 0.0015);
}

/// An exact T that nobody stated made lambda ten of its errors wrong.
TEST(StandardErrors, EstimateThatOfTFromTheScatterForBothAxesWhereOnlyAHasOne) {
  SeededNoise noise(7, 0.01);
  const Dataset data = synthetic_runs("c", {0.15}, {0.5, 5}, 20, 0.6, noise);
  const StandardErrors errors = standard_errors(data, {}, stated("1%"), true);
  EXPECT_EQ(errors.source_A, ErrorSource::stated);
  EXPECT_EQ(errors.source_T, ErrorSource::scatter);
  EXPECT_TRUE(errors.absolute());
  ASSERT_TRUE(errors.scatter);
  EXPECT_EQ(*errors.scatter, *standard_errors(data, {}, {}).scatter);
  EXPECT_DOUBLE_EQ(errors.T[7], *errors.scatter * data.points[7].T);
  EXPECT_DOUBLE_EQ(errors.A[7], 0.01 * data.points[7].A);
  EXPECT_EQ(standard_errors(load_text(kPlain), {}, stated("1%"), true).source_T, ErrorSource::assumed);
}

TEST(StandardErrors, OfTAloneLeaveTheSizeOfThoseOfAOpen) {
  const StandardErrors errors = standard_errors(load_text(kPlain), stated("0.1"), {});
  EXPECT_EQ(errors.source_T, ErrorSource::stated);
  EXPECT_EQ(errors.source_A, ErrorSource::assumed);  // three points have one neighbour between two
  EXPECT_FALSE(errors.absolute());
}

/// Areas of model c with 1 % noise in A: the estimate shares it between A and T, so that noise in A alone reads
/// between 1 % and 1 %/sqrt(1 + (T dA/dT/A)^2), which is 0.98 % over the first 0.6 of the fold.
TEST(StandardErrors, FromScatterFindTheNoiseOfTheData) {
  double sum = 0, sum_of_squares = 0;
  constexpr int kSeeds = 60;
  for (unsigned seed = 1; seed <= kSeeds; ++seed) {
    SeededNoise noise(seed, 0.01);
    const Dataset data = synthetic_runs("c", {0.15}, {0.5, 5, 20}, 60, 0.6, noise);
    const StandardErrors errors = standard_errors(data, {}, {});
    ASSERT_TRUE(errors.scatter);
    EXPECT_EQ(errors.source_A, ErrorSource::scatter);
    EXPECT_EQ(errors.source_T, ErrorSource::scatter);
    EXPECT_FALSE(errors.absolute());
    EXPECT_DOUBLE_EQ(errors.A[7], *errors.scatter * data.points[7].A);
    EXPECT_DOUBLE_EQ(errors.T[7], *errors.scatter * data.points[7].T);
    sum += *errors.scatter;
    sum_of_squares += *errors.scatter * *errors.scatter;
  }
  const double mean = sum / kSeeds, spread = std::sqrt(sum_of_squares / kSeeds - mean * mean);
  // The median of 174 squares, about half of them independent, has a relative error of 1.17/sqrt(2 * 87) = 9 %.
  EXPECT_LT(spread, 0.2 * mean);
  EXPECT_GT(spread, 0.03 * mean);
  // Four standard errors of the mean, and the 2 % by which T takes its share.
  EXPECT_NEAR(mean, 0.01, 4 * 0.09 * 0.01 / std::sqrt(kSeeds) + 0.0002);
}

TEST(StandardErrors, FromScatterAreNotMovedByTheOrderOfThePoints) {
  SeededNoise noise(7, 0.01);
  Dataset data = synthetic_runs("c", {0.15}, {0.5, 5}, 20, 0.6, noise);
  const double in_order = *standard_errors(data, {}, {}).scatter;
  std::reverse(data.points.begin(), data.points.end());
  EXPECT_NEAR(*standard_errors(data, {}, {}).scatter, in_order, 1e-12 * in_order);  // the order of roundings
}

TEST(StandardErrors, FromScatterAreNotMovedByRowsThatRepeatOne) {
  SeededNoise noise(11, 0.01);
  Dataset data = synthetic_runs("c", {0.15}, {0.5, 5}, 20, 0.6, noise);
  const double once = *standard_errors(data, {}, {}).scatter;
  const std::vector<Point> points = data.points;
  data.points.insert(data.points.end(), points.begin(), points.end());
  EXPECT_EQ(*standard_errors(data, {}, {}).scatter, once);
}

/// Without three neighbours there is nothing to estimate from: one percent is assumed.
TEST(StandardErrors, AreAssumedWhereTheDataCannotShowThem) {
  const Dataset data = load_text("P,T,A\n1,0,19.6\n1,5,19.2\n2,0,21\n");
  const StandardErrors both = standard_errors(data, {}, {}), one = standard_errors(data, stated("0.1"), {});
  EXPECT_EQ(*both.scatter, 0.01);
  EXPECT_EQ(both.source_A, ErrorSource::assumed);
  EXPECT_EQ(both.source_T, ErrorSource::assumed);
  EXPECT_EQ(one.source_A, ErrorSource::assumed);
  EXPECT_EQ(one.source_T, ErrorSource::stated);
  EXPECT_FALSE(both.absolute() || one.absolute());
}

std::string refusal(const char* csv, const char* toml, std::optional<StatedError> T, std::optional<StatedError> A,
                    bool both_axes = false) {
  const Dataset data = load_text(csv, toml);
  const std::string text = input_error([&] { standard_errors(data, T, A, both_axes); });
  return text.substr(text.find("a.csv"));
}

/// Of errors that are right up to one factor only their ratio counts; the factor comes from the scatter.
TEST(StandardErrors, UpToAFactorDoNotDependOnTheirSize) {
  SeededNoise of_A(3, 0.01), of_T(4, 0.01);
  Dataset data = synthetic_runs("c", {0.15}, {-1, 0.5, 2, 5, 12, 30}, 25, 0.95, of_A);
  for (Point& point : data.points) point.T *= 1 + of_T();
  FitOptions options;
  options.free_sigma_factor = true;
  const auto fitted = [&](const char* sigma) {
    options.sigma_T = options.sigma_A = *parse_quantity(sigma);
    return fit_model(data, "c", options);
  };
  const FitResult small = fitted("0.2%"), large = fitted("5%");
  EXPECT_EQ(small.status, FitStatus::ok) << small.message.text();
  // the rounds that find the factor end at relative changes of 1e-10
  EXPECT_NEAR(*small.sigma_factor / *large.sigma_factor, 25, 25e-8);
  EXPECT_NEAR(*small.parameters[0].value, *large.parameters[0].value, 1e-9);
  EXPECT_NEAR(*small.parameters[0].interval->low, *large.parameters[0].interval->low, 1e-8);
  EXPECT_NEAR(0.002 * *small.sigma_factor, 0.01, 0.0015);  // 150 residuals tell it to 6 %
  options.free_sigma_factor = false;
  EXPECT_FALSE(fitted("1%").sigma_factor);
  options.free_sigma_factor = true;
  options.sigma_T.reset();
  EXPECT_THROW(fit_model(data, "c", options), InputError);
}

TEST(StandardErrors, RefuseWhatIsNoErrorOfTheQuantity) {
  EXPECT_EQ(refusal(kDimensional, kMetadata, {}, stated("0.1 mN")),
            "a.csv: sigma_A is '0.1 mN'; it must be an area such as mm^2, or a percentage such as 1%");
  EXPECT_EQ(refusal(kDimensional, kMetadata, stated("0.1 mm"), stated("1%")),
            "a.csv: sigma_T is '0.1 mm'; it must be a force such as mN, or a percentage such as 1%");
  EXPECT_EQ(refusal(kPlain, "", {}, stated("0.1 mm^2")),
            "a.csv: sigma_A is '0.1 mm^2'; it must be a number without a unit, or a percentage such as 1%");
  EXPECT_EQ(refusal(kPlain, "", {}, stated("0")),
            "a.csv: sigma_A must be greater than 0: objective toughness weighs its points by it");
  EXPECT_EQ(refusal(kPlain, "", stated("-1%"), stated("1")), "a.csv: sigma_T must not be below 0");
}

TEST(StandardErrors, RefuseAPointThatHasNoneInAColumnOfThem) {
  EXPECT_EQ(refusal("P,T,A,sigma_A\n1,0,19.6,0.1\n1,5,19.2,0\n", "", {}, {}),
            "a.csv:3:10: this point has no standard error of its area (sigma_A is 0 or empty)");
}

/// 1e-4 of the largest value, as for one stated as 0, would give the point almost all the weight.
TEST(StandardErrors, RefuseAnEmptyFieldAmongThemInBothAxes) {
  EXPECT_EQ(refusal("P,T,A,sigma_A\n1,0,19.6,0.1\n1,5,19.2,\n", "", {}, {}, true),
            "a.csv:3:10: this point has no standard error of its area (sigma_A is empty)");
  EXPECT_EQ(
      refusal("P,T,A,sigma_T\n1,0,19.6,0\n1,5,19.2,\n", "", {}, stated("1%"), true),
      "a.csv:3:10: this point has no standard error of its shear load (sigma_T is empty; 0 says that T is exact)");
}

/// A distance in both axes needs both errors: of what is stated as 0 1e-4 of the largest value, counted.
TEST(StandardErrors, OfZeroAreRaisedForBothAxesAndCounted) {
  const Dataset data = load_text("P,T,A,sigma_T,sigma_A\n1,0,19.6,0,0.1\n1,5,19.2,0.2,0\n1,10,18,0,0.3\n");
  const StandardErrors errors = standard_errors(data, {}, {}, true);
  EXPECT_EQ(errors.T, (std::vector<double>{kLeastError * 10, 0.2, kLeastError * 10}));
  EXPECT_EQ(errors.A, (std::vector<double>{0.1, kLeastError * 19.6, 0.3}));
  EXPECT_EQ(errors.raised_T, 2u);
  EXPECT_EQ(errors.raised_A, 1u);
  const StandardErrors exact = standard_errors(load_text(kPlain), stated("0"), stated("1%"), true);
  EXPECT_EQ(exact.T, (std::vector<double>(3, kLeastError * 10)));
  EXPECT_EQ(exact.raised_T, 3u);
  EXPECT_EQ(exact.raised_A, 0u);
}

/// The share of a T of 0 is 0: nobody stated that, and nothing is counted.
TEST(StandardErrors, ThatAreAShareOfAShearOfZeroAreRaisedInSilence) {
  const StandardErrors errors = standard_errors(load_text(kPlain), stated("2%"), stated("1%"), true);
  EXPECT_DOUBLE_EQ(errors.T[0], kLeastError * 10);
  EXPECT_DOUBLE_EQ(errors.T[1], 0.1);
  EXPECT_EQ(errors.raised_T, 0u);
}

}  // namespace standard_errors_test
}  // namespace mixity
