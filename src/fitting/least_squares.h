// A least-squares problem as the solver sees it: residuals and their Jacobian, whatever model or objective they
// come from.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fitting/bends.h"

namespace mixity {

/// A free parameter as the solver sees it, with its closed range.
struct FreeParameter {
  std::string name;
  double lower, upper;
  std::optional<double> start{};  // null: the whole range is scanned for starts
  // What a reader sees is scale exp(x) if logarithmic, else scale x.
  double scale = 1;
  bool logarithmic = false;
  std::string unit{};
  double neutral = 0;  // > 0: a value in the neighbourhood of which only the distance from it matters

  double shown(double x) const { return scale * (logarithmic ? std::exp(x) : x); }
  /// d shown/dx
  double shown_slope(double x) const { return logarithmic ? shown(x) : scale; }
};

class SingleCost;

class LeastSquares {
 public:
  virtual ~LeastSquares() = default;
  virtual std::size_t residual_count() const = 0;
  virtual const std::vector<FreeParameter>& parameters() const = 0;
  /// Fills residuals [n] and, unless it is empty, the Jacobian [n x p, row-major]. False if a value is not finite.
  virtual bool evaluate(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const = 0;
  /// Size of the data the residuals are differences of, sqrt(sum of squares): sets what rounding can do to them.
  virtual double data_norm() const = 0;
  /// True if the residuals are in units of known standard errors: what counts as a better fit is then measured by
  /// chi^2, otherwise by the scatter.
  virtual bool known_errors() const { return false; }
  /// Curvature of half the cost along each residual, which a robust loss bends; empty: 1, least squares.
  virtual std::vector<double> curvatures(std::span<const double>) const { return {}; }
  /// Places of a scan over one parameter, each spaced evenly and by factors.
  virtual std::size_t scan_density() const { return 64; }
  /// How many bends of the cost lie on one side of x. Between places where this differs, basins may be far narrower
  /// than the spacing of any scan.
  virtual std::size_t bends_passed(std::span<const double> /* x */) const { return 0; }
  /// With one free parameter, by which these bends are found; empty if there are none.
  virtual std::vector<LoadEnds> load_ends() const { return {}; }
  /// The cost for the batch engine; only with one free parameter. The problem must outlive it.
  virtual std::unique_ptr<SingleCost> single_cost() const;
};

/// Sum of squares at x; fills residuals [n]. Null if it is not finite.
inline std::optional<double> sum_of_squares(const LeastSquares& problem, std::span<const double> x,
                                            std::span<double> residuals) {
  if (!problem.evaluate(x, residuals, {})) return std::nullopt;
  double sum = 0;
  for (const double r : residuals) sum += r * r;
  return std::isfinite(sum) ? std::optional(sum) : std::nullopt;
}

/// A problem that changes another, which must outlive it, in some respect.
class WrappedProblem : public LeastSquares {
 public:
  explicit WrappedProblem(const LeastSquares& problem) : problem_(problem) {}
  std::size_t residual_count() const override { return problem_.residual_count(); }
  const std::vector<FreeParameter>& parameters() const override { return problem_.parameters(); }
  double data_norm() const override { return problem_.data_norm(); }
  bool known_errors() const override { return problem_.known_errors(); }

 protected:
  const LeastSquares& problem_;
};

/// What rounding of model and data puts into |r|, whatever the parameters: some eps |data|.
inline double residual_rounding(const LeastSquares& problem) {
  return 16 * std::numeric_limits<double>::epsilon() * problem.data_norm();
}

}  // namespace mixity
