#include "fitting/scan.h"

#include <gtest/gtest.h>

#include "fitting/fit.h"
#include "fitting/prepared_fit.h"
#include "fitting/synthetic_runs.h"

namespace mixity {
namespace {

/// |x - c| as one residual for each parameter in 0..1, with a bend where the first passes `bend`. Counts what it is
/// asked.
class Bowl final : public LeastSquares {
 public:
  Bowl(std::vector<double> centre, double bend) : centre_(std::move(centre)), bend_(bend) {
    for (std::size_t k = 0; k < centre_.size(); ++k) parameters_.push_back({"x", 0, 1});
  }
  std::size_t residual_count() const override { return centre_.size(); }
  const std::vector<FreeParameter>& parameters() const override { return parameters_; }
  bool evaluate(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const override {
    ++asked;
    for (std::size_t k = 0; k < centre_.size(); ++k) residuals[k] = x[k] - centre_[k];
    for (std::size_t i = 0; i < jacobian.size(); ++i) jacobian[i] = i % (centre_.size() + 1) == 0;
    return true;
  }
  double data_norm() const override { return 1; }
  std::size_t bends_passed(std::span<const double> x) const override { return x[0] > bend_; }

  mutable int asked = 0;

 private:
  std::vector<FreeParameter> parameters_;
  std::vector<double> centre_;
  double bend_;
};

TEST(ScanAround, AsksNothingWhereNoBendIsNear) {
  const Bowl problem({0.5, 0.5}, 0.4);
  EXPECT_TRUE(scan_around(problem, {0.5, 0.5}, 0.1).minima.empty());
  EXPECT_EQ(problem.asked, 0);
  EXPECT_FALSE(scan_around(problem, {0.5, 0.5}, 0.3).minima.empty());
  EXPECT_GT(problem.asked, 0);
}

TEST(ScanAround, TakesSomeHundredPlacesWhateverTheNumberOfParameters) {
  for (std::size_t p = 2; p <= 6; ++p) {
    const std::vector<double> centre(p, 0.5);
    const Bowl problem(centre, 0.5);
    scan_around(problem, centre, 0.1);
    EXPECT_GT(problem.asked, 50) << p;
    EXPECT_LT(problem.asked, 1000) << p;
  }
}

TEST(Scan, SaysHowLowABasinMayReach) {
  const Bowl problem({0.4321, 0.2345}, 2);
  const Scan scanned = scan(problem);
  ASSERT_EQ(scanned.minima.size(), 1u);
  EXPECT_LE(scanned.minima[0].reachable, 0);  // the cost of the minimum itself, between the grid's places
  EXPECT_GT(scanned.lowest, 0);
}

/// What tells a fit of areas whether to look closely.
TEST(BendsPassed, ChangeAsPointsPassTheirFold) {
  const double lambda = 0.3;
  Dataset data = empty_runs();
  add_run<WatersGuduru>(data, {lambda}, 3, 5, 0.9);
  FitOptions options;
  options.objective = Objective::area;
  const auto problem = make_problem<WatersGuduru>(data, options, prepare<WatersGuduru>(data, options, nullptr));
  const auto passed = [&](double at) { return problem->bends_passed(std::vector{at}); };
  EXPECT_EQ(passed(lambda), 0u);
  EXPECT_EQ(passed(0.99 * lambda), 0u);
  // the fold's load falls as lambda rises: one point after the other lies beyond it
  std::size_t before = 0;
  for (const double at : {0.3, 0.4, 0.5, 0.7, 1.0, 1.9}) {
    EXPECT_GE(passed(at), before) << at;
    before = passed(at);
  }
  EXPECT_GE(before, 2u);
  EXPECT_TRUE(scan_around(*problem, {lambda}, 0.01).minima.empty());
  EXPECT_FALSE(scan_around(*problem, {lambda}, 5).minima.empty());
}

}  // namespace
}  // namespace mixity
