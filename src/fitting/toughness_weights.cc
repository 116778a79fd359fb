#include "fitting/toughness_weights.h"

#include <cmath>
#include <string>

#include "base/input_error.h"

namespace mixity {
namespace {

/// Standard errors of ln f (or f) over f minus the model's, from those of T and A.
std::vector<double> errors_of_loads(const Dataset& data, Scale scale, const std::vector<std::size_t>& used,
                                    const StandardErrors& errors, const ContactModel& model,
                                    std::span<const double> p) {
  const std::size_t n = used.size();
  std::vector<double> P, T, A, value(n), by_P(n), by_T(n), by_A(n), by_parameter(n * p.size()), found;
  for (const std::size_t i : used) {
    P.push_back(data.points[i].P);
    T.push_back(data.points[i].shear());
    A.push_back(data.points[i].A);
  }
  model.toughness_residuals(p, P, T, A, {value, by_P, by_T, by_A, by_parameter});
  for (std::size_t i = 0; i < n; ++i) {
    if (scale == Scale::linear) {
      // d(f_model - f) = f_model d(ln f_model - ln f) + (f_model - f) d(ln f), here over f
      const double a = radius_from_area(A[i]), y = edge_load(a, P[i]), y_A = 2 * a / pi<double>();
      const double square = y * y + T[i] * T[i], growth = std::expm1(value[i]);
      by_T[i] = (1 + growth) * by_T[i] + growth * 2 * T[i] / square;
      by_A[i] = (1 + growth) * by_A[i] + growth * y_A * (2 * y / square - 1 / (y + P[i]));
    }
    found.push_back(std::hypot(by_T[i] * errors.T[used[i]], by_A[i] * errors.A[used[i]]));
  }
  return found;
}

}  // namespace

std::vector<double> toughness_weights(const Dataset& data, Scale scale, const std::vector<std::size_t>& used,
                                      const std::optional<StandardErrors>& errors, const ContactModel& model,
                                      std::span<const double> p) {
  if (!data.has_loads && data.errors.empty())
    throw InputError(data.path, "needs a column " +
                                    std::string(data.has_energies ? "sigma_GI or sigma_GII" : "sigma_Gc") +
                                    " to weigh its points by");
  std::vector<double> of_loads, weights;
  if (data.has_loads) of_loads = errors_of_loads(data, scale, used, *errors, model, p);
  for (std::size_t k = 0; k < used.size(); ++k) {
    const double ratio = data.toughness(used[k])->ratio;
    const double error = data.has_loads ? of_loads[k] : data.errors_of(used[k]).ratio / ratio;
    if (!(error > 0))
      refuse_value(data, data.points[used[k]], data.has_energies ? "sigma_GI" : "sigma_Gc",
                   data.has_energies ? "this point has no standard error (sigma_GI and sigma_GII are 0 or empty)"
                                     : "this point has no standard error (sigma_Gc is 0 or empty)");
    weights.push_back(1 / (scale == Scale::log ? error : error * ratio));
  }
  return weights;
}

}  // namespace mixity
