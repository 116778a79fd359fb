#include "mechanics/contact_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/batch.h"
#include "mechanics/contact.h"
#include "mechanics/roots.h"
#include "mechanics/sampling.h"
#include "mechanics/sensitivity.h"
#include "mechanics/turning_curve.h"

namespace mixity {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

template <class Model>
Parameters<Model> parameters_at(std::span<const Values> parameters, std::size_t i) {
  Parameters<Model> p;
  for (std::size_t k = 0; k < p.size(); ++k) p[k] = parameters[k][i];
  return p;
}

template <class Model>
Parameters<Model> parameters_of(std::span<const double> values) {
  Parameters<Model> p;
  std::copy_n(values.begin(), p.size(), p.begin());
  return p;
}

/// Calls use(contact, p) for a contact that exists; else returns why there is none.
template <class Use>
std::string with_contact(std::string_view model, std::span<const double> parameters, double P, Use use) {
  std::string problem = parameters_problem(model, parameters);
  if (!problem.empty()) return problem;
  with_model(model, [&](auto instance) {
    using Model = decltype(instance);
    const auto p = parameters_of<Model>(parameters);
    const LoadedContact<Model> contact(p, P);
    problem = contact.obstacle();
    if (problem.empty() && !contact.in_contact()) problem = "no contact exists below the pull-off load -3 pi/2 R G_Ic";
    if (problem.empty()) use(contact, p);
  });
  return problem;
}

/// Calls use(instance) for the model of this key if so many parameters are its own; false if there is none.
template <class Use>
bool with_rows(std::string_view model, std::span<const Values> parameters, Use use) {
  bool fits = false;
  with_model(model, [&](auto instance) {
    fits = parameter_count<decltype(instance)> == parameters.size();
    if (fits) use(instance);
  });
  return fits;
}

/// T at which a contact whose law turns first has the edge load y on its way from T = 0; NaN where it never has.
template <class Model>
double first_tangential_load(const Parameters<Model>& p, double P, double y) {
  constexpr double kFirst = -40, kStep = 0.125, kLast = 42, kRounding = 8 * std::numeric_limits<double>::epsilon();
  const TurningCurve<Model> curve(p, P);
  const double half = 0.5 * curve.length();
  const double last = curve.closed() ? std::log(curve.at(half, half).t)
                                     : (curve.grows_over_all_bounds() ? std::log(std::tan(curve.length())) : kLast);
  // above y, by x = ln(T/y); on a curve that closes also on the way back, where the product of both y is -6 pi P/g
  const auto excess = [&](double x, bool back) {
    const double upper = curve.upper_edge_load(std::exp(std::min(x, last))).value_or(-2 * P);
    return std::log((back ? -P * upper / (upper + P) : upper) / y);
  };
  if (std::abs(excess(kFirst, false)) <= kRounding) return 0;
  double found = kNaN;
  const auto look = [&](bool back, double from, double to) {
    const double way = back ? -1 : 1;
    for_sign_changes([&](double v) { return excess(way * v, back); }, way * from, way * to, kRounding,
                     [&](double) { return kStep; },
                     [&](double v, bool) {
                       found = y * std::exp(way * v);
                       return false;
                     });
  };
  look(false, kFirst, last);
  if (std::isnan(found) && curve.closed()) look(true, last, kFirst);
  return found;
}

template <class Model>
void fill_areas(std::span<const Values> parameters, Values P, Values T, std::span<double> A,
                std::span<EquilibriumStatus> status) {
  std::vector<double> turned;
  for (std::size_t begin = 0; begin < A.size();) {
    const Parameters<Model> p = parameters_at<Model>(parameters, begin);
    std::size_t end = begin + 1;
    while (end < A.size() && P[end] == P[begin] && parameters_at<Model>(parameters, end) == p) ++end;
    const LoadedContact<Model> contact(p, P[begin]);
    const std::span<double> found = A.subspan(begin, end - begin);
    std::span<const double> shears(T.first + static_cast<std::ptrdiff_t>(begin) * T.step,
                                   T.step == 1 ? end - begin : 0);
    if (T.step != 1 || std::any_of(shears.begin(), shears.end(), [](double t) { return t < 0; })) {
      turned.resize(end - begin);
      for (std::size_t i = begin; i < end; ++i) turned[i - begin] = std::abs(T[i]);
      shears = turned;
    }
    const std::size_t ok = predict_areas(contact, p, P[begin], shears, found);
    std::fill_n(status.begin() + static_cast<std::ptrdiff_t>(begin), end - begin, EquilibriumStatus::ok);
    for (std::size_t i = begin; ok < found.size() && i < end; ++i) {
      if (A[i] != 0) continue;
      A[i] = kNaN;
      const bool valid = contact.obstacle().empty() && std::abs(T[i]) <= kLargestLoad;
      status[i] = valid ? EquilibriumStatus::no_equilibrium : EquilibriumStatus::invalid;
    }
    begin = end;
  }
}

}  // namespace

std::vector<std::string> parameter_names(std::string_view model) {
  std::vector<std::string> names;
  with_model(model, [&](auto instance) {
    for (const ParameterInfo& info : decltype(instance)::parameters) names.emplace_back(info.name);
  });
  return names;
}

std::vector<std::pair<double, double>> parameter_bounds(std::string_view model) {
  std::vector<std::pair<double, double>> bounds;
  with_model(model, [&](auto instance) {
    for (const ParameterInfo& info : decltype(instance)::parameters) bounds.emplace_back(info.lower, info.upper);
  });
  return bounds;
}

