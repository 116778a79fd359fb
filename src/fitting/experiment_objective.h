// Objectives on measured loads and areas (P, T, A), with any of the model's parameters and corrections to the
// experiment's constants free: `area`, `curve`, and `toughness` when a constant is free.
#pragma once

#include <algorithm>
#include <numeric>

#include "fitting/model_problem.h"
#include "fitting/residuals.h"

namespace mixity {

/// Residuals is one of fitting/residuals.h.
template <class Model, template <class> class Residuals>
class ExperimentObjective final : public ModelProblem<Model> {
 public:
  /// `targets` and `weights`: what the reported R^2 compares with, one per point.
  ExperimentObjective(const std::vector<MeasuredPoint>& points, std::vector<double> targets,
                      std::vector<double> weights, FreeChoice<Model> choice)
      : targets_(std::move(targets)), weights_(std::move(weights)), choice_(std::move(choice)), order_(points.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::size_t i, std::size_t j) { return points[i].P < points[j].P; });
    for (const std::size_t i : order_) {
      if (points_.empty() || points_.back().P != points[i].P) runs_.push_back(points_.size());
      points_.push_back(points[i]);
      // no point's nearest place on its curve lies further out than a few standard errors
      T_most_ = std::max(T_most_, points[i].T + 10 * points[i].sigma_T);
    }
    runs_.push_back(points_.size());
  }

  std::size_t residual_count() const override { return points_.size(); }
  const std::vector<FreeParameter>& parameters() const override { return choice_.parameters(); }
  const std::vector<double>& targets() const override { return targets_; }
  const std::vector<double>& weights() const override { return weights_; }
  Trial<Model> trial(std::span<const double> x) const override { return choice_.trial(x); }
  double data_norm() const override {
    double square = std::pow(ModelProblem<Model>::data_norm(), 2);
    if constexpr (std::is_same_v<Residuals<Model>, ToughnessResiduals<Model>>)  // an eps of f, however small ln f is
      square += static_cast<double>(points_.size());
    if constexpr (std::is_same_v<Residuals<Model>, CurveResiduals<Model>>)  // T is data there, too
      for (const MeasuredPoint& point : points_)
        if (point.sigma_T > 0) square += std::pow(point.T / point.sigma_T, 2);
    return std::sqrt(square);
  }

  bool evaluate(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const override {
    std::vector<double> values;
    bool finite = true;
    const bool defined = each_load(x, [&](Residuals<Model>& of_load, std::span<const MeasuredPoint> points,
                                          std::span<const std::size_t> places, const CorrectedScale& scale) {
      if constexpr (requires { of_load.values(points, values); })
        if (jacobian.empty()) {
          values.resize(points.size());
          if (!of_load.values(points, values)) return false;
          for (std::size_t i = 0; i < points.size(); ++i) {
            residuals[places[i]] = values[i];
            finite &= std::isfinite(values[i]);
          }
          return true;
        }
      for (std::size_t i = 0; i < points.size(); ++i) {
        const auto r = of_load(points[i]);
        if (!r) return false;
        residuals[places[i]] = r->value;
        finite &= std::isfinite(r->value);
        if (jacobian.empty()) continue;
        const std::span<double> row = jacobian.subspan(places[i] * choice_.size(), choice_.size());
        std::size_t k = 0;
        for (const std::size_t parameter : choice_.model()) row[k++] = r->parameters[parameter];
        for (const Correction correction : choice_.corrections()) row[k++] = slope(*r, correction, points[i], scale);
        for (const double value : row) finite &= std::isfinite(value);
      }
      return true;
    });
    return defined && finite;
  }

  /// Every point that passes a fold bends the cost of areas.
  std::size_t bends_passed(std::span<const double> x) const override {
    std::size_t count = 0;
    if constexpr (std::is_same_v<Residuals<Model>, AreaResiduals<Model>>)
      each_load(x, [&](const Residuals<Model>& of_load, std::span<const MeasuredPoint> points, auto, auto) {
        count += of_load.beyond_ends(points);
        return true;
      });
    return count;
  }

  std::vector<LoadEnds> load_ends() const override {
    std::vector<LoadEnds> loads;
    if constexpr (std::is_same_v<Residuals<Model>, AreaResiduals<Model>>)
      for (std::size_t run = 0; run + 1 < runs_.size(); ++run) {
        LoadEnds& load = loads.emplace_back();
        for (std::size_t i = runs_[run]; i < runs_[run + 1]; ++i) {
          load.shears.push_back(points_[i].T);
          load.points.push_back(order_[i]);
        }
        load.ends = [this, P = points_[runs_[run]].P](double x) {
          const Trial<Model> at = trial({&x, 1});
          const CorrectedScale scale(at.corrections);
          const LoadedContact<Model> contact(at.parameters, scale.load(P));
          std::vector<double> ends;
          if (contact.obstacle().empty() && contact.in_contact())
            for (const StableBranch& branch : contact.branches()) ends.push_back(branch.T_bottom / scale.force);
          return ends;
        };
      }
    return loads;
  }

 private:
  /// Calls use(residuals of a load, its points as corrected, their places among the residuals, the correction's scale)
  /// until it returns false. False then, and where a correction leaves no area.
  template <class Use>
  bool each_load(std::span<const double> x, Use&& use) const {
    const Trial<Model> at = trial(x);
    const CorrectedScale scale(at.corrections);
    std::vector<MeasuredPoint> corrected;
    if (at.corrections != Corrections{})
      for (const MeasuredPoint& point : points_) {
        corrected.push_back({scale.load(point.P), scale.shear(point.T), scale.true_area(point.A),
                             scale.force * point.sigma_T, scale.area * point.sigma_A});
        if (!(corrected.back().A > 0)) return false;
      }
    const std::span<const MeasuredPoint> points = corrected.empty() ? points_ : corrected;
    for (std::size_t run = 0; run + 1 < runs_.size(); ++run) {
      const std::size_t from = runs_[run], count = runs_[run + 1] - from;
      Residuals<Model> of_load(at.parameters, points[from].P, scale.shear(T_most_));
      if (!use(of_load, points.subspan(from, count), std::span(order_).subspan(from, count), scale)) return false;
    }
    return true;
  }

  /// Chain rule through CorrectedScale.
  static double slope(const PointResidual<Model>& r, Correction correction, const MeasuredPoint& scaled,
                      const CorrectedScale& scale) {
    const double by_force = -(r.P * scaled.P + r.T * scaled.T + r.log_sigma_T);
    const double by_area = 2.0 / 3 * (r.A * scaled.A + r.log_sigma_A);
    switch (correction) {
      case kToughness:
        return by_force - by_area;
      case kModulus:
        return by_area;
      case kLoadOffset:
        return r.P * scale.force;
      case kAreaOffset:
        break;
    }
    return r.A * scale.area;
  }

  std::vector<MeasuredPoint> points_;  // by load: all points of one share what depends on it alone
  std::vector<std::size_t> runs_;      // where each load begins, and the end
  std::vector<double> targets_, weights_;
  FreeChoice<Model> choice_;
  std::vector<std::size_t> order_;  // of each in points_: its place in the residuals
  double T_most_ = 0;
};

}  // namespace mixity
