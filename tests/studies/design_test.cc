// What a plan is expected to tell is what experiments of it tell.
#include "studies/design.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>

#include "mechanics/contact.h"
#include "mechanics/contact_model.h"
#include "studies/simulate.h"

namespace mixity {
namespace design_test {

StatedError stated(const std::string& text) { return *parse_quantity(text); }

Plan plan_of(const std::string& model, double lambda, const std::string& modulus = "2.133 MPa +/- 3%") {
  Plan plan;
  plan.model = model;
  plan.parameters = {lambda};
  for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{
           {"radius", "9.42 mm"}, {"modulus", modulus}, {"toughness", "27 mJ/m^2"}, {"load_offset", "0 +/- 0.05 mN"}})
    EXPECT_EQ(set_field(plan.constants, name, text), "");
  plan.loads = {1e-3, 4e-3};
  plan.sigma_T = stated("1%");
  plan.sigma_A = stated("1%");
  return plan;
}

TEST(Simulate, AnExperimentIsAFunctionOfSeedAndIndex) {
  const Plan plan = plan_of("c", 0.01);
  const Dataset one = simulate(plan, 7, 3), again = simulate(plan, 7, 3), other = simulate(plan, 7, 4),
                stream = simulate(plan, 8, 3);
  ASSERT_EQ(one.points.size(), 50u);
  EXPECT_EQ(one.curves.size(), 2u);
  EXPECT_EQ(one.metadata.provenance, Provenance::reconstructed);
  for (std::size_t i = 0; i < one.points.size(); ++i) {
    EXPECT_EQ(one.points[i].A, again.points[i].A);
    EXPECT_NE(one.points[i].A, other.points[i].A);
    EXPECT_NE(one.points[i].A, stream.points[i].A);
  }
}

TEST(Simulate, RunsAreCalledByTheirLoadsAndNumberedOnlyWhereALoadIsRepeated) {
  Plan plan = plan_of("c", 0.01);
  plan.loads = {1e-3, 4e-3, 1e-3};
  EXPECT_EQ(simulate(plan, 1, 0).curves, (std::vector<std::string>{"P=1 mN", "P=4 mN", "P=1 mN (2)"}));
}

TEST(Simulate, WithoutChanceItIsTheModelWithTheStatedConstants) {
  const Plan plan = plan_of("b", 0.3);
  const Dataset data = simulate(plan, 1, std::nullopt);
  const ContactModel model = ContactModel::find("b").value();
  for (const Point& point : data.points) {
    double A = 0;
    EquilibriumStatus status{};
    model.areas_at(plan.parameters, point.P, {&point.T, 1}, {&A, 1}, {&status, 1});
    EXPECT_NEAR(point.A, A, 1e-12 * A);  // through mN and mm^2 and back
  }
}

TEST(Simulate, ReadingsScatterByWhatIsStated) {
  Plan plan = plan_of("c", 0.01, "2.133 MPa");
  plan.constants.standard_errors.clear();
  const Dataset mean = simulate(plan, 1, std::nullopt);
  double squares = 0, n = 0;
  for (std::uint64_t k = 0; k < 200; ++k) {
    const Dataset data = simulate(plan, 1, k);
    for (std::size_t i = 0; i < data.points.size(); ++i, ++n)
      squares += std::pow((data.points[i].A - mean.points[i].A) / mean.errors[i].A, 2);
  }
  EXPECT_NEAR(squares / n, 1, 4 * std::sqrt(2 / n));  // four standard errors of a variance
}

TEST(Plan, ThatCannotBeDoneSaysWhy) {
  const auto problem = [](auto change) {
    Plan plan = plan_of("c", 0.01);
    change(plan);
    return problem_of(plan);
  };
  EXPECT_EQ(problem([](Plan&) {}), "");
  EXPECT_NE(problem([](Plan& p) { p.model = "x"; }), "");
  EXPECT_NE(problem([](Plan& p) { p.parameters = {2}; }), "");
  EXPECT_EQ(problem([](Plan& p) { p.constants.radius.reset(); }), "radius, modulus and toughness must be stated");
  EXPECT_EQ(problem([](Plan& p) { p.loads.clear(); }), "a plan needs a load");
  EXPECT_EQ(problem([](Plan& p) { p.loads = {-1}; }), "a load lies at or below pull-off");
  EXPECT_EQ(problem([](Plan& p) { p.points = 2; }), "a run needs three points");
  EXPECT_NE(problem([](Plan& p) { p.reach = 1.1; }), "");
  EXPECT_NE(problem([](Plan& p) { p.sigma_A = *parse_quantity("1 mN"); }), "");
}

TEST(Design, ForetellsTheSpreadOfExperiments) {
  for (const auto& [model, lambda] : std::vector<std::pair<std::string, double>>{{"c", 0.01}, {"b", 0.4}, {"a", 0.3}}) {
    const Plan plan = plan_of(model, lambda);
    const double expected = expect(plan, {}).standard_error.value();
    const Outcome outcome = try_plan(plan, 5, 500, {});
    EXPECT_EQ(outcome.with_value, 500u);
    // 500 experiments tell a spread to 3.2 %; 10 % are what a plan is to be right to
    EXPECT_NEAR(expected / outcome.spread, 1, 0.1) << model << ' ' << expected << ' ' << outcome.spread;
    EXPECT_NEAR(outcome.covered, 0.95, 0.03) << model;
  }
}

Plan held_plan(const std::string& model, double lambda, const std::string& stiffness) {
  Plan plan = plan_of(model, lambda);
  plan.constants.standard_errors.clear();
  plan.constants.control = NormalControl::approach;
  plan.loads = {3e-6, 8e-6, 15e-6};
  for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{
           {"modulus", "2.133 MPa +/- 1%"}, {"approach_offset", "0 +/- 0.2 um"}, {"normal_stiffness", stiffness}})
    if (!text.empty()) {
      EXPECT_EQ(set_field(plan.constants, name, text), "");
    }
  return plan;
}

