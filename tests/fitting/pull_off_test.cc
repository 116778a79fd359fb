// Fits of pull-off loads, alone and with areas. The data are made by a search of their own: the printed equation y^2 +
// T^2 = 8 pi a^3 f(psi) on grids of edge loads and radii.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>

#include "base/number_text.h"
#include "dataset/load_text.h"
#include "dataset/pooled.h"
#include "fitting/curve_objective.h"
#include "fitting/fit.h"
#include "fitting/problem_checks.h"
#include "fitting/pull_off_rows.h"

namespace mixity {
namespace pull_off_test {

using std::numbers::pi;

double f_of(const std::string& model, double lambda, double psi) {
  if (model == "c") return 1 / (1 + (lambda - 1) * std::pow(std::sin(psi), 2));
  return 1 + std::pow(std::tan((1 - lambda / 2) * psi), 2);
}

/// The least P over a grid of edge loads that is narrowed around its least value.
double searched_pull_off(const std::string& model, double lambda, double T) {
  double low = 1e-3, high = 80, least = INFINITY;
  for (int round = 0; round < 6; ++round) {
    const double step = (high - low) / 400;
    double at = low;
    for (int i = 0; i <= 400; ++i) {
      const double y = low + i * step, P = (y * y + T * T) / (6 * pi * f_of(model, lambda, std::atan2(T, y))) - y;
      if (P < least) {
        least = P;
        at = y;
      }
    }
    low = std::max(at - 2 * step, 1e-9);
    high = at + 2 * step;
  }
  return least;
}

/// The area at the largest radius that fulfils the equation.
double searched_area(const std::string& model, double lambda, double P, double T) {
  double before = 0;
  for (double a = 6; a > 0.3; a -= 1e-3) {
    const auto rest = [&](double radius) {
      const double y = 4.0 / 3 * radius * radius * radius - P;
      return y * y + T * T - 8 * pi * radius * radius * radius * f_of(model, lambda, std::atan2(T, y));
    };
    const double here = rest(a);
    if (before > 0 && here <= 0) {
      double low = a, high = a + 1e-3;
      for (int i = 0; i < 50; ++i) (rest((low + high) / 2) > 0 ? high : low) = (low + high) / 2;
      return pi * low * low;
    }
    before = here;
  }
  return NAN;
}

struct Experiment {
  std::string pull_off = "P_c,T,sigma_P,sigma_T\n", areas = "P,T,A,sigma_T,sigma_A\n";
};

/// Twelve pull-off loads up to T = 22, and two runs of ten areas far below their jump.
Experiment experiment(const std::string& model, double lambda, unsigned seed) {
  using Key = std::pair<std::string, double>;
  static std::map<Key, std::vector<std::pair<double, double>>> loads;
  static std::map<Key, std::vector<std::array<double, 3>>> areas;
  auto& of_loads = loads[{model, lambda}];
  auto& of_areas = areas[{model, lambda}];
  for (int i = 0; of_loads.size() < 12; ++i) of_loads.emplace_back(2.0 * i, searched_pull_off(model, lambda, 2.0 * i));
  for (const double P : {1.0, 4.0})
    for (int i = 0; of_areas.size() < (P == 1 ? 10u : 20u); ++i)
      of_areas.push_back({P, 2.0 * i, searched_area(model, lambda, P, 2.0 * i)});
  SeededNoise noise(seed, 1);
  Experiment made;
  for (const auto& [T, P] : of_loads)
    made.pull_off += shortest(P + 0.05 * noise()) + ',' + shortest(T + 0.15 * noise()) + ",0.05,0.15\n";
  for (const auto& [P, T, A] : of_areas)
    made.areas += shortest(P) + ',' + shortest(T + 0.1 * noise()) + ',' + shortest(A * (1 + 0.005 * noise())) +
                  ",0.1," + shortest(0.005 * A) + '\n';
  return made;
}

/// How many of 40 experiments' 95 % intervals hold the truth.
int covered(const std::string& model, double lambda, bool with_areas) {
  int count = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const Experiment made = experiment(model, lambda, seed);
    const TemporaryFolder folder;
    std::vector<RunFile> files{{folder.write("pull.csv", made.pull_off)}};
    if (with_areas) files.push_back({folder.write("areas.csv", made.areas)});
    const FitResult fit = fit_model(load_pooled(files), model);
    EXPECT_EQ(fit.pull_off, 12u);
    EXPECT_EQ(fit.used.size(), with_areas ? 20u : 0u);
    const auto& interval = fit.parameters[0].interval;
    EXPECT_TRUE(interval && interval->low && interval->high) << seed;
    count += interval && *interval->low <= lambda && lambda <= *interval->high;
  }
  return count;
}

// Of 40 intervals of 95 % fewer than 34 hold the truth in 0.7 % of all series of experiments.
TEST(PullOffFit, OfLoadsAloneCoversLambda) {
  EXPECT_GE(covered("c", 0.02, false), 34);
  EXPECT_GE(covered("b", 0.15, false), 34);
}
TEST(PullOffFit, WithAreasCoversLambda) {
  EXPECT_GE(covered("c", 0.02, true), 34);
  EXPECT_GE(covered("b", 0.15, true), 34);
}

TEST(PullOffFit, WithAreasIsMoreAccurateThanEither) {
  const Experiment made = experiment("c", 0.02, 3);
  const TemporaryFolder folder;
  const std::string pull = folder.write("pull.csv", made.pull_off), areas = folder.write("areas.csv", made.areas);
  const auto error = [](const std::vector<RunFile>& files) {
    return *fit_model(load_pooled(files), "c").parameters[0].stderr_;
  };
  const double of_loads = error({{pull}}), of_areas = error({{areas}}), of_both = error({{pull}, {areas}});
  // independent data: weights add up, but for the curvature of the cost
  EXPECT_NEAR(1 / (of_both * of_both), 1 / (of_loads * of_loads) + 1 / (of_areas * of_areas),
              0.1 / (of_both * of_both));
}

/// Without errors stated the scatter gives them.
TEST(PullOffFit, FindsTheErrorOfLoadsThatStateNone) {
  std::string csv = "P_c,T\n";
  SeededNoise noise(5, 1);
  for (int i = 0; i < 40; ++i)
    csv += shortest(-1.5 * pi + 0.02 * i * i * 0.25 / (6 * pi) + 0.05 * noise()) + ',' + shortest(0.5 * i) + '\n';
  const TemporaryFolder folder;
  const FitResult alone = fit_model(load_dataset(folder.write("p.csv", csv)), "c");
  EXPECT_EQ(alone.status, FitStatus::ok) << alone.message.text();
  EXPECT_FALSE(alone.known_errors);
  EXPECT_NEAR(*alone.parameters[0].value, 0.02, 4 * *alone.parameters[0].stderr_);
  const FitResult both =
      fit_model(load_pooled({{folder.path("p.csv")}, {folder.write("a.csv", experiment("c", 0.02, 3).areas)}}), "c");
  EXPECT_NEAR(both.errors->pull_off, 0.05, 0.02);  // its own error is a ninth of it
}

/// A series of loads and one of areas, fitted together; no error of the loads is stated.
FitResult fit_of_series(double lambda_of_loads, double lambda_of_areas, unsigned seed) {
  const TemporaryFolder folder;
  std::string pull = "P_c,T\n";
  std::istringstream rows(experiment("c", lambda_of_loads, seed).pull_off);
  std::string row;
  for (std::getline(rows, row); std::getline(rows, row);)
    pull += row.substr(0, row.find(',', row.find(',') + 1)) + '\n';
  return fit_model(load_pooled({{folder.write("pull.csv", pull)},
                                {folder.write("areas.csv", experiment("c", lambda_of_areas, seed).areas)}}),
                   "c");
}

/// An error that comes from the scatter about the fit would absorb the contradiction.
TEST(PullOffFit, LoadsThatContradictTheAreasAreSuspect) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const FitResult fit = fit_of_series(0.2, 0.02, seed);
    EXPECT_EQ(fit.status, FitStatus::suspect) << fit.message.text();
    EXPECT_NE(fit.message.text().find("pull-off loads"), std::string::npos) << fit.message.text();
  }
}
TEST(PullOffFit, LoadsThatAgreeWithTheAreasAreBelieved) {
  for (unsigned seed = 1; seed <= 10; ++seed) EXPECT_EQ(fit_of_series(0.02, 0.02, seed).status, FitStatus::ok) << seed;
}

