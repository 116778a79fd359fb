#include "report/fit_fields.h"

#include <array>
#include <cmath>

#include "analysis/judgement.h"
#include "fitting/stated_constants.h"

namespace mixity {
namespace {

std::optional<std::string_view> null_if_empty(std::string_view text) {
  return text.empty() ? std::nullopt : std::optional(text);
}

}  // namespace

std::optional<std::string_view> notice_on(const Dataset& data) {
  return data.metadata.provenance == Provenance::reconstructed ? std::optional(kReconstructedNotice) : std::nullopt;
}

std::vector<ExcludedLine> lines_of(const std::vector<Excluded>& excluded, const Dataset* data) {
  std::vector<ExcludedLine> lines;
  for (const Excluded& one : excluded) {
    lines.push_back({data ? data->line_in_file(one.line) : one.line, one.reason, {}});
    if (data && !data->files.empty()) lines.back().file.value = data->file_of(one.line);
  }
  return lines;
}

void describe(Fields<ExcludedLine>& field) {
  field("line", "line in the file, from 1", &ExcludedLine::line);
  field("reason", "why it is left out", &ExcludedLine::reason);
  field("file", "path, of a data set of several files", &ExcludedLine::file);
}

void describe(Fields<ShownInterval>& field) {
  field(
      "method",
      "profile likelihood; a jackknife of the runs with Student's distribution, where that is wider by more than half; "
      "or the union of the intervals of explanations that do about as well, with that of the fit itself if it is ok",
      R"({"enum": ["profile", "jackknife", "explanations"]})", &ShownInterval::method);
  field("confidence", "of the interval", R"({"exclusiveMinimum": 0, "exclusiveMaximum": 1})",
        &ShownInterval::confidence);
  field("low", "lower end; null if open", &ShownInterval::low);
  field("high", "upper end; null if open", &ShownInterval::high);
  const char* const kStatus = "found, at_bound (the parameter's bound lies within the interval) or open";
  field("low_status", kStatus, &ShownInterval::low_status);
  field("high_status", kStatus, &ShownInterval::high_status);
}

void describe(Fields<Bootstrapped>& field) {
  const auto drawn = [](const auto member) {
    return [member](const Bootstrapped&, const Within& in) { return (*in.fit->bootstrap).*member; };
  };
  field("replicates", "number of refits", drawn(&BootstrapResult::replicates));
  field("failed", "refits without a minimum, which are left out", drawn(&BootstrapResult::failed));
  field("resampled", "points within their runs, or whole runs", R"({"enum": ["points", "curves"]})",
        [](auto&, auto& in) { return in.fit->bootstrap->of_runs ? "curves" : "points"; });
  field("seed", "seed of the random numbers", drawn(&BootstrapResult::seed));
  field("low",
        "lower end of the interval: of percentiles; studentised for whole runs, at least 2 p + 2 with p parameters, "
        "away from bounds",
        &Bootstrapped::low);
  field("high", "upper end of the interval", &Bootstrapped::high);
  field("standard_deviation", "of the replicates", &Bootstrapped::standard_deviation);
  field("bias", "mean of the replicates minus the fit", &Bootstrapped::bias);
}

void describe(Fields<ShownPrior>& field) {
  field("mean", "the stated value", &ShownPrior::mean);
  field("standard_error", "its stated standard error", &ShownPrior::standard_error);
  field("distribution", "log-normal for constants that are positive", R"({"enum": ["normal", "log-normal"]})",
        [](auto& prior) { return prior.logarithmic ? "log-normal" : "normal"; });
}

void describe(Fields<FittedParameter>& field) {
  field("value", "best value; null if the status is not_identifiable", &FittedParameter::value);
  field("stderr", "standard error; null at a bound, of a held parameter or without a value", &FittedParameter::stderr_);
  field("lower", "lower bound", &FittedParameter::lower);
  field("upper", "upper bound", &FittedParameter::upper);
  field("at_bound", "whether the best value is a bound", &FittedParameter::at_bound);
  field("held", "whether the parameter was held, not fitted", &FittedParameter::held);
  field("unit", "unit; empty if dimensionless", &FittedParameter::unit);
  field("interval", "confidence interval; null if none was asked for or found", &FittedParameter::interval);
  field("bootstrap", "bootstrap interval; null if none was asked for",
        [](auto& parameter, auto& in) { return in.fit->bootstrap ? parameter.bootstrap : std::nullopt; });
  field("prior", "of a constant that was stated with a standard error; else null", &FittedParameter::prior);
}

/// The standard error of one axis as a function of the true value.
template <class Correlation>
void describe_axis(Fields<StandardErrors>& field, const std::array<const char*, 4>& names,
                   std::optional<ErrorModel> StandardErrors::*model, double StandardErrors::*step,
                   double DisplayUnits::*scale, const Correlation& correlation) {
  const auto unit = [scale](const Within& in) { return in.result->data.display.*scale; };
  field(names[0], "constant part of the standard error, in the unit of the file; null of a column",
        [=](const StandardErrors& errors, const Within& in) {
          const auto& found = errors.*model;
          return found ? std::optional(found->constant * unit(in)) : std::nullopt;
        });
  field(names[1], "part that is proportional to the true value; null of a column", [=](const StandardErrors& errors) {
    const auto& found = errors.*model;
    return found ? std::optional(found->share) : std::nullopt;
  });
  field(names[2], "of the noise of neighbouring points; 0 where there is none", correlation);
  field(names[3], "in which it was read, in the unit of the file; null where none is found",
        [=](const StandardErrors& errors, const Within& in) {
          return errors.*step > 0 ? std::optional(errors.*step * unit(in)) : std::nullopt;
        });
}

void describe(Fields<StandardErrors>& field) {
  const char* const kSource =
      "where the standard errors come from: columns of the file, stated for all points, the scatter of neighbouring "
      "points, assumed (too few points for an estimate), or exact (none)";
  field("sigma_T", kSource, &StandardErrors::source_T);
  field("sigma_A", kSource, &StandardErrors::source_A);
  field("relative_scatter",
        "relative error of T and A by the scatter of neighbouring points, from which an estimate starts, or assumed; "
        "else null",
        &StandardErrors::scatter);
  describe_axis(field, {"constant_T", "share_T", "correlation_T", "step_T"}, &StandardErrors::model_T,
                &StandardErrors::step_T, &DisplayUnits::force_scale,
                [](const StandardErrors& errors) { return errors.correlations.second; });
  describe_axis(field, {"constant_A", "share_A", "correlation_A", "step_A"}, &StandardErrors::model_A,
                &StandardErrors::step_A, &DisplayUnits::area_scale,
                [](const StandardErrors& errors) { return errors.correlations.first; });
  field("run_factors", "by which the errors of each run are multiplied, by its name; null where runs do not differ",
        [](const StandardErrors& errors, const Within& in) {
          std::optional<Named<double>> factors;
          if (errors.run_factors.empty()) return factors;
          factors.emplace();
          for (std::size_t run = 0; run < errors.run_factors.size(); ++run)
            factors->emplace_back(in.result->data.curves[run], errors.run_factors[run]);
          return factors;
        });
  field(
      "by_run",
      "quantities that differ from run to run, by name: standard deviation and most probable deviations, as shares of "
      "factors and in the unit of the file of offsets; null unless asked for",
      [](const StandardErrors& errors, const Within& in) {
        std::optional<Named<Named<double>>> quantities;
        if (!errors.runs.any()) return quantities;
        quantities.emplace();
        for (std::size_t q = 0; q < errors.runs.spreads.size(); ++q) {
          const Dataset& data = in.result->data;
          const double unit = shown_deviation(data, errors.runs.names[q]).scale;
          Named<double> numbers{{"standard_deviation", errors.runs.spreads[q] * unit}};
          for (std::size_t run = 0; run < data.curves.size(); ++run)
            numbers.emplace_back(data.curves[run], errors.runs.deviations[q][run] * unit);
          quantities->emplace_back(errors.runs.names[q], std::move(numbers));
        }
        return quantities;
      });
  const char* const kRaised =
      "points whose standard error of 0 was raised to 1e-4 of the largest value, as a distance needs errors in both "
      "axes";
  field("raised_T", kRaised, &StandardErrors::raised_T);
  field("raised_A", kRaised, &StandardErrors::raised_A);
}

void describe(Fields<AreaGoodness>& field) {
  const auto if_any = [](const auto member) {
    return
        [member](const AreaGoodness& area) { return area.predicted > 0 ? std::optional(area.*member) : std::nullopt; };
  };
  field("r2", "coefficient of determination; null if the areas do not vary", &AreaGoodness::r2);
  field("rmse", "root mean square error, in `unit`; null without a predicted point", if_any(&AreaGoodness::rmse));
  field("max_abs_residual", "largest error, in `unit`", if_any(&AreaGoodness::max_abs_residual));
  field("unit", "unit of areas in the file", [](auto&, auto& in) { return in.result->data.display.area; });
  field("unpredicted", "points beyond the last equilibrium of the model", &AreaGoodness::unpredicted);
  field("obstacle", "why the law defines no area with these parameters; else null",
        [](auto& area) { return null_if_empty(area.obstacle); });
}

void describe(Fields<PaperFit>& field) {
  field("status", "as of the fit", &PaperFit::status);
  field("parameters", "value by name", R"({"minProperties": 1})", [](const PaperFit& paper) {
    Named<std::optional<double>> values;
    for (const FittedParameter& parameter : paper.parameters) values.emplace_back(parameter.name, parameter.value);
    return values;
  });
  field("r2", "coefficient of determination in ln(Gc/GIc)", &PaperFit::r2);
  field("points", "points with a phase angle", &PaperFit::points);
}

void describe(Fields<Outlier>& field) {
  const auto point = [](const Outlier& one, const Within& in) -> const Point& {
    return in.result->data.points[one.point];
  };
  field("line", "line in the file, from 1",
        [=](auto& one, auto& in) { return in.result->data.line_in_file(point(one, in).line); });
  field("file", "path, of a data set of several files", [=](auto& one, auto& in) {
    const Dataset& data = in.result->data;
    return IfAny<std::string>{data.files.empty() ? std::nullopt : std::optional(data.file_of(point(one, in).line))};
  });
  field("curve", "name of the run", [=](auto& one, auto& in) { return in.result->data.curves[point(one, in).curve]; });
  field("size", "of the residual, model minus data, in standard errors; where none are known, in the robust scatter",
        &Outlier::size);
}

void describe(Fields<Agreement>& field) {
  field("value", "published value", [](auto& one) { return one.published.value; });
  field("tolerance", "what its printed digits allow", [](auto& one) { return one.published.tolerance; });
  field("agrees", "whether the fit agrees within the tolerance", &Agreement::agrees);
}

/// The axes of elliptic contacts in a fit.
struct FittedAxes {
  std::size_t count;
  double rms, factor;
};

void describe(Fields<FittedAxes>& field) {
  field("count", "points whose axes were fitted", &FittedAxes::count);
  field("rms", "root mean square of their residuals, in standard errors", &FittedAxes::rms);
  field("factor", "where no errors of the axes are stated, the error of ln(a/b) is this times the relative error of A",
        &FittedAxes::factor);
}

std::optional<FittedAxes> axes_of(const FitResult& fit) {
  if (fit.axes == 0) return std::nullopt;
  double squares = 0;
  for (const double r : fit.axes_residuals) squares += std::isfinite(r) ? r * r : 0;
  return FittedAxes{fit.axes, std::sqrt(squares / static_cast<double>(fit.axes)), fit.errors->axes_factor};
}

/// A measured pull-off load and the model's.
struct FittedPullOff {
  const FitResult* fit;
  std::size_t index;
};

void describe(Fields<FittedPullOff>& field) {
  const auto reading = [](const FittedPullOff& one, const Within& in) -> const PullOffReading& {
    return in.result->data.pull_off[one.index];
  };
  field("line", "line in the file, from 1",
        [=](auto& one, auto& in) { return in.result->data.line_in_file(reading(one, in).line); });
  field("held", "what was held: load (T) or displacement (u)",
        [=](auto& one, auto& in) { return reading(one, in).held; });
  field("shear", "T or u, in the file's unit", [=](auto& one, auto& in) {
    const PullOffReading& read = reading(one, in);
    const DisplayUnits& units = in.result->data.display;
    return read.shear * (read.held == HeldShear::load ? units.force_scale : units.length_scale);
  });
  field("P_c", "measured load, compression positive, in the file's unit",
        [=](auto& one, auto& in) { return reading(one, in).P * in.result->data.display.force_scale; });
  field("predicted", "load of the model",
        [](auto& one, auto& in) { return one.fit->pull_off_loads[one.index] * in.result->data.display.force_scale; });
  field("residual", "distance from the model's curve P_c(T) in standard errors, model minus data",
        [](auto& one) { return one.fit->pull_off_residuals[one.index]; });
}

std::vector<FittedPullOff> pull_off_of(const FitResult& fit) {
  std::vector<FittedPullOff> list;
  for (std::size_t i = 0; i < fit.pull_off_residuals.size(); ++i) list.push_back({&fit, i});
  return list;
}

/// The loads at held approaches in a fit.
struct FittedLoads {
  FittedAxes of;
  double error;
};

void describe(Fields<FittedLoads>& field) {
  field("count", "points whose load was fitted", [](auto& loads) { return loads.of.count; });
  field("rms", "root mean square of their residuals, in standard errors", [](auto& loads) { return loads.of.rms; });
  field("sigma_P", "mean standard error of P, in the unit of the file", &FittedLoads::error);
}

void describe(Fields<FitResult>& field) {
  field("model", "key of the model", &FitResult::model);
  field("objective", "what was fitted: distance from the curve in (T, A), or ln(Gc/GIc) against psi",
        &FitResult::objective);
  field("scale", "of the toughness: logarithmic or linear", &FitResult::scale);
  field("status", "whether the result can be used as it is", &FitResult::status);
  field("message", "one sentence on the status; empty if it is ok", &FitResult::message);
  field("parameters", "parameters of the model and fitted constants, by name", R"({"minProperties": 1})",
        [](const FitResult& fit) {
          Named<FittedParameter> named;
          for (const FittedParameter& parameter : fit.parameters) named.emplace_back(parameter.name, parameter);
          return named;
        });
  field("used", "number of points that the model could use", [](auto& fit) { return fit.used.size(); });
  field("excluded", "usable points that this model cannot describe",
        [](auto& fit, auto& in) { return lines_of(fit.excluded, &in.result->data); });
  field("r2", "coefficient of determination in the fitted space; null if the data do not vary", &FitResult::r2);
  field("rmse", "root mean square residual in the fitted space", &FitResult::rmse);
  field("max_abs_residual", "largest residual in the fitted space", &FitResult::max_abs_residual);
  field("outliers",
        "used points that lie farther from the fit than chance allows: 1 % of fits of clean data have any. None of an "
        "unweighted toughness from loads, whose points scatter unequally",
        &FitResult::outliers);
  field("errors", "standard errors of the points; null if the objective does not use them", &FitResult::errors);
  field("axes", "of a model of elliptic contacts, fitted axes; null without",
        [](auto& fit, auto& in) { return in.result->data.holds_approach() ? std::nullopt : axes_of(fit); });
  field("loads", "under a held approach, measured loads that were fitted; null without", [](auto& fit, auto& in) {
    const auto of = in.result->data.holds_approach() ? axes_of(fit) : std::nullopt;
    return of ? std::optional(FittedLoads{*of, mean_error_of_loads(in.result->data, fit)}) : std::nullopt;
  });
  field("pull_off", "fitted pull-off loads", [](auto& fit) {
    return IfAny<std::vector<FittedPullOff>>{pull_off_of(fit).empty() ? std::nullopt : std::optional(pull_off_of(fit))};
  });
  field("sigma_factor",
        "common factor on stated errors, from the scatter (sigma_factor = free); null where they are as stated, or "
        "without a value",
        &FitResult::sigma_factor);
  field("loss_scale", "residual at which a robust loss bends; null without one",
        [](auto& fit) { return fit.loss_scale > 0 ? std::optional(fit.loss_scale) : std::nullopt; });
  field("loss_freedom", "degrees of freedom of the loss t; null without it",
        [](auto& fit) { return fit.loss_freedom > 0 ? std::optional(fit.loss_freedom) : std::nullopt; });
  field("correlations", "correlations of the free parameters", correlations);
  field("influence", "what moves the fit; null if it was not asked for", &FitResult::influence);
  field("area", "how well the areas are predicted; null for data without loads", &FitResult::area);
  field("paper",
        "the paper's fit of the same points, ln(Gc/GIc) against psi with equal weights; null unless the objective is "
        "curve and the data have loads",
        &FitResult::paper);
  field("evidence", "evidence of the model and posterior of its first free parameter", &FitResult::evidence);
  field("budget", "what the variance of the first free parameter is made of", &FitResult::budget);
  field("consistency", "whether the residuals are what the fit assumes", &FitResult::consistency);
  field(
      "explanations",
      "causes that explain why tests fail about as well as the best; of an ok fit those that its interval includes, as "
      "a score test nearly fails; empty without one",
      &FitResult::explanations);
  field("run_tests", "whether quantities differ between the runs; empty without loads or of a single run",
        &FitResult::run_tests);
  field("outdone_by", "of a suspect fit, the model that describes the data far better; else null",
        [](auto& fit) { return null_if_empty(fit.outdone_by); });
  field("published", "comparison with published values, by name", [](const FitResult& fit, const Within& in) {
    Named<Agreement> named;
    for (Agreement& one : compare(fit, in.result->request)) named.emplace_back(one.published.name, std::move(one));
    return named;
  });
}

}  // namespace mixity