TEST(Design, ForetellsTheSpreadOfExperimentsAtHeldApproaches) {
  for (const auto& [model, lambda, stiffness] : std::vector<std::tuple<std::string, double, std::string>>{
           {"c", 0.05, ""}, {"b", 0.3, "1.2 kN/m"}, {"a", 0.3, ""}}) {
    const Plan plan = held_plan(model, lambda, stiffness);
    const double expected = expect(plan, {}).standard_error.value();
    const Outcome outcome = try_plan(plan, 5, 200, {});
    EXPECT_EQ(outcome.with_value, 200u);
    // 200 experiments tell a spread to 5 %: three standard errors
    EXPECT_NEAR(expected / outcome.spread, 1, 0.15) << model << ' ' << expected << ' ' << outcome.spread;
    EXPECT_NEAR(outcome.covered, 0.95, 0.045) << model;  // three standard errors of 200
  }
}

/// A wrong model's misfit bends each run the same way, which is no correlated noise: the runs add up.
TEST(Design, TheOddsAgainstARivalAddUpOverTheRuns) {
  Plan plan = plan_of("c", 0.05, "2.133 MPa");
  plan.constants.standard_errors.clear();
  for (const NormalControl control : {NormalControl::load, NormalControl::approach}) {
    plan.constants.control = control;
    const double scale = control == NormalControl::load ? 1e-3 : 3e-6;
    double sum = 0;
    for (const double load : {1.0, 3.0, 5.0}) {
      plan.loads = {load * scale};
      sum += expect(plan, {"b"}).least_chi2();
    }
    plan.loads = {scale, 3 * scale, 5 * scale};
    const double all = expect(plan, {"b"}).least_chi2();
    // one lambda fits all runs worse than each its own, by what these differ
    EXPECT_GE(all, sum);
    EXPECT_LE(all, 1.3 * sum);
  }
}

TEST(Design, TheChosenLoadsBeatEqualSpacing) {
  Plan plan = plan_of("c", 0.01);
  plan.loads.clear();
  const Plan chosen = best_plan(plan, 0.5e-3, 10e-3, 4, Goal::error, {});
  ASSERT_EQ(chosen.loads.size(), 4u);
  Plan even = plan;
  for (int i = 0; i < 4; ++i) even.loads.push_back(0.5e-3 + 9.5e-3 * i / 3);
  const double best = expect(chosen, {}).standard_error.value(), equal = expect(even, {}).standard_error.value();
  EXPECT_LT(best, 0.97 * equal);
  // and in experiments, by as much
  const double gain = try_plan(even, 2, 500, {}).spread / try_plan(chosen, 2, 500, {}).spread;
  EXPECT_NEAR(gain, equal / best, 0.12 * gain);  // 3.2 % of each spread, 2.7 standard errors
}

TEST(Design, MoreRunsTellModelsApart) {
  Plan plan = plan_of("c", 0.3);
  plan.reach = 0.6;
  const double two = expect(plan, {"a", "b", "c"}).least_chi2();
  ASSERT_EQ(expect(plan, {"a", "b", "c"}).rivals.size(), 2u);
  plan.loads.insert(plan.loads.end(), {1e-3, 4e-3});
  EXPECT_NEAR(expect(plan, {"a", "b"}).least_chi2() / two, 2, 0.2);  // but for what is known beforehand
}

}  // namespace design_test
}  // namespace mixity
