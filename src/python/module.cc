// The engine as Python's module mixity._core: arrays in, results as JSON and arrays out. What is Pythonic about it
// stands in mixity/*.py.
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/vector.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <thread>

#include "dataset/arrays.h"
#include "dataset/pooled.h"
#include "fitting/fit.h"
#include "fitting/prediction.h"
#include "jobs/job.h"
#include "jobs/job_options.h"
#include "mechanics/any_model.h"
#include "mechanics/measurement.h"
#include "report/fit_json.h"
#include "report/fit_text.h"
#include "studies/design.h"
#include "studies/simulate.h"

namespace nb = nanobind;
using namespace nb::literals;

namespace mixity {
namespace {

using Numbers = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using Output = nb::ndarray<double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using Codes = nb::ndarray<std::uint8_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

/// One number for all, or one for each.
Values values_of(const Numbers& numbers) { return {numbers.data(), numbers.size() == 1 ? 0 : 1}; }
std::vector<Values> all_values(const std::vector<Numbers>& parameters) {
  std::vector<Values> all;
  for (const Numbers& one : parameters) all.push_back(values_of(one));
  return all;
}
std::span<double> span_of(const Output& out) { return {out.data(), out.size()}; }

/// Hands an array over to Python.
nb::ndarray<nb::numpy, double> numpy_of(std::vector<double> values) {
  auto* const owned = new std::vector<double>(std::move(values));
  const nb::capsule owner(owned, [](void* p) noexcept { delete static_cast<std::vector<double>*>(p); });
  return nb::ndarray<nb::numpy, double>(owned->data(), {owned->size()}, owner);
}

struct Interrupted {};

/// Calls Python's callback, and asks for Ctrl-C, on the thread that Python waits on; others only stop when it says so.
class Watch {
 public:
  explicit Watch(nb::object callback) : callback_(std::move(callback)), main_(std::this_thread::get_id()) {}
  void operator()(double share) {
    if (stop_) throw Interrupted();
    if (std::this_thread::get_id() != main_) return;
    const nb::gil_scoped_acquire gil;
    try {
      if (PyErr_CheckSignals() != 0) throw nb::python_error();
      if (!callback_.is_none()) callback_(share);
    } catch (...) {
      stop_ = true;
      throw;
    }
  }

