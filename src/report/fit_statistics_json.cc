#include "report/fit_statistics_json.h"

namespace mixity {
Json interval_json(const std::optional<ShownInterval>& interval) {
  if (!interval) return {};
  return {{"method", interval->method},
          {"confidence", interval->confidence},
          {"low", number_or_null(interval->low)},
          {"high", number_or_null(interval->high)},
          {"low_status", to_string(interval->low_status)},
          {"high_status", to_string(interval->high_status)}};
}

Json errors_json(const FitResult& fit) {
  if (!fit.errors) return {};
  return {{"sigma_T", to_string(fit.errors->source_T)},
          {"sigma_A", to_string(fit.errors->source_A)},
          {"relative_scatter", number_or_null(fit.errors->scatter)},
          {"raised_T", fit.errors->raised_T},
          {"raised_A", fit.errors->raised_A}};
}

Json bootstrap_json(const FittedParameter& parameter, const FitResult& fit) {
  if (!fit.bootstrap || !parameter.bootstrap) return {};
  return {{"replicates", fit.bootstrap->replicates},
          {"failed", fit.bootstrap->failed},
          {"resampled", !fit.bootstrap->of_runs ? "points" : "curves"},
          {"seed", fit.bootstrap->seed},
          {"low", parameter.bootstrap->low},
          {"high", parameter.bootstrap->high},
          {"standard_deviation", parameter.bootstrap->standard_deviation},
          {"bias", parameter.bootstrap->bias}};
}

Json influence_json(const FitResult& fit, const Dataset& data) {
  if (!fit.influence) return {};
  std::vector<std::string> names;
  for (const FittedParameter& parameter : fit.parameters)
    if (!parameter.held) names.push_back(parameter.name);
  const auto change_json = [&](const std::vector<double>& change) {
    Json object = Json::object();
    for (std::size_t k = 0; k < names.size(); ++k) object[names[k]] = k < change.size() ? Json(change[k]) : Json();
    return object;
  };
  Json points = Json::array(), runs = Json::array();
  for (std::size_t i = 0; i < fit.influence->points.size(); ++i) {
    const PointInfluence& point = fit.influence->points[i];
    points.push_back({{"line", data.line_in_file(data.points[fit.used[i]].line)},
                      {"leverage", point.leverage},
                      {"cooks_distance", point.cooks_distance},
                      {"change", change_json(point.change)}});
  }
  for (std::size_t i = 0; i < fit.influence->runs.size(); ++i)
    runs.push_back({{"curve", fit.run_names[i]}, {"change", change_json(fit.influence->runs[i])}});
  return {{"points", points}, {"runs", runs}};
}

Json correlations_json(const FitResult& fit) {
  Json list = Json::array();
  std::vector<std::string> names;
  for (const FittedParameter& parameter : fit.parameters)
    if (!parameter.held) names.push_back(parameter.name);
  if (fit.correlations.size() != names.size() * names.size()) return list;
  for (std::size_t i = 0; i < names.size(); ++i)
    for (std::size_t j = i + 1; j < names.size(); ++j)
      list.push_back({{"parameters", {names[i], names[j]}}, {"value", fit.correlations[i * names.size() + j]}});
  return list;
}

Json comparison_json(const Analysis& result) {
  Json list = Json::array();
  for (const ComparedModel& entry : result.comparison) {
    Json runs = Json::array();
    if (entry.left_out)
      for (const LeftOut::Run& run : entry.left_out->runs)
        runs.push_back({{"curve", run.curve},
                        {"load", run.P * result.data.display.force_scale},
                        {"rmse_area", run.rmse_area},
                        {"points", run.points},
                        {"beyond_fold", run.beyond_fold}});
    list.push_back({{"model", entry.model},
                    {"aicc", number_or_null(entry.aicc)},
                    {"bic", number_or_null(entry.bic)},
                    {"weight", number_or_null(entry.weight)},
                    {"probability", number_or_null(entry.probability)},
                    {"loo_rmse_area", entry.left_out ? Json(entry.left_out->rmse_area) : Json()},
                    {"loo_beyond_fold", entry.left_out ? Json(entry.left_out->beyond_fold) : Json()},
                    {"loo_curves", runs}});
  }
  return list;
}

Json per_curve_json(const Analysis& result) {
  Json list = Json::array();
  for (const PerCurve& per_curve : result.per_curve) {
    Json curves = Json::array();
    for (const CurveFit& one : per_curve.curves) {
      Json parameters = Json::object();
      for (const FittedParameter& parameter : one.fit.parameters)
        parameters[parameter.name] = {{"value", number_or_null(parameter.value)},
                                      {"stderr", number_or_null(parameter.stderr_)},
                                      {"interval", interval_json(parameter.interval)}};
      curves.push_back({{"curve", one.curve},
                        {"load", result.data.has_loads ? Json(one.P * result.data.display.force_scale) : Json()},
                        {"load_dimensionless", result.data.has_loads ? Json(one.P) : Json()},
                        {"points", one.fit.used.size()},
                        {"status", to_string(one.fit.status)},
                        {"parameters", parameters}});
    }
    Json test;
    if (per_curve.test)
      test = {{"kind", per_curve.test->chi_squared ? "chi_squared" : "F"},
              {"statistic", per_curve.test->statistic},
              {"freedom", per_curve.test->freedom},
              {"residual_freedom", per_curve.test->residual_freedom},
              {"p_value", per_curve.test->p_value},
              {"aicc_pooled", number_or_null(per_curve.test->aicc_pooled)},
              {"aicc_separate", number_or_null(per_curve.test->aicc_separate)}};
    list.push_back({{"model", per_curve.model},
                    {"curves", curves},
                    {"fitted", per_curve.fitted},
                    {"test", test},
                    {"untested", per_curve.test ? Json() : Json(per_curve.untested)}});
  }
  return list;
}

}  // namespace mixity