std::string parameters_problem(std::string_view model, std::span<const double> parameters) {
  std::string problem = "no model is called '" + std::string(model) + "'";
  with_model(model, [&](auto instance) {
    using Model = decltype(instance);
    constexpr std::size_t n = parameter_count<Model>;
    problem.clear();
    if (parameters.size() != n) {
      problem = "model " + std::string(model) + " has " + std::to_string(n) + (n == 1 ? " parameter" : " parameters") +
                ", not " + std::to_string(parameters.size());
      return;
    }
    problem = contact_obstacle<Model>(parameters_of<Model>(parameters), 0.0);
  });
  return problem;
}

void areas(std::string_view model, std::span<const Values> parameters, Values P, Values T, std::span<double> A,
           std::span<EquilibriumStatus> status) {
  const auto fill = [&](auto instance) { fill_areas<decltype(instance)>(parameters, P, T, A, status); };
  if (with_rows(model, parameters, fill)) return;
  std::fill(A.begin(), A.end(), kNaN);
  std::fill(status.begin(), status.end(), EquilibriumStatus::invalid);
}

void area_slopes(std::string_view model, std::span<const Values> parameters, Values P, Values T,
                 std::span<const double> A, std::span<const std::span<double>> slopes) {
  for (const std::span<double> of_one : slopes) std::fill(of_one.begin(), of_one.end(), kNaN);
  with_rows(model, parameters, [&](auto instance) {
    using Model = decltype(instance);
    for (std::size_t i = 0; i < A.size(); ++i) {
      const double y = edge_load(radius_from_area(A[i]), P[i]);
      if (!(y >= 0)) continue;
      const auto gradient = equilibrium_gradient<Model>(parameters_at<Model>(parameters, i), P[i], std::abs(T[i]), y);
      for (std::size_t k = 0; k < slopes.size(); ++k) slopes[k][i] = -gradient.parameters[k] / gradient.A;
    }
  });
}

void toughness_ratios(std::string_view model, std::span<const Values> parameters, Values psi, std::span<double> f) {
  std::fill(f.begin(), f.end(), kNaN);
  with_rows(model, parameters, [&](auto instance) {
    using Model = decltype(instance);
    for (std::size_t i = 0; i < f.size(); ++i) {
      const auto p = parameters_at<Model>(parameters, i);
      if (!(psi[i] >= 0 && psi[i] <= kLargestPhaseAngle) || !in_bounds<Model>(p)) continue;
      f[i] = std::exp(log_toughness_alone<Model>(p, mixity_from_angle(psi[i])));
    }
  });
}

void tangential_loads(std::string_view model, std::span<const Values> parameters, Values P, Values A,
                      std::span<double> T) {
  std::fill(T.begin(), T.end(), kNaN);
  with_rows(model, parameters, [&](auto instance) {
    using Model = decltype(instance);
    for (std::size_t i = 0; i < T.size(); ++i) {
      const auto p = parameters_at<Model>(parameters, i);
      if (!contact_obstacle<Model>(p, P[i]).empty() || above_pull_off(P[i]) < 0 || !(A[i] > 0)) continue;
      const double y = edge_load(radius_from_area(A[i]), P[i]), S0 = circle_radius(P[i]), v = y - 3 * pi<double>();
      if constexpr (kMayTurn<Model>) {
        if (turns<Model>(p)) {
          if (y > 0) T[i] = first_tangential_load<Model>(p, P[i], y);
          continue;
        }
      }
      if (!(y > 0) || !(std::abs(v) <= S0 * (1 + 8 * std::numeric_limits<double>::epsilon()))) continue;
      const double found = tangential_load<Model>(p, y, std::sqrt(std::max(0.0, (S0 - v) * (S0 + v))));
      if (std::isfinite(found)) T[i] = found;
    }
  });
}

FoldsOrProblem folds_of(std::string_view model, std::span<const double> parameters, double P, Control control) {
  FoldsOrProblem found;
  found.problem = with_contact(model, parameters, P, [&]<class Model>(const LoadedContact<Model>&, const auto& p) {
    found.folds = find_folds(EquilibriumCurve<Model>(p, P), control);
  });
  return found;
}

RegimeOrProblem regime_of(std::string_view model, std::span<const double> parameters, double P,
                          std::optional<double> tau0) {
  RegimeOrProblem found;
  if (tau0 && !(*tau0 > 0)) return {{}, "the shear strength must be positive"};
  found.problem = with_contact(model, parameters, P, [&]<class Model>(const LoadedContact<Model>&, const auto& p) {
    found.regime = classify<Model>(p, P, tau0);
  });
  return found;
}

std::optional<double> critical_load_of(std::string_view model, std::span<const double> parameters) {
  std::optional<double> load;
  if (!parameters_problem(model, parameters).empty()) return load;
  with_model(model, [&](auto instance) {
    using Model = decltype(instance);
    load = critical_load<Model>(parameters_of<Model>(parameters));
  });
  return load;
}

CurveOrProblem curve_of(std::string_view model, std::span<const double> parameters, double P, std::size_t points) {
  CurveOrProblem found;
  found.problem = with_contact(model, parameters, P, [&]<class Model>(const LoadedContact<Model>&, const auto& p) {
    const EquilibriumCurve<Model> curve(p, P);
    found.points = curve.uncoupled()
                       ? std::vector{curve.point(0)}
                       : sample_uniform(curve, drawable_ranges(curve, kFarthestDrawn * shear_scale(curve)),
                                        std::max<std::size_t>(points, 2));
  });
  return found;
}

}  // namespace mixity
