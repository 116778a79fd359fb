// A least-squares problem: residuals and their Jacobian in bounded parameters, independent of their origin.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace mixity {

/// A parameter to fit, with its closed range.
struct FreeParameter {
  std::string name;
  double lower, upper;
  // Where the fit starts; the range is then only wide, and its ends are no physical bounds. Null: the whole range is
  // searched.
  std::optional<double> start{};
  // The shown value is scale exp(x) if logarithmic, else scale x.
  double scale = 1;
  bool logarithmic = false;
  std::string unit{};
  double prior = 0;    // standard error of a prior about `start`; 0: no prior
  double neutral = 0;  // > 0: near this value only the distance from it matters

  double width() const { return upper - lower; }
  double clamped(double x) const { return std::clamp(x, lower, upper); }
  bool at_bound(double x) const { return x <= lower || x >= upper; }
  /// Whether x is at a bound beyond which a cost with this slope would fall further.
  bool held_by_bound(double x, double slope) const { return (x <= lower && slope > 0) || (x >= upper && slope < 0); }
  /// The smallest |x| that matters for this range; tiny if the range is infinite.
  double least_size() const { return std::isfinite(width()) ? 1e-9 * width() : 1e-100; }
  double shown(double x) const { return scale * (logarithmic ? std::exp(x) : x); }
  double solver_value(double shown) const { return logarithmic ? std::log(shown / scale) : shown / scale; }
  /// d shown/dx
  double shown_slope(double x) const { return logarithmic ? shown(x) : scale; }
};

/// S = sum w_i r_i^2. Gradient and Hessian are those of S/2.
struct CostValue {
  double value = 0;
  Eigen::VectorXd gradient;    // J'W r
  Eigen::MatrixXd hessian;     // J'W J, plus sum w r r'' where the curvature is exact
  Eigen::VectorXd slope_size;  // |J_k| of each column, for the scale-free test of the gradient
  bool finite = false;
};

/// The cost of a problem. Serves one thread: it owns its scratch arrays.
class Cost {
 public:
  virtual ~Cost() = default;
  /// False if the Hessian is Gauss-Newton's, without r r''.
  virtual bool exact_curvature() const { return false; }
  /// Weights: one per residual; empty: 1. Fills `cost`, reusing its memory.
  virtual void at(std::span<const double> x, std::span<const double> weights, CostValue& cost) = 0;
  /// Saves the memory of earlier evaluations.
  virtual void keep() {}
  /// Restores the saved memory, so that results do not depend on evaluations since keep().
  virtual void restore() {}
};

