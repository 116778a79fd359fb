// Weights of the points under the objective `toughness`, for --weighted.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/input_error.h"
#include "fitting/standard_errors.h"
#include "fitting/toughness.h"

namespace mixity {

/// 1/standard error of ln f (or f) minus the model's at the point's psi: through f and psi at once, from sigma_A and
/// sigma_T, or from the file's sigma_Gc. Throws InputError where a point has no error.
///
/// `errors`: of T and A, where the data have loads. Indices `used` into Dataset::points.
template <class Model>
std::vector<double> toughness_weights(const Dataset& data, Scale scale, const std::vector<std::size_t>& used,
                                      const std::optional<StandardErrors>& errors, const Parameters<Model>& p) {
  std::vector<double> weights;
  if (!data.has_loads && data.errors.empty())
    throw InputError(data.path, "needs a column " +
                                    std::string(data.has_energies ? "sigma_GI or sigma_GII" : "sigma_Gc") +
                                    " to weigh its points by");
  for (const std::size_t i : used) {
    const Point& point = data.points[i];
    const double ratio = data.toughness(i)->ratio;
    double error = data.errors_of(i).ratio / ratio;
    if (data.has_loads) {
      const double sigma_T = errors->T[i], sigma_A = errors->A[i];
      const auto r = toughness_residual<Model>(p, {point.P, point.shear(), point.A, sigma_T, sigma_A});
      double by_T = r->T, by_A = r->A;  // of ln f_model - ln f
      if (scale == Scale::linear) {
        // d(f_model - f) = f_model d(ln f_model - ln f) + (f_model - f) d(ln f), here over f
        const double a = radius_from_area(point.A), y = edge_load(a, point.P), y_A = 2 * a / pi<double>();
        const double square = y * y + point.T * point.T, growth = std::expm1(r->value);
        by_T = (1 + growth) * by_T + growth * 2 * point.shear() / square;
        by_A = (1 + growth) * by_A + growth * y_A * (2 * y / square - 1 / (y + point.P));
      }
      error = std::hypot(by_T * sigma_T, by_A * sigma_A);
    }
    if (!(error > 0))
      refuse_value(data, point, data.has_energies ? "sigma_GI" : "sigma_Gc",
                   data.has_energies ? "this point has no standard error (sigma_GI and sigma_GII are 0 or empty)"
                                     : "this point has no standard error (sigma_Gc is 0 or empty)");
    weights.push_back(1 / (scale == Scale::log ? error : error * ratio));
  }
  return weights;
}

}  // namespace mixity
