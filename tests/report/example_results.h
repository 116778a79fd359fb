// Results for tests of outputs: made up, or of the shipped data sets.
#pragma once

#include <map>
#include <string>

#include "analysis/fit_definition.h"
#include "analysis/reported_data.h"

namespace mixity {

/// A fit as it stands in outputs, made up, one for each status.
inline Analysis example(FitStatus status) {
  Analysis result;
  result.data.path = "data/example.csv";
  result.data.name = "example";
  result.data.metadata.provenance = Provenance::measured;
  result.data.metadata.source = "Bench 3, 2026-05-04";
  result.data.has_loads = true;
  result.data.rows = 42;
  result.data.points.resize(40);
  result.data.curves = {"P=1", "P=3"};
  result.data.display.area = "mm^2";
  result.data.excluded = {{7, "T is empty"}, {9, "include = 0"}};

  result.request.options.objective = Objective::toughness;

  FitResult fit;
  fit.model = "c";
  fit.model_name = "Papangelo-Ciavarella 2019";
  fit.formula = "f = 1/(1 + (lambda-1) sin^2(psi))";
  fit.status = status;
  fit.parameters = {{"lambda", 0.0023456789, 1.2345e-5, 0, 1}};
  fit.used = PointIndices(40);
  fit.r2 = 0.99990826;
  fit.rmse = 0.01541;
  fit.max_abs_residual = 0.0539;
  fit.area = AreaGoodness{0.99935, 0.0021636, 0.00655, 38, 2, {}};
  result.request.published["c"] = {{"lambda", 0.0023, 0.00005}, {"r2", 0.9999, 0.00005}};
  if (status == FitStatus::at_bound) {
    fit.message = "lambda is at its lower bound 0";
    fit.parameters[0] = {"lambda", 0.0, {}, 0, 1, true};
  }
  if (status == FitStatus::multimodal) fit.message = "another minimum fits as well within the scatter: lambda = 0.41";
  if (status == FitStatus::not_converged) {
    fit.message = "the solver stopped where the gradient is not zero (relative size 0.002)";
    fit.parameters[0].stderr_.reset();
  }
  if (status == FitStatus::not_identifiable) {
    fit.message = "the data do not constrain lambda: no value in the range fits better than another";
    fit.parameters[0].value.reset();
    fit.parameters[0].stderr_.reset();
    fit.r2.reset();
    fit.rmse.reset();
    fit.max_abs_residual.reset();
    fit.area.reset();
  }
  result.fits = {fit};
  return result;
}

/// A shipped definition, run as a report runs it; once for each name.
inline const Analysis& shipped(const std::string& name) {
  static std::map<std::string, Analysis> results;
  const auto found = results.find(name);
  if (found != results.end()) return found->second;
  return results.emplace(name, run_for_report(read_fit_definition(MIXITY_ROOT "/fits/" + name + ".toml")))
      .first->second;
}

inline ReportedData without_figures(const Analysis& result, const std::string& stem) {
  ReportedData data{result, stem};
  data.answer = answer_of(result);
  return data;
}

}  // namespace mixity