class Problem {
 public:
  virtual ~Problem() = default;
  virtual std::size_t residual_count() const = 0;
  virtual const std::vector<FreeParameter>& parameters() const = 0;
  /// Fills residuals [n] and, unless it is empty, the Jacobian [n x p, row-major]. False if a value is not finite.
  /// Several threads may call it at once.
  virtual bool evaluate(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const = 0;
  /// The same to rounding, but faster close to the last parameters if the problem stores intermediate results in
  /// `memory`, which is empty at first.
  virtual bool evaluate_again(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian,
                              std::vector<double>& /* memory */) const {
    return evaluate(x, residuals, jacobian);
  }
  /// The number of parts in which the rows can be evaluated, for sums over many rows without an array of all. One for
  /// few rows and for rows that depend on each other; these are then in order.
  virtual std::size_t parts() const { return 1; }
  /// Fills residuals and Jacobian of a part, resizing both.
  virtual bool evaluate_part(std::size_t /* part */, std::span<const double> x, std::vector<double>& residuals,
                             std::vector<double>& jacobian) const {
    residuals.resize(residual_count());
    jacobian.resize(residual_count() * x.size());
    return evaluate(x, residuals, jacobian);
  }
  /// How many numbers evaluate_part_again stores for all parts.
  virtual std::size_t memory_of_parts() const { return 0; }
  /// The same with intermediate results, as evaluate_again has them: `memory` is that of all parts, and 0 at first.
  /// Several threads may evaluate different parts.
  virtual bool evaluate_part_again(std::size_t part, std::span<const double> x, std::vector<double>& residuals,
                                   std::vector<double>& jacobian, std::span<double> /* memory */) const {
    return evaluate_part(part, x, residuals, jacobian);
  }
  /// For the search for starts: cheap residuals, right to about a factor of two. Some points, always the same, may be
  /// left out (0).
  virtual bool evaluate_roughly(std::span<const double> x, std::span<double> residuals) const {
    return evaluate(x, residuals, {});
  }
  /// Norm of the data from which the residuals are differences; it limits their rounding errors.
  virtual double data_norm() const = 0;
  /// True if the residuals are in units of known standard errors. Otherwise the scatter sets the scale.
  virtual bool known_errors() const { return false; }
  /// Second derivative of half the cost in each residual; empty: 1 (least squares, no robust loss).
  virtual std::vector<double> curvatures(std::span<const double>) const { return {}; }
  /// The number of values that a search over this many parameters tries for each: half evenly spaced, half by factors.
  virtual std::size_t scan_density(std::size_t searched) const { return searched == 1 ? 64 : searched == 2 ? 16 : 8; }
  /// The cost for the kernel (kernel.h), which the problem must outlive.
  virtual std::unique_ptr<Cost> cost() const;
};

/// Sum of squares at x; fills residuals [n]. Null if not finite.
inline std::optional<double> sum_of_squares(const Problem& problem, std::span<const double> x,
                                            std::span<double> residuals) {
  if (!problem.evaluate(x, residuals, {})) return std::nullopt;
  const double sum = std::inner_product(residuals.begin(), residuals.end(), residuals.begin(), 0.0);
  return std::isfinite(sum) ? std::optional(sum) : std::nullopt;
}

/// Variance of the residuals about a minimum: 1 if errors are known, else from the scatter. Needs more residuals than
/// parameters.
inline double residual_variance(const Problem& problem, double least) {
  const auto freedom = static_cast<double>(problem.residual_count() - problem.parameters().size());
  return problem.known_errors() ? 1 : least / freedom;
}

/// A problem that changes the residuals of another, or adds some. The other must outlive it.
class WrappedProblem : public Problem {
 public:
  explicit WrappedProblem(const Problem& problem) : problem_(problem) {}
  std::size_t residual_count() const override { return problem_.residual_count(); }
  const std::vector<FreeParameter>& parameters() const override { return problem_.parameters(); }
  double data_norm() const override { return problem_.data_norm(); }
  bool known_errors() const override { return problem_.known_errors(); }
  std::vector<double> curvatures(std::span<const double> x) const override { return problem_.curvatures(x); }
  std::size_t scan_density(std::size_t searched) const override { return problem_.scan_density(searched); }

  bool evaluate(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const override {
    if (!problem_.evaluate(x, of_other(residuals), of_other(jacobian, x.size()))) return false;
    change(x, residuals, jacobian);
    return true;
  }
  bool evaluate_again(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian,
                      std::vector<double>& memory) const override {
    if (!problem_.evaluate_again(x, of_other(residuals), of_other(jacobian, x.size()), memory)) return false;
    change(x, residuals, jacobian);
    return true;
  }
  bool evaluate_roughly(std::span<const double> x, std::span<double> residuals) const override {
    if (!problem_.evaluate_roughly(x, of_other(residuals))) return false;
    change(x, residuals, {});
    return true;
  }

 protected:
  /// Changes the rows of the other problem, which come first, and fills the additional rows. The Jacobian may be empty.
  virtual void change(std::span<const double> /* x */, std::span<double> /* residuals */,
                      std::span<double> /* jacobian */) const {}
  /// The part of an array that the other problem fills.
  std::span<double> of_other(std::span<double> rows, std::size_t width = 1) const {
    return rows.empty() ? rows : rows.first(problem_.residual_count() * width);
  }

  const Problem& problem_;
};

/// Passes the memory of each evaluation to the next. Serves one thread and successive values close to each other.
class Remembering final : public WrappedProblem {
 public:
  using WrappedProblem::WrappedProblem;
  bool evaluate(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const override {
    ++evaluations_;
    return problem_.evaluate_again(x, residuals, jacobian, memory_);
  }
  bool evaluate_again(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian,
                      std::vector<double>& /* memory */) const override {
    return evaluate(x, residuals, jacobian);
  }

  /// Whether no evaluation has used the memory, so that the result does not depend on it.
  bool evaluated_once() const { return evaluations_ == 1; }

 private:
  mutable std::vector<double> memory_;
  mutable std::size_t evaluations_ = 0;
};

/// Rounding error of |r|, independent of the parameters: a few eps |data|.
inline double residual_rounding(const Problem& problem) {
  return 16 * std::numeric_limits<double>::epsilon() * problem.data_norm();
}

}  // namespace mixity
