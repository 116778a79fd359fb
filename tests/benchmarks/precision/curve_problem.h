// Distances from the equilibrium curves as a user of another library would minimise them, in a unit of his own: the
// residuals that the objective curve has, times a number.
#pragma once

#include <ceres/jet.h>

#include <vector>

#include "dataset/dataset.h"
#include "fitting/models.h"
#include "mechanics/registry.h"

namespace mixity::precision {

template <class Model>
class CurveProblem {
 public:
  double lower = Model::parameters[0].lower, upper = Model::parameters[0].upper;
  mutable long sweeps = 0;

  /// Standard errors of all points, dimensionless as the data; `unit`: the residual of a distance of one of them.
  CurveProblem(const Dataset& data, double sigma_T, double sigma_A, double unit)
      : sigma_T_(data.points.size(), sigma_T), sigma_A_(data.points.size(), sigma_A), unit_(unit) {
    for (const Point& point : data.points) {
      P_.push_back(point.P);
      T_.push_back(point.T);
      A_.push_back(point.A);
    }
  }
  std::size_t size() const { return P_.size(); }

  /// `slopes` may be null.
  bool evaluate(double x, double* residuals, double* slopes) const {
    ++sweeps;
    const std::size_t n = size();
    std::vector<double> by_data(slopes ? 3 * n : 0);
    const std::span<double> space(by_data), none;
    CurveDistances out{{residuals, n}, none, none, none, none};
    if (slopes) out = {{residuals, n}, space.first(n), space.subspan(n, n), space.subspan(2 * n, n), {slopes, n}};
    if (!model_.curve_distances(ParameterValues{x}, {P_, T_, A_, sigma_T_, sigma_A_}, Search::global, slopes != nullptr,
                                out))
      return false;
    for (std::size_t i = 0; i < n; ++i) {
      residuals[i] *= unit_;
      if (slopes) slopes[i] *= unit_;
    }
    return true;
  }

  bool operator()(const double* x, double* residuals) const { return evaluate(*x, residuals, nullptr); }
  /// Automatic derivatives carry the analytic ones on: the nearest place has no others.
  template <class T, int N>
  bool operator()(const ceres::Jet<T, N>* x, ceres::Jet<T, N>* residuals) const {
    std::vector<double> r(size()), slopes(size());
    if (!evaluate(x->a, r.data(), slopes.data())) return false;
    for (std::size_t i = 0; i < size(); ++i) residuals[i] = {r[i], slopes[i] * x->v};
    return true;
  }

 private:
  ContactModel model_ = model_named(std::string(Model::info.key));
  std::vector<double> P_, T_, A_, sigma_T_, sigma_A_;
  double unit_;
};

}  // namespace mixity::precision