/// A load cell that is off is named and mended.
TEST(PullOffFit, FreesConstantsOfTheExperiment) {
  std::string csv = "P_c,T,sigma_P\n";
  for (int i = 0; i < 40; ++i)
    csv += shortest(searched_pull_off("c", 0.02, 0.6 * i) - 0.3) + ',' + shortest(0.6 * i) + ",0.05\n";
  const FitResult fit = fit_model(load_text(csv), "c", {.free = {kLoadOffset}});
  EXPECT_EQ(fit.status, FitStatus::ok) << fit.message.text();
  EXPECT_NEAR(*fit.parameters[0].value, 0.02, 1e-6);  // the search of the data
  EXPECT_NEAR(*fit.parameters[1].value, 0.3, 1e-6);
  const FitResult fixed = fit_model(load_text(csv), "c");
  EXPECT_EQ(fixed.status, FitStatus::suspect);
  EXPECT_NE(fixed.message.text().find("load_offset"), std::string::npos) << fixed.message.text();
}

TEST(PullOffFit, HasDerivativesInParametersAndConstants) {
  for (const char* key : {"a", "b", "c", "bk"}) {
    const ContactModel model = *ContactModel::find(key);
    const ParameterValues p = std::string(key) == "bk" ? ParameterValues{1.5, 2.0} : ParameterValues{0.1};
    MeasuredPoints points(std::vector<MeasuredPoint>{});
    auto list = std::make_shared<std::vector<MeasuredPullOff>>();
    for (const HeldShear held : {HeldShear::load, HeldShear::displacement})
      for (const double shear : {0.5, 2.0, -4.0})
        for (const double sigma_shear : {0.0, 0.2}) list->push_back({held, -4 + 0.1 * shear, shear, 0.05, sigma_shear});
    points.pull_off = list;
    // the constants that act on forces and displacements, and not on areas or single runs
    constexpr Constant kActing[]{kToughness, kModulus, kRadius, kForceGain, kLoadOffset, kShearOffset};
    Candidate base;
    base.constants.shear_weight = 1.2;
    FreeChoice choice(model, base, {});
    for (const Constant c : kActing) choice.add(c, {std::string(kConstantNames[c]), -1, 1, 0.0});
    const CurveObjective objective(points, choice);
    ASSERT_EQ(objective.residual_count(), 12u);
    for (const Constants& constants : kSomeConstants) {
      std::vector<double> x(p.begin(), p.end());
      for (const Constant c : kActing) x.push_back(constants[c]);
      // the nearest place is found to 1e-9 of its size, of which a slope over steps of 3e-4 keeps 1e-5
      expect_jacobian(objective, x, 1e-5, key);
    }
  }
}

TEST(PullOffFit, RefusesWhatPullOffLoadsCannotTell) {
  const Experiment made = experiment("c", 0.02, 3);
  const TemporaryFolder folder;
  const Dataset data = load_pooled({{folder.write("p.csv", made.pull_off)}, {folder.write("a.csv", made.areas)}}),
                alone = load_dataset(folder.path("p.csv"));
  const auto message = [](const Dataset& of, const char* model, const FitOptions& options) {
    return input_error([&] { fit_model(of, model, options); });
  };
  EXPECT_NE(message(data, "c-ellipse", {}).find("circular contacts"), std::string::npos);
  EXPECT_NE(message(alone, "c", {.objective = Objective::toughness}).find("no phase angle"), std::string::npos);
  EXPECT_NE(message(data, "c", {.by_run = {"lambda"}}).find("belong to no run"), std::string::npos);
  FitOptions bootstrap;
  bootstrap.bootstrap.replicates = 10;
  EXPECT_NE(message(data, "c", bootstrap).find("not resampled"), std::string::npos);
}

}  // namespace pull_off_test
}  // namespace mixity