 private:
  nb::object callback_;
  std::thread::id main_;
  std::atomic<bool> stop_ = false;
};

JobResult fit(const Dataset& data, const std::vector<std::pair<std::string, std::string>>& options,
              const nb::object& progress) {
  FitJob job;
  job.data_path = data.path;
  for (const auto& [name, text] : options)
    if (const std::string problem = set_option(job, name, text); !problem.empty()) throw InputError(name, problem);
  if (const auto both = contradiction(job)) throw InputError(both->option, both->problem);
  Watch watch(progress);
  const nb::gil_scoped_release released;
  return run(job, data, [&](double share) { watch(share); });
}

nb::dict shown(const Fold& fold) {
  nb::dict one;
  one["T"] = fold.T;
  one["u"] = fold.u;
  one["A"] = fold.A;
  one["psi"] = fold.psi;
  one["control"] = std::string(to_string(fold.control.kind));
  one["met_on"] = fold.place.maximum ? "loading" : "reversal";
  one["jumps_to"] = std::string(to_string(fold.jumps_to));
  one["area_after"] = fold.area_after;
  one["area_lost"] = fold.area_lost;
  return one;
}

Control control_of(const std::string& kind, double stiffness) {
  if (kind == "load") return {Control::Kind::load};
  if (kind == "displacement") return {Control::Kind::displacement};
  if (kind == "stiffness" && stiffness > 0) return {Control::Kind::stiffness, stiffness};
  throw InputError("control",
                   "is '" + kind + "'; it must be load, displacement, or stiffness with one that is positive");
}

void require(const std::string& problem) {
  if (!problem.empty()) throw InputError("parameters", problem);
}

void bind_mechanics(nb::module_& m) {
  m.def("model_keys", &model_keys);
  m.def("parameter_names", [](const std::string& model) { return parameter_names(model); });
  m.def("parameter_bounds", [](const std::string& model) { return parameter_bounds(model); });
  m.def("areas", [](const std::string& model, const std::vector<Numbers>& parameters, const Numbers& P,
                    const Numbers& T, const Output& A, const Codes& status) {
    const std::vector<Values> all = all_values(parameters);
    const nb::gil_scoped_release released;
    areas(model, all, values_of(P), values_of(T), span_of(A),
          {reinterpret_cast<EquilibriumStatus*>(status.data()), status.size()});
  });
  m.def("toughness_ratios",
        [](const std::string& model, const std::vector<Numbers>& parameters, const Numbers& psi, const Output& f) {
          const std::vector<Values> all = all_values(parameters);
          const nb::gil_scoped_release released;
          toughness_ratios(model, all, values_of(psi), span_of(f));
        });
  m.def("tangential_loads", [](const std::string& model, const std::vector<Numbers>& parameters, const Numbers& P,
                               const Numbers& A, const Output& T) {
    const std::vector<Values> all = all_values(parameters);
    const nb::gil_scoped_release released;
    tangential_loads(model, all, values_of(P), values_of(A), span_of(T));
  });
  m.def("phase_angles", [](const Numbers& P, const Numbers& T, const Numbers& A, const Output& psi, const Output& f) {
    const nb::gil_scoped_release released;
    const Values loads = values_of(P), shears = values_of(T), sizes = values_of(A);
    for (std::size_t i = 0; i < psi.size(); ++i) {
      const auto point = toughness_of_area(loads[i], std::abs(shears[i]), sizes[i]);
      psi.data()[i] = point ? phase_angle(point->mixity) : std::nan("");
      f.data()[i] = point ? point->ratio : std::nan("");
    }
  });
  m.def("folds", [](const std::string& model, const std::vector<double>& parameters, double P,
                    const std::string& control, double stiffness) {
    const FoldsOrProblem found = folds_of(model, parameters, P, control_of(control, stiffness));
    require(found.problem);
    nb::list list;
    for (const Fold& fold : found.folds) list.append(shown(fold));
    return list;
  });
  m.def(
      "regime",
      [](const std::string& model, const std::vector<double>& parameters, double P, std::optional<double> tau0) {
        const RegimeOrProblem found = regime_of(model, parameters, P, tau0);
        require(found.problem);
        nb::dict one;
        one["regime"] = static_cast<int>(found.regime->regime);
        one["fracture"] = static_cast<int>(found.regime->fracture);
        one["T_end"] = found.regime->T_end;
        one["T_strength"] = found.regime->T_strength;
        one["jumps_to"] =
            found.regime->jumps_to ? std::optional(std::string(to_string(*found.regime->jumps_to))) : std::nullopt;
        return one;
      },
      "model"_a, "parameters"_a, "P"_a, "tau0"_a.none());
  m.def("curve", [](const std::string& model, const std::vector<double>& parameters, double P, std::size_t points) {
    const CurveOrProblem found = curve_of(model, parameters, P, points);
    require(found.problem);
    nb::dict columns;
    const auto column = [&](const char* name, double CurvePoint::*of) {
      std::vector<double> values;
      for (const CurvePoint& point : found.points) values.push_back(point.*of);
      columns[name] = numpy_of(std::move(values));
    };
    column("phi", &CurvePoint::phi);
    column("T", &CurvePoint::T);
    column("A", &CurvePoint::A);
    column("a", &CurvePoint::a);
    column("u", &CurvePoint::u);
    column("y", &CurvePoint::y);
    column("psi", &CurvePoint::psi);
    column("f", &CurvePoint::f);
    column("dT", &CurvePoint::dT);
    return columns;
  });
}

void bind_data(nb::module_& m) {
  using Stated = std::vector<std::pair<std::string, std::string>>;
  nb::class_<Dataset>(m, "Dataset")
      .def_ro("name", &Dataset::name)
      .def_ro("path", &Dataset::path)
      .def_ro("notes", &Dataset::notes)
      .def_ro("curves", &Dataset::curves)
      .def_ro("reading", &Dataset::reading)
      .def_ro("taken", &Dataset::taken)
      .def_ro("has_loads", &Dataset::has_loads)
      .def_prop_ro("dimensional", [](const Dataset& d) { return d.contact.has_value(); })
      .def_prop_ro("force_unit_text", [](const Dataset& d) { return d.display.force; })
      .def_prop_ro("area_unit_text", [](const Dataset& d) { return d.display.area; })
      .def_prop_ro("force_scale", [](const Dataset& d) { return d.display.force_scale; })
      .def_prop_ro("area_scale", [](const Dataset& d) { return d.display.area_scale; })
      .def_prop_ro("force_unit", [](const Dataset& d) { return d.contact ? d.contact->force_unit() : 1.0; })
      .def_prop_ro("area_unit", [](const Dataset& d) { return d.contact ? d.contact->area_unit() : 1.0; })
      .def_prop_ro("displacement_unit",
                   [](const Dataset& d) { return d.contact ? d.contact->displacement_unit() : 1.0; })
      .def_prop_ro("excluded",
                   [](const Dataset& d) {
                     std::vector<std::pair<std::size_t, std::string>> all;
                     for (const Excluded& one : d.excluded) all.emplace_back(d.line_in_file(one.line), one.reason);
                     return all;
                   })
      .def("column",
           [](const Dataset& d, const std::string& name) {
             std::vector<double> values;
             for (std::size_t i = 0; i < d.points.size(); ++i) {
               const Point& point = d.points[i];
               const auto toughness = name == "psi" || name == "f" ? d.toughness(i) : std::nullopt;
               values.push_back(name == "P"       ? point.P
                                : name == "T"     ? point.T
                                : name == "A"     ? point.A
                                : name == "line"  ? static_cast<double>(point.line)
                                : name == "curve" ? static_cast<double>(point.curve)
                                : !toughness      ? std::nan("")
                                : name == "psi"   ? phase_angle(toughness->mixity)
                                                  : toughness->ratio);
             }
             return numpy_of(std::move(values));
           })
      .def("__len__", [](const Dataset& d) { return d.points.size(); });
  m.def("read", [](const std::vector<std::string>& paths, const Stated& constants) {
    const nb::gil_scoped_release released;
    if (paths.size() == 1) return load_dataset(paths[0], constants);
    std::vector<RunFile> files;
    for (const std::string& path : paths) files.push_back({path});
    return load_pooled(files, constants);
  });
  m.def("files_of", &files_of);
  m.def("from_arrays", [](const std::string& name, const std::vector<std::pair<std::string, nb::object>>& columns,
                          const Stated& constants) {
    std::vector<Numbers> numbers;
    std::vector<std::vector<std::string>> texts;
    numbers.reserve(columns.size());
    texts.reserve(columns.size());
    std::vector<ArrayColumn> all;
    for (const auto& [heading, values] : columns) {
      ArrayColumn& column = all.emplace_back(ArrayColumn{heading});
      if (Numbers read; nb::try_cast(values, read)) {
        numbers.push_back(read);
        column.numbers = {numbers.back().data(), numbers.back().size()};
      } else {
        column.texts = texts.emplace_back(nb::cast<std::vector<std::string>>(values));
      }
    }
    const nb::gil_scoped_release released;
    return make_dataset(name, all, constants);
  });
}

void bind_fits(nb::module_& m) {
  nb::class_<JobResult>(m, "Results")
      .def("json", [](const JobResult& result) { return to_json({result}); })
      .def("text", [](const JobResult& result) { return to_text(result); })
      .def("options",
           [](const JobResult& result) {
             return std::vector<std::pair<std::string, std::string>>(result.job.stated.begin(),
                                                                     result.job.stated.end());
           })
      .def("models", [](const JobResult& result) { return result.job.models; })
      .def("residuals", [](const JobResult& result, std::size_t i) { return numpy_of(result.fits.at(i).residuals); })
      .def("used",
           [](const JobResult& result, std::size_t i) {
             const auto& used = result.fits.at(i).used;
             return numpy_of({used.begin(), used.end()});
           })
      .def("profile",
           [](const JobResult& result, std::size_t i, const std::string& name) {
             FitOptions options = result.job.options;
             options.profile_points = 60;
             options.checks = false;
             options.bootstrap.replicates = 0;
             const FitResult fit = [&] {
               const nb::gil_scoped_release released;
               return fit_model(result.data, result.job.models.at(i), options);
             }();
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
      .def("areas", [](const JobResult& result, std::size_t i, const Numbers& P, const Numbers& T) {
        std::vector<AreaPrediction> found;
        {
          const nb::gil_scoped_release released;
          found = predict_areas_of(result.data, result.fits.at(i), result.job.options, {P.data(), P.size()},
                                   {T.data(), T.size()});
        }
        std::vector<double> A(P.size(), std::nan("")), error(P.size(), std::nan("")), status(P.size(), 2);
        for (std::size_t k = 0; k < found.size(); ++k) {
          status[k] = static_cast<double>(found[k].status);
          if (found[k].status != EquilibriumStatus::ok) continue;
          A[k] = found[k].A;
          error[k] = found[k].standard_error.value_or(std::nan(""));
        }
        return nb::make_tuple(numpy_of(A), numpy_of(error), numpy_of(status));
      });
  m.def("fit", &fit, "data"_a, "options"_a, "progress"_a.none());
  m.def("option_names", [] {
    std::vector<std::string> names;
    for (const std::string_view name : kJobOptions) names.emplace_back(name);
    return names;
  });
}

nb::dict shown(const Expectation& expected) {
  nb::dict rivals, one;
  for (const Expectation::Rival& rival : expected.rivals) rivals[rival.model.c_str()] = rival.chi2;
  one["standard_error"] = expected.standard_error;
  one["chi2"] = rivals;
  return one;
}

Plan plan_of(const std::string& model, const std::vector<double>& parameters,
             const std::vector<std::pair<std::string, std::string>>& constants, const std::vector<double>& loads,
             std::size_t points, double reach, const std::string& sigma_T, const std::string& sigma_A) {
  Plan plan{model, parameters, {}, loads, points, reach, {}, {}};
  apply_overrides(constants, plan.constants);
  const auto error_of = [](const char* name, const std::string& text) {
    const auto error = parse_quantity(text);
    if (!error) throw InputError(name, "is '" + text + "'; it must be \"1%\" or a quantity");
    return *error;
  };
  plan.sigma_T = error_of("sigma_T", sigma_T);
  plan.sigma_A = error_of("sigma_A", sigma_A);
  Plan whole = plan;
  if (whole.loads.empty()) whole.loads = {0};  // some are to be found
  if (const std::string problem = problem_of(whole); !problem.empty()) throw InputError("plan", problem);
  return plan;
}

void bind_studies(nb::module_& m) {
  nb::class_<Plan>(m, "Plan")
      .def("__init__",
           [](Plan* plan, const std::string& model, const std::vector<double>& parameters,
              const std::vector<std::pair<std::string, std::string>>& constants, const std::vector<double>& loads,
              std::size_t points, double reach, const std::string& sigma_T, const std::string& sigma_A) {
             new (plan) Plan(plan_of(model, parameters, constants, loads, points, reach, sigma_T, sigma_A));
           })
      .def_ro("loads", &Plan::loads)
      .def(
          "simulate",
          [](const Plan& plan, std::uint64_t seed, std::optional<std::uint64_t> index) {
            const nb::gil_scoped_release released;
            return simulate(plan, seed, index);
          },
          "seed"_a, "index"_a.none())
      .def("expect",
           [](const Plan& plan, const std::vector<std::string>& rivals) {
             const Expectation expected = [&] {
               const nb::gil_scoped_release released;
               return expect(plan, rivals);
             }();
             return shown(expected);
           })
      .def("next_loads",
           [](const Plan& plan, double least, double most, std::size_t candidates,
              const std::vector<std::string>& rivals) {
             const auto found = [&] {
               const nb::gil_scoped_release released;
               return next_loads(plan, least, most, candidates, rivals);
             }();
             nb::list list;
             for (const LoadCandidate& one : found) list.append(nb::make_tuple(one.load, shown(one.expected)));
             return list;
           })
      .def("best",
           [](const Plan& plan, double least, double most, std::size_t runs, bool for_models,
              const std::vector<std::string>& rivals) {
             const nb::gil_scoped_release released;
             return best_plan(plan, least, most, runs, for_models ? Goal::model : Goal::error, rivals);
           })
      .def(
          "experiments",
          [](const Plan& plan, std::uint64_t seed, std::size_t count, const std::vector<std::string>& rivals,
             const nb::object& progress) {
            Watch watch(progress);
            const Outcome outcome = [&] {
              const nb::gil_scoped_release released;
              return try_plan(plan, seed, count, rivals, [&](double share) { watch(share); });
            }();
            nb::dict one;
            one["experiments"] = outcome.experiments;
            one["with_value"] = outcome.with_value;
            one["ok"] = outcome.ok;
            one["mean"] = outcome.mean;
            one["spread"] = outcome.spread;
            one["standard_error"] = outcome.mean_standard_error;
            one["covered"] = outcome.covered;
            one["decided"] = outcome.decided;
            return one;
          },
          "seed"_a, "count"_a, "rivals"_a, "progress"_a.none());
}

}  // namespace
}  // namespace mixity

NB_MODULE(_core, m) {
  m.doc() = "The engine of mixity.";
  nb::exception<mixity::InputError>(m, "InputError", PyExc_ValueError);
  nb::register_exception_translator([](const std::exception_ptr& thrown, void*) {
    try {
      std::rethrow_exception(thrown);
    } catch (const mixity::Interrupted&) {
      if (!PyErr_Occurred()) PyErr_SetNone(PyExc_KeyboardInterrupt);
    }
  });
  mixity::bind_mechanics(m);
  mixity::bind_data(m);
  mixity::bind_fits(m);
  mixity::bind_studies(m);
  m.def("version", [] { return MIXITY_VERSION; });
}
