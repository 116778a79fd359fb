// Fits.
#include <cmath>

#include "analysis/result.h"
#include "analysis/run.h"
#include "analysis/settings.h"
#include "fitting/fit.h"
#include "fitting/prediction.h"
#include "python/bindings.h"
#include "python/keyword_words.h"
#include "report/fit_json.h"
#include "report/fit_text.h"
#include "statistics/distributions.h"

namespace mixity {

FitRequest request_of(const Dataset& data, const Stated& options) {
  FitRequest request;
  request.data_path = data.path;
  request.words = in_keywords;
  for (const auto& [name, text] : options)
    if (const std::string problem = set_option(request, name, text); !problem.empty()) throw InputError(name, problem);
  if (const auto both = contradiction(request)) throw InputError(both->option, both->problem);
  return request;
}

namespace {

Analysis fit(const Dataset& data, const Stated& options, const nb::object& progress) {
  const FitRequest request = request_of(data, options);
  Watch watch(progress);
  const nb::gil_scoped_release released;
  return run(request, data, [&](double share) { watch(share); });
}

}  // namespace

nb::dict shown(const FoldPrediction& fold, bool with_errors) {
  nb::dict one;
  const auto add = [&](const char* name, const char* error, const Derived& number) {
    one[name] = *number.value;
    if (with_errors) one[error] = number.standard_error;
  };
  add("T", "T_stderr", fold.T);
  add("u", "u_stderr", fold.u);
  add("A", "A_stderr", fold.A);
  one["psi"] = fold.psi;
  one["control"] = std::string(to_string(fold.control.kind));
  one["met_on"] = fold.on_loading ? "loading" : "reversal";
  one["jumps_to"] = std::string(to_string(fold.jumps_to));
  one["area_after"] = fold.area_after;
  one["area_lost"] = *fold.A.value - fold.area_after;
  return one;
}

void bind_fits(nb::module_& m) {
  auto results = nb::class_<Analysis>(m, "Results");
  results.def("json", [](const Analysis& result) { return to_json({result}); })
      .def("text", [](const Analysis& result) { return to_text(result); })
      .def("options", [](const Analysis& result) { return stated_options(result.request); })
      .def("models", [](const Analysis& result) { return result.request.models; })
      .def("residuals", [](const Analysis& result, std::size_t i) { return numpy_of(result.fits.at(i).residuals); })
      .def("used",
           [](const Analysis& result, std::size_t i) {
             const auto& used = result.fits.at(i).used;
             return numpy_of({used.begin(), used.end()});
           })
      .def("profile",
           [](const Analysis& result, std::size_t i, const std::string& name) {
             FitOptions options = result.request.options;
             options.profile_points = 60;
             options.checks = false;
             options.bootstrap.replicates = 0;
             const FitResult fit =
                 without_gil([&] { return fit_model(result.data, result.request.models.at(i), options); });
             std::vector<double> x, rise;
             double level = std::nan("");
             for (const FittedParameter& parameter : fit.parameters)
               if (parameter.name == name && parameter.profile) {
                 level = parameter.profile->level;
                 for (const auto& [at, cost] : parameter.profile->points) {
                   x.push_back(at);
                   rise.push_back(cost);
                 }
               }
             return nb::make_tuple(numpy_of(x), numpy_of(rise), level);
           })
      .def("areas",  // with bands; NaN if unknown
           [](const Analysis& result, std::size_t i, const Numbers& P, const Numbers& T, double confidence) {
             const std::vector<AreaPrediction> found = without_gil([&] {
               return predict_areas_of(result.data, result.fits.at(i), result.request.options, {P.data(), P.size()},
                                       {T.data(), T.size()});
             });
             const double quantile = normal_quantile(0.5 + confidence / 2), unit = result.data.display.area_scale;
             std::vector<double> A(P.size(), std::nan("")), low = A, high = A;
             for (std::size_t k = 0; k < found.size(); ++k) {
               if (found[k].status != EquilibriumStatus::ok) continue;
               A[k] = found[k].A * unit;
               const double half = quantile * (found[k].standard_error.value_or(std::nan("")) * unit);
               low[k] = A[k] - half;
               high[k] = A[k] + half;
             }
             return nb::make_tuple(numpy_of(A), numpy_of(low), numpy_of(high));
           })
      .def("axes",  // a and b, each with its band; NaN if unknown
           [](const Analysis& result, std::size_t i, const Numbers& P, const Numbers& T, double confidence) {
             const std::vector<AreaPrediction> found = without_gil([&] {
               return predict_areas_of(result.data, result.fits.at(i), result.request.options, {P.data(), P.size()},
                                       {T.data(), T.size()});
             });
             const double quantile = normal_quantile(0.5 + confidence / 2), none = std::nan(""),
                          unit = std::sqrt(result.data.display.area_scale);
             const auto with_band = [&](Derived AreaPrediction::*axis) {
               std::vector<double> value, low, high;
               for (const AreaPrediction& one : found) {
                 const double half = quantile * (one.*axis).standard_error.value_or(none);
                 value.push_back(unit * (one.*axis).value.value_or(none));
                 low.push_back(value.back() - unit * half);
                 high.push_back(value.back() + unit * half);
               }
               return nb::make_tuple(numpy_of(value), numpy_of(low), numpy_of(high));
             };
             return nb::make_tuple(with_band(&AreaPrediction::a), with_band(&AreaPrediction::b));
           });
  results.def("folds", [](const Analysis& result, std::size_t i, double P, const std::string& control,
                          double stiffness) {
    const Control by = control_of(control, stiffness);
    const FoldsPrediction found =
        without_gil([&] { return predict_folds_of(result.data, result.fits.at(i), result.request.options, P, {by}); });
    if (!found.problem.empty()) throw InputError("folds", found.problem);
    nb::list list;
    for (const FoldPrediction& fold : found.folds) list.append(shown(fold, true));
    return list;
  });
  m.def("fit", &fit, "data"_a, "options"_a, "progress"_a.none());
  m.def("options", [] {  // name, help, default
    std::vector<std::tuple<std::string, std::string, std::string>> all;
    for (const Setting& one : settings()) all.emplace_back(one.name, one.help, one.initial());
    return all;
  });
}

}  // namespace mixity
