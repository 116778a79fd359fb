// Fits.
#include <cmath>

#include "analysis/model_curves.h"
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

std::vector<AreaPrediction> predicted(const Analysis& result, std::size_t i, const Numbers& P, const Numbers& T) {
  return without_gil([&] {
    return predict_areas_of(result.data, result.fits.at(i), result.request.options, {P.data(), P.size()},
                            {T.data(), T.size()});
  });
}

/// A number of each prediction in this unit, and the ends of its band; NaN where it is not known.
template <class Of>
nb::tuple with_band(const std::vector<AreaPrediction>& found, double unit, double confidence, const Of& of) {
  const double quantile = normal_quantile(0.5 + confidence / 2), none = std::nan("");
  std::vector<double> value, low, high;
  for (const AreaPrediction& one : found) {
    const Derived number = of(one);
    const double half = quantile * (number.standard_error.value_or(none) * unit);
    value.push_back(number.value.value_or(none) * unit);
    low.push_back(value.back() - half);
    high.push_back(value.back() + half);
  }
  return nb::make_tuple(numpy_of(value), numpy_of(low), numpy_of(high));
}

}  // namespace

/// Bytes that are not UTF-8 are replaced.
nb::object text_of(const std::string& text) {
  return nb::steal(PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace"));
}

/// JSON as Python's own objects. As in its text, NaN and infinity are null.
nb::object object_of(const Json& json) {
  switch (json.type()) {
    case Json::value_t::object: {
      nb::dict object;
      for (const auto& [name, value] : json.items()) object[text_of(name)] = object_of(value);
      return object;
    }
    case Json::value_t::array: {
      nb::list list;
      for (const Json& value : json) list.append(object_of(value));
      return list;
    }
    case Json::value_t::string:
      return text_of(json.get_ref<const std::string&>());
    case Json::value_t::boolean:
      return nb::bool_(json.get<bool>());
    case Json::value_t::number_integer:
    case Json::value_t::number_unsigned:
      return nb::int_(json.get<std::int64_t>());
    case Json::value_t::number_float: {
      const double number = json.get<double>();
      return std::isfinite(number) ? nb::object(nb::float_(number)) : nb::none();
    }
    default:
      return nb::none();
  }
}

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
  results.def("document",
              [](const Analysis& result) {
                return object_of(fits_document({&result, 1}));
              })
      .def("text", [](const Analysis& result) { return to_text(result); })
      .def("options", [](const Analysis& result) { return stated_options(result.request); })
      .def("models", [](const Analysis& result) { return result.request.models; })
      .def("residuals", [](const Analysis& result, std::size_t i) { return numpy_of(result.fits.at(i).residuals); })
      .def("used",
           [](const Analysis& result, std::size_t i) {
             const auto& used = result.fits.at(i).used;
             return numpy_of({used.begin(), used.end()});
           })
      .def("over_fitted_toughness",  // by run
           [](const Analysis& result, std::size_t i) {
             return numpy_of(over_fitted_toughness(result.data, result.fits.at(i)));
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
      .def("areas",  // with their band; NaN if unknown
           [](const Analysis& result, std::size_t i, const Numbers& P, const Numbers& T, double confidence) {
             return with_band(
                 predicted(result, i, P, T), result.data.display.area_scale, confidence, [](const AreaPrediction& one) {
                   return one.status == EquilibriumStatus::ok ? Derived{one.A, one.standard_error} : Derived{};
                 });
           })
      .def("axes",  // a and b, each with its band; NaN if unknown
           [](const Analysis& result, std::size_t i, const Numbers& P, const Numbers& T, double confidence) {
             const std::vector<AreaPrediction> found = predicted(result, i, P, T);
             const double unit = std::sqrt(result.data.display.area_scale);
             return nb::make_tuple(with_band(found, unit, confidence, [](const AreaPrediction& one) { return one.a; }),
                                   with_band(found, unit, confidence, [](const AreaPrediction& one) { return one.b; }));
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
