// The folds and the stable branches of a contact whose approach is held.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "mechanics/held_curve.h"

namespace mixity {

/// A part of the curve along which the driving quantity rises from `from` to `to`.
struct HeldStretch {
  double begin, end;  // u
  double from, to;
  bool ends_in_fold;
};

template <class Law>
class HeldBranches {
 public:
  /// Of T under load control, u = 3/4 T/a under displacement control, u + T/k through a spring.
  HeldBranches(const HeldCurve<Law>& curve, Control control) : curve_(curve), control_(control) {
    if (!curve.uncoupled()) search();
  }

  struct Turn {
    double u;
    bool maximum;
  };
  const std::vector<Turn>& folds() const { return folds_; }
  const std::vector<HeldStretch>& stretches() const { return stretches_; }

  double driving(const typename HeldCurve<Law>::State& s) const {
    switch (control_.kind) {
      case Control::Kind::load:
        return s.T;
      case Control::Kind::displacement:
        return 0.75 * s.T / s.a;
      case Control::Kind::stiffness:
        break;
    }
    return 0.75 * s.T / s.a + s.T / control_.stiffness;
  }

  /// The u of the first stretch in which the driving quantity has this value, from stretch number `first` on.
  std::optional<double> first_at(double value, std::size_t first = 0) const {
    constexpr double kMost = 1000;
    for (std::size_t k = first; k < stretches_.size(); ++k) {
      const HeldStretch& one = stretches_[k];
      if (!(value >= one.from && value <= one.to)) continue;
      if (value == one.from) return one.begin;
      // the logarithm, since the value grows without bound towards an asymptote; finite where it is 0
      return root_between(
          [&](double u) {
            const double there = u < one.end ? driving(curve_.at(u)) : one.to;
            return std::isnan(there) ? kMost : std::clamp(std::log(there / value), -kMost, kMost);
          },
          one.begin, one.end);
    }
    return std::nullopt;
  }

 private:
  void search() {
    constexpr int kSteps = 256;
    constexpr double kRounding = 1e-13, kBeforeEnd = 1e-9;
    // (da, dT) is along (-G_T, G_a), of which each sum is over 24 pi a^2
    const auto rises = [&](double u) {
      const auto s = curve_.at(u);
      const auto G = curve_.slopes(s);
      const double of_u = 0.75 * (G.a * s.a + s.T * G.T), scale = 24 * pi<double>() * s.a * s.a;
      if (control_.kind == Control::Kind::load) return G.a / scale;
      if (control_.kind == Control::Kind::displacement) return of_u / (s.a * scale);
      return (of_u / (s.a * s.a) + G.a / control_.stiffness) / ((1 / s.a + 1 / control_.stiffness) * scale);
    };
    const double last = curve_.last() * (1 - kBeforeEnd);
    double begin = 0;
    bool stable = true;
    for_sign_changes(
        rises, 0, last, kRounding, [&](double) { return last / kSteps; },
        [&](double u, bool falls) {
          folds_.push_back({u, falls});
          if (falls) add(begin, u, true);
          stable = !falls;
          begin = u;
          return true;
        });
    if (!stable) return;
    if (curve_.has_asymptote())
      stretches_.push_back(
          {begin, curve_.last(), driving(curve_.at(begin)), std::numeric_limits<double>::infinity(), false});
    else
      add(begin, curve_.last(), false);
  }
  void add(double begin, double end, bool fold) {
    stretches_.push_back({begin, end, driving(curve_.at(begin)), driving(curve_.at(end)), fold});
  }

  const HeldCurve<Law>& curve_;
  Control control_;
  std::vector<Turn> folds_;
  std::vector<HeldStretch> stretches_;
};

}  // namespace mixity
