// The models for arrays.
#include <algorithm>
#include <cmath>
#include <memory>

#include "analysis/laws.h"
#include "base/input_error.h"
#include "fitting/options.h"
#include "mechanics/contact_model.h"
#include "mechanics/laws/known_laws.h"
#include "mechanics/measurement.h"
#include "python/bindings.h"

namespace mixity {
namespace {

/// One number for all points, or one for each.
Values values_of(const Numbers& numbers) { return {numbers.data(), numbers.size() == 1 ? 0 : 1}; }
std::vector<Values> values_of(const std::vector<Numbers>& parameters) {
  std::vector<Values> all;
  for (const Numbers& one : parameters) all.push_back(values_of(one));
  return all;
}
std::span<double> span_of(const Output& out) { return {out.data(), out.size()}; }

/// A Python function as a law: called with psi and a list of the parameters, it returns an array of the length of psi.
/// Laws share it; the last one frees it, on any thread, taking the GIL; not after Python has ended.
struct Function {
  std::shared_ptr<const LawSampler> sampler;

  explicit Function(nb::object function) {
    const auto free = [](PyObject* last) {
      if (!nb::is_alive()) return;
      const nb::gil_scoped_acquire gil;
      Py_DECREF(last);
    };
    const std::shared_ptr<PyObject> shared(function.release().ptr(), free);
    sampler = std::make_shared<const LawSampler>(
        [shared](std::span<const double> psi, std::span<const double> parameters, std::span<double> f) {
          const nb::gil_scoped_acquire gil;  // released by fits
          nb::list values;
          for (const double one : parameters) values.append(one);
          const nb::object found = nb::handle(shared.get())(numpy_of({psi.begin(), psi.end()}), values);
          const Numbers numbers = nb::cast<Numbers>(found);
          std::copy_n(numbers.data(), std::min(numbers.size(), f.size()), f.begin());
        });
  }
};

void require(const std::string& problem) {
  if (!problem.empty()) throw InputError("parameters", problem);
}

ContactModel model_of(const std::string& key) {
  const auto model = ContactModel::find(key);
  if (!model) require("no model is called '" + key + "'");
  return *model;
}

/// A model for which these parameters and this load define a contact.
ContactModel model_of(const std::string& key, const std::vector<double>& parameters, double P) {
  const ContactModel model = model_of(key);
  require(model.problem(parameters, P));
  return model;
}

std::vector<ParameterInfo> parameters_of(const std::string& key) {
  const auto model = ContactModel::find(key);
  if (!model) return {};
  return {model->parameters().begin(), model->parameters().end()};
}

}  // namespace

Control control_of(const std::string& kind, double stiffness) {
  if (kind == "load") return {Control::Kind::load};
  if (kind == "displacement") return {Control::Kind::displacement};
  if (kind == "stiffness" && stiffness > 0) return {Control::Kind::stiffness, stiffness};
  throw InputError("control",
                   "is '" + kind + "'; it must be load, displacement, or stiffness with one that is positive");
}

void bind_mechanics(nb::module_& m) {
  m.def("model_keys", &model_keys);
  m.def("known_models", &known_models);
  m.def("forget_laws", &forget_laws, nb::call_guard<nb::gil_scoped_release>());
  m.def("provide_law", [](const std::string& key) { provide_law(key); });
  m.def("law_definition", [](const std::string& key) {  // None for other models
    const auto law = find_law(key);
    if (!law) return nb::object(nb::none());
    const LawDefinition& definition = law->definition();
    nb::list parameters;
    for (const LawParameter& one : definition.parameters)
      parameters.append(nb::make_tuple(one.name, one.lower, one.upper, one.start));
    return nb::object(
        nb::make_tuple(definition.text, parameters, definition.key, definition.name, definition.normalised));
  });
  nb::class_<Function>(m, "Function").def(nb::init<nb::object>());
  const auto define = [](const std::string& text, const std::vector<nb::tuple>& parameters, const std::string& key,
                         const std::string& name, bool normalised, const Function* function) {
    LawDefinition definition{key, text, {}, name, normalised, function ? function->sampler : nullptr};
    for (const nb::tuple& one : parameters) {
      LawParameter parameter{nb::cast<std::string>(one[0]), nb::cast<double>(one[1]), nb::cast<double>(one[2]), 0};
      parameter.start = one.size() > 3 ? nb::cast<double>(one[3]) : usual_start(parameter.lower, parameter.upper);
      definition.parameters.push_back(std::move(parameter));
    }
    DefinedLaw defined = define_law_checked("law", std::move(definition));
    return std::tuple(defined.law->definition().key, defined.law->shown(), std::move(defined.warnings));
  };
  m.def("define_law", define, "text"_a, "parameters"_a, "key"_a, "name"_a, "normalised"_a, "function"_a.none());
  m.def("parameter_names", [](const std::string& model) {  // empty for an unknown key
    std::vector<std::string> names;
    for (const ParameterInfo& one : parameters_of(model)) names.emplace_back(one.name);
    return names;
  });
  m.def("parameter_bounds", [](const std::string& model) {
    std::vector<std::pair<double, double>> bounds;
    for (const ParameterInfo& one : parameters_of(model)) bounds.emplace_back(one.lower, one.upper);
    return bounds;
  });
  m.def("areas", [](const std::string& model, const std::vector<Numbers>& parameters, const Numbers& P,
                    const Numbers& T, const Output& out, const Codes& status) {
    without_gil([&] {
      model_of(model).areas(values_of(parameters), values_of(P), values_of(T), span_of(out),
                            {reinterpret_cast<EquilibriumStatus*>(status.data()), status.size()});
    });
  });
  m.def("semi_axes", [](const std::string& model, const std::vector<Numbers>& parameters, const Numbers& P,
                        const Numbers& T, const Output& a, const Output& b) {
    without_gil(
        [&] { model_of(model).semi_axes(values_of(parameters), values_of(P), values_of(T), span_of(a), span_of(b)); });
  });
  m.def("area_slopes", [](const std::string& model, const std::vector<Numbers>& parameters, const Numbers& P,
                          const Numbers& T, const Numbers& A, const std::vector<Output>& slopes) {
    std::vector<std::span<double>> out;
    for (const Output& one : slopes) out.push_back(span_of(one));
    without_gil([&] {
      model_of(model).area_slopes(values_of(parameters), values_of(P), values_of(T), {A.data(), A.size()}, out);
    });
  });
  m.def("toughness_ratios",
        [](const std::string& model, const std::vector<Numbers>& parameters, const Numbers& psi, const Output& f) {
          without_gil([&] { model_of(model).toughness_ratios(values_of(parameters), values_of(psi), span_of(f)); });
        });
  m.def("tangential_loads", [](const std::string& model, const std::vector<Numbers>& parameters, const Numbers& P,
                               const Numbers& A, const Output& T) {
    without_gil(
        [&] { model_of(model).tangential_loads(values_of(parameters), values_of(P), values_of(A), span_of(T)); });
  });
  m.def("phase_angles", [](const Numbers& P, const Numbers& T, const Numbers& A, const Output& psi, const Output& f) {
    const Released released;
    const Values loads = values_of(P), shears = values_of(T), sizes = values_of(A);
    for (std::size_t i = 0; i < psi.size(); ++i) {
      const auto point = toughness_of_area(loads[i], std::abs(shears[i]), sizes[i]);
      psi.data()[i] = point ? phase_angle(point->mixity) : std::nan("");
      f.data()[i] = point ? point->ratio : std::nan("");
    }
  });
  m.def("folds", [](const std::string& model, const std::vector<double>& parameters, double P,
                    const std::string& control, double stiffness) {
    const Control by = control_of(control, stiffness);
    const std::vector<Fold> folds =
        without_gil([&] { return model_of(model, parameters, P).folds(parameters, P, by); });
    nb::list list;
    for (const Fold& fold : folds) list.append(shown(as_prediction(fold), false));
    return list;
  });
  m.def(
      "regime",
      [](const std::string& model, const std::vector<double>& parameters, double P, std::optional<double> tau0) {
        if (tau0 && !(*tau0 > 0)) require("the shear strength must be positive");
        const RegimeReport found =
            without_gil([&] { return model_of(model, parameters, P).regime(parameters, P, tau0).value(); });
        nb::dict one;
        one["regime"] = static_cast<int>(found.regime);
        one["fracture"] = static_cast<int>(found.fracture);
        one["regime_name"] = std::string(to_string(found.regime));
        one["fracture_name"] = std::string(to_string(found.fracture));
        one["T_end"] = found.T_end;
        one["T_strength"] = found.T_strength;
        one["jumps_to"] = found.jumps_to ? std::optional(std::string(to_string(*found.jumps_to))) : std::nullopt;
        return one;
      },
      "model"_a, "parameters"_a, "P"_a, "tau0"_a.none());
  m.def("curve", [](const std::string& model, const std::vector<double>& parameters, double P, std::size_t points) {
    const SampledCurve found =
        without_gil([&] { return model_of(model, parameters, P).curve(parameters, P, {.points = points}); });
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

}  // namespace mixity
