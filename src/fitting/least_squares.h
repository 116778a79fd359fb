// A least-squares problem as the solver sees it: residuals and their Jacobian, whatever model or objective they
// come from.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace mixity {

/// A free parameter: its closed range.
struct FreeParameter {
  std::string name;
  double lower, upper;
};

class LeastSquares {
 public:
  virtual ~LeastSquares() = default;
  virtual std::size_t residual_count() const = 0;
  virtual const std::vector<FreeParameter>& parameters() const = 0;
  /// Fills residuals [n] and, unless it is empty, the Jacobian [n x p, row-major]. False if a value is not finite.
  virtual bool evaluate(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const = 0;
  /// Size of the data the residuals are differences of, sqrt(sum of squares): sets what rounding can do to them.
  virtual double data_norm() const = 0;
};

}  // namespace mixity
