// A least-squares problem: residuals and their Jacobian in bounded parameters, whatever they come from.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
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
  // Null: any value in the range is as likely, and all of it is searched. Else where the fit starts, and the range is
  // only wide: its ends are no physical bounds.
  std::optional<double> start{};
  // What a reader sees is scale exp(x) if logarithmic, else scale x.
  double scale = 1;
  bool logarithmic = false;
  std::string unit{};
  double prior = 0;    // standard error of what is known beforehand, about `start`; 0: nothing is
  double neutral = 0;  // > 0: a value in the neighbourhood of which only the distance from it matters

  double width() const { return upper - lower; }
  /// The least size of x that matters beside its range; next to nothing where that is infinite.
  double least_size() const { return std::isfinite(width()) ? 1e-9 * width() : 1e-100; }
  double shown(double x) const { return scale * (logarithmic ? std::exp(x) : x); }
  /// x of what a reader sees.
  double solver_value(double shown) const { return logarithmic ? std::log(shown / scale) : shown / scale; }
  /// d shown/dx
  double shown_slope(double x) const { return logarithmic ? shown(x) : scale; }
};

/// S = sum w_i r_i^2. Gradient and Hessian are those of S/2.
struct CostValue {
  double value = 0;
  Eigen::VectorXd gradient;    // J'W r
  Eigen::MatrixXd hessian;     // J'W J, and sum w r r'' where the curvature is exact
  Eigen::VectorXd slope_size;  // |J_k| of each column, for the scale-free test of the gradient
  bool finite = false;
};

/// Not shared between threads: it owns its scratch arrays.
class Cost {
 public:
  virtual ~Cost() = default;
  /// False if the Hessian is Gauss-Newton's, without r r''.
  virtual bool exact_curvature() const { return false; }
  /// Weights: one per residual, or empty: 1. Fills `cost`, whose memory is used again.
  virtual void at(std::span<const double> x, std::span<const double> weights, CostValue& cost) = 0;
  /// What it has learnt on the way to where it is serves from here on as if it had just been learnt.
  virtual void keep() {}
  /// Forgets what it has learnt since keep(): results do not depend on what was asked before.
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
  /// The same, faster where a problem keeps in `memory` what served at the last parameters, if these are near. The
  /// result is that of evaluate() to rounding. `memory` is empty at first, and nobody else's.
  virtual bool evaluate_again(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian,
                              std::vector<double>& /* memory */) const {
    return evaluate(x, residuals, jacobian);
  }
  /// For the search of starts: residuals that cost less and are right to a factor of two or so. Those of some points
  /// may be left out (0), always the same.
  virtual bool evaluate_roughly(std::span<const double> x, std::span<double> residuals) const {
    return evaluate(x, residuals, {});
  }
  /// Size of the data the residuals are differences of, sqrt(sum of squares): sets what rounding can do to them.
  virtual double data_norm() const = 0;
  /// True if the residuals are in units of known standard errors: what counts as a better fit is then measured by
  /// chi^2, otherwise by the scatter.
  virtual bool known_errors() const { return false; }
  /// Curvature of half the cost along each residual, which a robust loss bends; empty: 1, least squares.
  virtual std::vector<double> curvatures(std::span<const double>) const { return {}; }
  /// Values that a search over so many parameters looks at for each, spaced evenly and as many by factors.
  virtual std::size_t scan_density(std::size_t searched) const { return searched == 1 ? 64 : searched == 2 ? 16 : 8; }
  /// The cost for the kernel (kernel.h), which the problem must outlive.
  virtual std::unique_ptr<Cost> cost() const;
};

/// Sum of squares at x; fills residuals [n]. Null if it is not finite.
inline std::optional<double> sum_of_squares(const Problem& problem, std::span<const double> x,
                                            std::span<double> residuals) {
  if (!problem.evaluate(x, residuals, {})) return std::nullopt;
  double sum = 0;
  for (const double r : residuals) sum += r * r;
  return std::isfinite(sum) ? std::optional(sum) : std::nullopt;
}

/// A problem that changes another, which must outlive it, in some respect.
class WrappedProblem : public Problem {
 public:
  explicit WrappedProblem(const Problem& problem) : problem_(problem) {}
  std::size_t residual_count() const override { return problem_.residual_count(); }
  const std::vector<FreeParameter>& parameters() const override { return problem_.parameters(); }
  double data_norm() const override { return problem_.data_norm(); }
  bool known_errors() const override { return problem_.known_errors(); }

 protected:
  const Problem& problem_;
};

/// Each evaluation has the memory of the last: of one thread, where values follow each other closely.
class Remembering final : public WrappedProblem {
 public:
  using WrappedProblem::WrappedProblem;
  bool evaluate(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const override {
    return problem_.evaluate_again(x, residuals, jacobian, memory_);
  }
  bool evaluate_again(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian,
                      std::vector<double>& /*another's*/) const override {
    return evaluate(x, residuals, jacobian);
  }
  bool evaluate_roughly(std::span<const double> x, std::span<double> residuals) const override {
    return problem_.evaluate_roughly(x, residuals);
  }
  std::vector<double> curvatures(std::span<const double> x) const override { return problem_.curvatures(x); }
  std::size_t scan_density(std::size_t searched) const override { return problem_.scan_density(searched); }

 private:
  mutable std::vector<double> memory_;
};

/// What rounding of model and data puts into |r|, whatever the parameters: some eps |data|.
inline double residual_rounding(const Problem& problem) {
  return 16 * std::numeric_limits<double>::epsilon() * problem.data_norm();
}

}  // namespace mixity
