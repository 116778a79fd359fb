#include "fitting/heavy_points.h"
#include "report/fit_fields.h"

namespace mixity {
namespace {

struct InfluenceOfRun {
  std::string curve;
  Named<std::optional<double>> change;
};

std::vector<std::string> free_parameters(const FitResult& fit) {
  std::vector<std::string> names;
  for (const FittedParameter& parameter : fit.parameters)
    if (!parameter.held) names.push_back(parameter.name);
  return names;
}

Named<std::optional<double>> changes(const FitResult& fit, const std::vector<double>& change) {
  Named<std::optional<double>> named;
  for (std::string& name : free_parameters(fit)) {
    const std::size_t k = named.size();
    named.emplace_back(std::move(name), k < change.size() ? std::optional(change[k]) : std::nullopt);
  }
  return named;
}

std::vector<InfluenceOfRun> influence_of_runs(const FitResult& fit) {
  std::vector<InfluenceOfRun> list;
  for (std::size_t i = 0; i < fit.influence->runs.size(); ++i)
    list.push_back({fit.run_names[i], changes(fit, fit.influence->runs[i])});
  return list;
}

}  // namespace

std::vector<Correlation> correlations(const FitResult& fit) {
  std::vector<Correlation> list;
  const std::vector<std::string> names = free_parameters(fit);
  if (fit.correlations.size() != names.size() * names.size()) return list;
  for (std::size_t i = 0; i < names.size(); ++i)
    for (std::size_t j = i + 1; j < names.size(); ++j)
      list.push_back({{names[i], names[j]}, fit.correlations[i * names.size() + j]});
  return list;
}

void describe(Fields<Correlation>& field) {
  field("parameters", "two names", R"({"minItems": 2, "maxItems": 2})", &Correlation::parameters);
  field("value", "-1 to 1", R"({"minimum": -1.000001, "maximum": 1.000001})", &Correlation::value);
}

void describe(Fields<PointInfluence>& field) {
  field("line", "line in the file", [](const PointInfluence& point, const Within& in) {
    const auto index = static_cast<std::size_t>(&point - in.fit->influence->points.data());
    const Dataset& data = in.result->data;
    return data.line_in_file(data.points[in.fit->used[index]].line);
  });
  field("leverage", "0 to 1", &PointInfluence::leverage);
  field("cooks_distance", "Cook's distance", &PointInfluence::cooks_distance);
  field("change", "change of each free parameter if the point is left out; null if that fit fails",
        [](auto& point, auto& in) { return changes(*in.fit, point.change); });
}

void describe(Fields<InfluenceOfRun>& field) {
  field("curve", "name of the run", &InfluenceOfRun::curve);
  field("change", "change of each free parameter if the run is left out", &InfluenceOfRun::change);
}

void describe(Fields<Influence>& field) {
  field("points", "of each used point", &Influence::points);
  field("runs", "of each run", [](auto&, auto& in) { return influence_of_runs(*in.fit); });
}

void describe(Fields<ShownEvidence>& field) {
  const auto found = [](const auto member) {
    return [member](const ShownEvidence& shown) { return shown.evidence.*member; };
  };
  field("parameter", "the first free parameter", &ShownEvidence::parameter);
  field("prior", "prior of the parameter over its range", &ShownEvidence::prior);
  field("prior_from", "where a log-uniform prior begins; null for a uniform one", &ShownEvidence::prior_from);
  field("log_evidence",
        "natural logarithm of the likelihood averaged over the priors, without factors that all models of the same "
        "points share",
        found(&Evidence::log_evidence));
  field("mean", "posterior mean of the parameter", found(&Evidence::mean));
  field("standard_deviation", "of the posterior", found(&Evidence::standard_deviation));
  field("credibility", "probability of the credible interval", &ShownEvidence::confidence);
  field("low", "lower end of the credible interval", found(&Evidence::low));
  field("high", "upper end of the credible interval", found(&Evidence::high));
}

void describe(Fields<BudgetPart>& field) {
  field("constant", "name of the constant", &BudgetPart::constant);
  field("share", "part of the variance", &BudgetPart::share);
  field("pull", "how far the constant moved from what was stated, in its standard errors", &BudgetPart::pull);
}

void describe(Fields<ExactConstant::Score>& field) {
  field("chi2_fall", "by how much chi^2 would fall if the constant were free", &ExactConstant::Score::fall);
  field("value", "the value that it would take", &ExactConstant::Score::value);
  field("p_value", "probability of so large a fall by chance", &ExactConstant::Score::p_value);
}

void describe(Fields<ExactConstant>& field) {
  field("constant", "name of the constant", &ExactConstant::constant);
  field("unit", "unit of `step`; empty if dimensionless", &ExactConstant::unit);
  field("step", "5 % of the constant; of an offset, 1 % of the largest load, shear or area", &ExactConstant::step);
  field("effect", "change of the budget's parameter if the constant grows by `step`", &ExactConstant::effect);
  field("score", "score test of the constant; null if the residuals do not depend on it", &ExactConstant::score);
}

void describe(Fields<Budget>& field) {
  field("parameter", "the parameter whose variance is split: the first free one", &Budget::parameter);
  field("method", "how the variance is split", R"({"const": "joint covariance"})",
        [](auto&) { return "joint covariance"; });
  field("scatter", "part of the variance that comes from the scatter; all parts add up to 1", &Budget::scatter);
  field("parts", "parts of constants that were stated with a standard error", &Budget::parts);
  field("taken_as_exact", "constants without a standard error", &Budget::exact);
  field("independent_score_tests", "effective number of independent score tests", &Budget::independent);
}

void describe(Fields<Explanation>& field) {
  field("cause", "a constant that is wrong, or a quantity that differs between the runs", &Explanation::cause);
  field("run", "the run, if one alone differs; else null",
        [](auto& one) { return one.run.empty() ? std::optional<std::string>() : std::optional(one.run); });
  field("size", "what it would be", [](auto& one, auto& in) { return worded(one.size, in); });
  field("remedy", "options that fit it", [](auto& one, auto& in) { return worded(one.remedy, in); });
  field("parameter", "the first free parameter", [](auto& one) { return std::string(one.first.name); });
  field("value", "its value then", [](auto& one) { return one.first.value; });
  field("stderr", "its standard error then", [](auto& one) { return one.first.stderr_; });
  field("misfit", "-2 ln L above that of the best explanation", &Explanation::misfit);
}

void describe(Fields<RunTest::Way>& field) {
  field("chi2_fall", "by how much chi^2 would fall if the runs differed so", &RunTest::Way::fall);
  field("p_value", "probability of so large a fall by chance", &RunTest::Way::p_value);
  field("size", "of the difference, in `unit`, or as a share of a factor", &RunTest::Way::size);
  field("change", "of the first parameter then, in its standard errors", &RunTest::Way::change);
  field("widening", "factor on its standard error then", &RunTest::Way::widening);
}

void describe(Fields<RunTest>& field) {
  field("quantity", "the first parameter that is fitted, or a constant of the experiment", &RunTest::quantity);
  field("unit", "of the sizes; empty of a factor and of a number", &RunTest::unit);
  field("all", "the runs differ by chance; size: standard deviation", &RunTest::all);
  field("odd", "one run differs from the others; p_value: of the best of all runs", &RunTest::odd);
  field("odd_run", "its name", [](auto& test, auto& in) { return in.result->data.curves[test.run]; });
  field("drift", "a change in the order of the runs; size: from the first to the last", &RunTest::drift);
}

void describe(Fields<ResidualTests::Run>& field) {
  field("curve", "name of the run", &ResidualTests::Run::curve);
  field("points", "number of points", &ResidualTests::Run::points);
  field("runs_z", "z of the number of runs of one sign", &ResidualTests::Run::runs);
  field("correlation", "correlation of neighbours", &ResidualTests::Run::correlation);
  field("trend_z", "z of the slope against T, or against psi", &ResidualTests::Run::trend);
}

void describe(Fields<BeyondEquilibrium>& field) {
  const auto first = [](const BeyondEquilibrium& run, const Within& in) -> const Point& {
    return in.result->data.points[run.first];
  };
  field("curve", "name of the run", &BeyondEquilibrium::curve);
  field("points", "number of points beyond the last equilibrium", &BeyondEquilibrium::points);
  field("first_line", "line of the first of them",
        [=](auto& run, auto& in) { return in.result->data.line_in_file(first(run, in).line); });
  field("T", "its tangential load, in the unit of the file",
        [=](auto& run, auto& in) { return first(run, in).T * in.result->data.display.force_scale; });
}

void describe(Fields<HeavyPoints>& field) {
  field("lines", "lines of the points", [](auto& heavy, auto& in) { return lines_of(heavy, in.result->data); });
  field("share", "of the weight of all points, 0.5..1", &HeavyPoints::share);
  field("column", "column with the error that is the smallest beside those of the others", &HeavyPoints::column);
  field("ratio", "of that error and the median of the column", &HeavyPoints::ratio);
}

void describe(Fields<CircleTest>& field) {
  field("ratio", "by what factor a/b has changed at the largest shear", &CircleTest::ratio);
  field("p_value", "of that change by chance", &CircleTest::p_value);
}

void describe(Fields<PullOffTest>& field) {
  field("F", "of an offset and a curvature along the shear; 0 where they are too small to count", &PullOffTest::F);
  field("p_value", "its p-value", &PullOffTest::p_value);
}

void describe(Fields<Consistency>& field) {
  const auto of_residuals = [](const auto member) {
    return [member](const Consistency& tests) { return tests.residuals.*member; };
  };
  field("chi2_per_freedom",
        "chi^2 per degree of freedom, with a robust loss by the median residual; null if errors are estimated",
        &Consistency::chi2_per_freedom);
  field("chi2_p_value", "probability of so large a chi^2", &Consistency::chi2_p);
  field("correlation", "correlation of neighbouring residuals", of_residuals(&ResidualTests::correlation));
  field("correlation_p_value", "its p-value", of_residuals(&ResidualTests::correlation_p));
  field("runs_p_value", "p-value of the number of runs of one sign", of_residuals(&ResidualTests::runs_p));
  field("trend_p_value", "p-value of trends within the runs", of_residuals(&ResidualTests::trend_p));
  field("ends_z", "z of the residuals at the ends of the runs", of_residuals(&ResidualTests::ends));
  field("ends_p_value", "its p-value", of_residuals(&ResidualTests::ends_p));
  field("runs", "the same tests of each run with at least 8 points", of_residuals(&ResidualTests::runs));
  field("heavy_points",
        "few points that carry most of the weight, by stated errors far below the others'; null without",
        &Consistency::heavy);
  field("circle",
        "of measured axes, by what their ratio changes along the shear, of an ellipse beyond the fit; null where none "
        "were measured",
        &Consistency::circle);
  field("pull_off", "whether pull-off loads leave the fit as the shear grows; null with fewer than six",
        &Consistency::pull_off);
  field("beyond_equilibrium", "runs with points beyond the last equilibrium of the model", &Consistency::beyond);
}

}  // namespace mixity
