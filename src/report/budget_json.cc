#include "fitting/consistency.h"
#include "report/fit_statistics_json.h"

namespace mixity {
namespace {

Json exact_json(const ExactConstant& one) {
  Json json = {{"constant", one.constant},
               {"unit", one.unit},
               {"step", one.step},
               {"effect", number_or_null(one.effect)},
               {"score", Json()}};
  if (one.score)
    json["score"] = {{"chi2_fall", one.score->fall}, {"value", one.score->value}, {"p_value", one.score->p_value}};
  return json;
}

}  // namespace

Json prior_json(const FittedParameter& parameter) {
  if (!parameter.prior) return {};
  return {{"mean", parameter.prior->mean},
          {"standard_error", parameter.prior->standard_error},
          {"distribution", parameter.prior->logarithmic ? "log-normal" : "normal"}};
}

Json evidence_json(const FitResult& fit) {
  if (!fit.evidence) return {};
  const Evidence& evidence = fit.evidence->evidence;
  return {{"parameter", fit.evidence->parameter},
          {"prior", to_string(fit.evidence->prior)},
          {"log_evidence", evidence.log_evidence},
          {"mean", evidence.mean},
          {"standard_deviation", evidence.standard_deviation},
          {"credibility", fit.evidence->confidence},
          {"low", evidence.low},
          {"high", evidence.high}};
}

Json budget_json(const FitResult& fit) {
  if (!fit.budget) return {};
  Json parts = Json::array(), exact = Json::array();
  for (const BudgetPart& part : fit.budget->parts)
    parts.push_back({{"constant", part.constant}, {"share", part.share}, {"pull", part.pull}});
  for (const ExactConstant& one : fit.budget->exact) exact.push_back(exact_json(one));
  return {{"parameter", fit.budget->parameter},
          {"method", "joint covariance"},
          {"scatter", number_or_null(fit.budget->scatter)},
          {"parts", parts},
          {"taken_as_exact", exact},
          {"independent_score_tests", fit.budget->independent}};
}

Json consistency_json(const FitResult& fit, const Dataset& data) {
  if (!fit.consistency) return {};
  const Consistency& tests = *fit.consistency;
  Json runs = Json::array(), beyond = Json::array();
  for (const ResidualTests::Run& run : tests.residuals.runs)
    runs.push_back({{"curve", run.curve},
                    {"points", run.points},
                    {"runs_z", run.runs},
                    {"correlation", run.correlation},
                    {"trend_z", run.trend}});
  for (const BeyondEquilibrium& run : tests.beyond) {
    const Point& first = data.points[run.first];
    beyond.push_back({{"curve", run.curve},
                      {"points", run.points},
                      {"first_line", data.line_in_file(first.line)},
                      {"T", first.T * data.display.force_scale}});
  }
  return {{"chi2_per_freedom", number_or_null(tests.chi2_per_freedom)},
          {"chi2_p_value", number_or_null(tests.chi2_p)},
          {"correlation", tests.residuals.correlation},
          {"correlation_p_value", tests.residuals.correlation_p},
          {"runs_p_value", tests.residuals.runs_p},
          {"trend_p_value", tests.residuals.trend_p},
          {"ends_z", tests.residuals.ends},
          {"ends_p_value", tests.residuals.ends_p},
          {"runs", runs},
          {"beyond_equilibrium", beyond}};
}

Json unsheared_json(const std::optional<UnshearedTest>& test) {
  if (!test) return {};
  Json implied = Json::array();
  for (const UnshearedTest::Implied& one : test->implied)
    implied.push_back({{"constant", one.constant},
                       {"unit", one.unit},
                       {"stated", one.stated},
                       {"value", one.value},
                       {"standard_error", one.standard_error},
                       {"chi2", one.chi2},
                       {"p_value", one.p_value}});
  return {{"points", test->points},
          {"loads", test->loads},
          {"chi2", test->chi2},
          {"p_value", test->p_value},
          {"agrees", test->p_value >= kChance},
          {"implied", implied}};
}

Json constants_json(const Dataset& data) {
  const Metadata& metadata = data.metadata;
  Json list = Json::array();
  const auto add = [&](const char* name, const std::optional<double>& value, double error, const char* unit) {
    if (value) list.push_back({{"constant", name}, {"value", *value}, {"standard_error", error}, {"unit", unit}});
  };
  const auto stated = [&](const char* name, const std::optional<double>& value, const char* unit) {
    add(name, value, metadata.standard_error(name), unit);
  };
  stated("radius", metadata.radius, "m");
  const auto modulus = metadata.plane_strain_modulus();
  add("modulus", modulus, modulus ? metadata.modulus_error() * *modulus : 0, "Pa");
  stated("toughness", metadata.toughness, "J/m^2");
  stated("toughness_II", metadata.toughness_II, "J/m^2");
  stated("shear_strength", metadata.shear_strength, "Pa");
  stated("area_scale", metadata.area_scale, "");
  stated("load_offset", metadata.load_offset, "N");
  stated("shear_offset", metadata.shear_offset, "N");
  stated("area_offset", metadata.area_offset, "m^2");
  return list;
}

}  // namespace mixity
