#include <algorithm>
#include <cmath>
#include <limits>

#include "base/stop.h"
#include "mechanics/any_law.h"
#include "mechanics/batch.h"
#include "mechanics/contact.h"
#include "mechanics/contact_model.h"
#include "mechanics/elliptic_model.h"
#include "mechanics/equilibrium.h"
#include "mechanics/held_model.h"
#include "mechanics/non_monotone_curve.h"
#include "mechanics/roots.h"
#include "mechanics/sensitivity.h"

namespace mixity {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// T at which a contact under a non-monotone law first reaches the edge load y from T = 0; NaN if it never does.
template <class Law>
double first_tangential_load(const Law& law, const Parameters<Law>& p, double P, double y) {
  constexpr double kFirst = -40, kStep = 0.125, kLast = 42, kRounding = 8 * std::numeric_limits<double>::epsilon();
  const NonMonotoneCurve curve(law, p, P);
  const double half = 0.5 * curve.length();
  const double last = curve.closed() ? std::log(curve.at(half, half).t)
                                     : (curve.grows_over_all_bounds() ? std::log(std::tan(curve.length())) : kLast);
  // ln of the curve's edge load over y at x = ln(T/y); on the way back the product of both edge loads is -6 pi P/g
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

}  // namespace

void ContactModel::areas(std::span<const Values> parameters, Values P, Values T, std::span<double> A,
                         std::span<EquilibriumStatus> status) const {
  if (parameters.size() != law_->parameters.size()) {
    std::fill(A.begin(), A.end(), kNaN);
    std::fill(status.begin(), status.end(), EquilibriumStatus::invalid);
    return;
  }
  if (law_->held) return held::areas(*law_, parameters, P, T, A, status);
  if (law_->ellipse) return elliptic::areas(*law_->ellipse, parameters, P, T, A, status);
  with_law(*law_, [&]<class Law>(const Law& law) {
    std::vector<double> positive;
    for (std::size_t begin = 0; begin < A.size();) {
      const Parameters<Law> p = parameters_at<Law>(parameters, begin);
      std::size_t end = begin + 1;
      while (end < A.size() && P[end] == P[begin] && parameters_at<Law>(parameters, end) == p) ++end;
      const LoadedContact contact(law, p, P[begin]);
      const std::span<double> found = A.subspan(begin, end - begin);
      std::span<const double> shears(T.first + static_cast<std::ptrdiff_t>(begin) * T.step,
                                     T.step == 1 ? end - begin : 0);
      if (T.step != 1 || std::any_of(shears.begin(), shears.end(), [](double t) { return t < 0; })) {
        positive.resize(end - begin);
        for (std::size_t i = begin; i < end; ++i) positive[i - begin] = std::abs(T[i]);
        shears = positive;
      }
      const std::size_t ok = predict_areas(contact, shears, found);
      std::fill_n(status.begin() + static_cast<std::ptrdiff_t>(begin), end - begin, EquilibriumStatus::ok);
      for (std::size_t i = begin; ok < found.size() && i < end; ++i) {
        if (A[i] != 0) continue;
        A[i] = kNaN;
        const bool valid = contact.obstacle().empty() && std::abs(T[i]) <= kLargestLoad;
        status[i] = valid ? EquilibriumStatus::no_equilibrium : EquilibriumStatus::invalid;
      }
      begin = end;
    }
  });
}

void ContactModel::semi_axes(std::span<const Values> parameters, Values P, Values T, std::span<double> a,
                             std::span<double> b) const {
  if (law_->ellipse && parameters.size() == law_->parameters.size())
    return elliptic::semi_axes(*law_->ellipse, parameters, P, T, a, b);
  std::vector<EquilibriumStatus> status(a.size());
  areas(parameters, P, T, a, status);
  for (double& one : a) one = radius_from_area(one);
  std::copy(a.begin(), a.end(), b.begin());
}

void ContactModel::areas_at(ParameterSpan p, double P, std::span<const double> T, std::span<double> A,
                            std::span<EquilibriumStatus> status) const {
  std::vector<Values> all;
  for (const double& one : p) all.push_back({&one, 0});
  areas(all, {&P, 0}, {T.data(), 1}, A, status);
}

void ContactModel::area_slopes(std::span<const Values> parameters, Values P, Values T, std::span<const double> A,
                               std::span<const std::span<double>> slopes) const {
  for (const std::span<double> of_one : slopes) std::fill(of_one.begin(), of_one.end(), kNaN);
  if (parameters.size() != law_->parameters.size()) return;
  if (law_->held) return held::area_slopes(*law_, parameters, P, T, A, slopes);
  if (law_->ellipse) return elliptic::area_slopes(*law_->ellipse, parameters, P, T, A, slopes);
  with_law(*law_, [&]<class Law>(const Law& law) {
    for (std::size_t i = 0; i < A.size(); ++i) {
      const double y = edge_load(radius_from_area(A[i]), P[i]);
      if (!(y >= 0)) continue;
      const auto gradient = equilibrium_gradient(law, parameters_at<Law>(parameters, i), P[i], std::abs(T[i]), y);
      for (std::size_t k = 0; k < slopes.size(); ++k) slopes[k][i] = -gradient.parameters[k] / gradient.A;
    }
  });
}

void ContactModel::tangential_loads(std::span<const Values> parameters, Values P, Values A, std::span<double> T) const {
  std::fill(T.begin(), T.end(), kNaN);
  if (parameters.size() != law_->parameters.size()) return;
  if (law_->held) return held::tangential_loads(*law_, parameters, P, A, T);
  if (law_->ellipse) return elliptic::tangential_loads(*law_->ellipse, parameters, P, A, T);
  with_law(*law_, [&]<class Law>(const Law& law) {
    for (std::size_t i = 0; i < T.size(); ++i) {
      may_go_on();
      const auto p = parameters_at<Law>(parameters, i);
      if (!contact_obstacle(law, p, P[i]).empty() || above_pull_off(P[i]) < 0 || !(A[i] > 0)) continue;
      const double y = edge_load(radius_from_area(A[i]), P[i]), S0 = circle_radius(P[i]), v = y - 3 * pi<double>();
      if constexpr (kMayBeNonMonotone<Law>) {
        if (is_non_monotone(law, p)) {
          if (y > 0) T[i] = first_tangential_load(law, p, P[i], y);
          continue;
        }
      }
      if (!(y > 0) || !(std::abs(v) <= S0 * (1 + 8 * std::numeric_limits<double>::epsilon()))) continue;
      const double found = tangential_load(law, p, y, std::sqrt(std::max(0.0, (S0 - v) * (S0 + v))));
      if (std::isfinite(found)) T[i] = found;
    }
  });
}

Equilibria ContactModel::equilibria(ParameterSpan p, double P, std::span<const double> T) const {
  if (law_->held) return held::equilibria(*law_, p, P, T);
  if (law_->ellipse) return elliptic::equilibria(*law_->ellipse, p, P, T);
  return with_law(*law_, p, [&](const auto& law, const auto& values) {
    const LoadedContact contact(law, values, P);
    Equilibria found;
    found.at.reserve(T.size());
    bool beyond = false;
    for (const double shear : T) {
      found.at.push_back(contact.at(shear));
      beyond |= found.at.back().status != EquilibriumStatus::ok;
    }
    if (beyond && contact.in_contact()) found.last = contact.branches().back();
    return found;
  });
}

}  // namespace mixity
