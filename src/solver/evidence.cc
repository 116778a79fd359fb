#include "solver/evidence.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include "solver/interval.h"

namespace mixity {
namespace {

/// ln of the posterior density of parameter 0, but for a constant, in u: the parameter or its logarithm.
class LogDensity {
 public:
  LogDensity(const Problem& problem, const Minimum& best, const EvidenceOptions& choice, const SolverOptions& options)
      : problem_(problem), choice_(choice), profile_(problem, best, 1e-9, options) {
    const auto& parameters = problem.parameters();
    for (std::size_t k = 1; k < parameters.size(); ++k) {
      const double prior = parameters[k].prior, range = parameters[k].upper - parameters[k].lower;
      constant_ -= prior > 0 ? std::log(prior) : std::log(range) - 0.5 * std::log(2 * std::numbers::pi);
      n_ -= prior > 0;
    }
    n_ += static_cast<double>(problem.residual_count());
    const double low = lower(), high = upper();
    constant_ -= std::log(high - low);
    start_ = inner(best.x[0]);
  }

  bool logarithmic() const { return choice_.prior == RangePrior::log_uniform; }
  double inner(double x) const { return logarithmic() ? std::log(std::max(x, std::exp(lower()))) : x; }
  double outer(double u) const { return logarithmic() ? std::exp(u) : u; }
  double lower() const {
    const FreeParameter& parameter = problem_.parameters()[0];
    return logarithmic() ? std::log(kLeastOfUpper * parameter.upper) : parameter.lower;
  }
  double upper() const { return inner(problem_.parameters()[0].upper); }
  double start() const { return start_; }
  double constant() const { return constant_; }
  void begin() { profile_.begin(0); }

  /// Minus infinity where the cost is not finite.
  double operator()(double u) {
    const double none = -std::numeric_limits<double>::infinity();
    const double x = std::clamp(outer(u), problem_.parameters()[0].lower, problem_.parameters()[0].upper);
    const auto here = profile_(x);
    if (!here) return none;
    double of_priors = 0, log_determinant = 0;
    const std::size_t p = problem_.parameters().size();
    for (std::size_t k = 1; k < p; ++k)
      if (const FreeParameter& parameter = problem_.parameters()[k]; parameter.prior > 0)
        of_priors += std::pow((profile_.point()[k] - *parameter.start) / parameter.prior, 2);
    if (p > 1) {
      const auto others = static_cast<Eigen::Index>(p - 1);
      const Eigen::LLT<Eigen::MatrixXd> factors(profile_.cost().hessian.bottomRightCorner(others, others));
      if (factors.info() != Eigen::Success) return none;
      log_determinant = 2 * factors.matrixLLT().diagonal().array().log().sum();
    }
    if (choice_.unit == 0) return -0.5 * here->cost - 0.5 * log_determinant;
    // the average over the unit leaves S^(-n/2) of the data's sum of squares S
    const double squares = (here->cost - of_priors) * choice_.unit * choice_.unit;
    return squares > 0 ? -0.5 * n_ * std::log(squares) - 0.5 * of_priors - 0.5 * log_determinant : none;
  }

 private:
  const Problem& problem_;
  EvidenceOptions choice_;
  Profile profile_;
  double n_ = 0, constant_ = 0, start_ = 0;
};

/// A function on [low, high] through its values at Chebyshev's points, whose number doubles until they tell it.
class Interpolated {
 public:
  Interpolated(double low, double high, std::vector<double> values)
      : values_(std::move(values)) {
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const double angle = std::numbers::pi * static_cast<double>(i) / static_cast<double>(values_.size() - 1);
      nodes_.push_back(0.5 * (low + high) + 0.5 * (low - high) * std::cos(angle));
    }
  }

  double node(std::size_t i) const { return nodes_[i]; }
  /// The barycentric form (Berrut & Trefethen 2004).
  double operator()(double u) const {
    double above = 0, below = 0;
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const double off = u - nodes_[i];
      if (off == 0) return values_[i];
      const bool end = i == 0 || i + 1 == values_.size();
      const double weight = (i % 2 == 0 ? 1 : -1) * (end ? 0.5 : 1) / off;
      above += weight * values_[i];
      below += weight;
    }
    return above / below;
  }

 private:
  std::vector<double> nodes_, values_;
};

/// Integrals of e^(density - peak) times 1, x and x^2 from `low` to `u`.
struct Moments {
  double whole = 0, first = 0, second = 0;
};

/// One side of the peak, between two values of u.
class Side {
 public:
  /// False if as many points as are allowed do not tell the density.
  bool sample(LogDensity& density, double low, double high, double peak) {
    constexpr std::size_t kFewest = 9, kMost = 129;
    constexpr double kSettled = 3e-7;  // the last change is larger than what is left
    low_ = low;
    high_ = high;
    peak_ = peak;
    outer_ = [&density](double u) { return density.outer(u); };
    std::vector<double> values;
    double before = -1;
    for (std::size_t n = kFewest; n <= kMost; n = 2 * n - 1) {
      std::vector<double> more(n);
      const Interpolated nodes(low, high, more);
      for (std::size_t i = 0; i < n; ++i)
        more[i] = !values.empty() && i % 2 == 0 ? values[i / 2] : density(nodes.node(i)) - peak;
      if (!std::all_of(more.begin(), more.end(), [](double value) { return std::isfinite(value); })) return false;
      values = std::move(more);
      interpolated_.emplace(low, high, values);
      const double now = until(high).whole;
      if (std::abs(now - before) <= kSettled * now) return true;
      before = now;
    }
    return false;
  }

  Moments until(double u) const {
    Moments sum;
    constexpr int kPanels = 16;
    for (int i = 0; i < kPanels; ++i) {
      const double from = low_ + (u - low_) * i / kPanels, to = low_ + (u - low_) * (i + 1) / kPanels;
      const auto add = [&](double at, double weight) {
        const double x = outer_(at), value = weight * std::exp((*interpolated_)(at));
        sum.whole += value;
        sum.first += value * x;
        sum.second += value * x * x;
      };
      using Gauss = boost::math::quadrature::gauss<double, 10>;
      const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
      for (std::size_t k = 0; k < Gauss::abscissa().size(); ++k) {
        add(middle - half * Gauss::abscissa()[k], half * Gauss::weights()[k]);
        add(middle + half * Gauss::abscissa()[k], half * Gauss::weights()[k]);
      }
    }
    return sum;
  }
  double low() const { return low_; }
  double high() const { return high_; }

 private:
  double low_ = 0, high_ = 0, peak_ = 0;
  std::function<double(double)> outer_;
  std::optional<Interpolated> interpolated_;
};

/// Where the density has fallen to next to nothing, or the bound. Null if it is not finite before.
std::optional<double> reach(LogDensity& density, double bound, double step, double peak) {
  constexpr double kNothing = 32;  // e^-32 = 1e-14
  const double direction = bound < density.start() ? -1 : 1;
  density.begin();
  double far = step;
  for (int i = 0; i < 200; ++i, far *= 1.5) {
    const double u = density.start() + direction * far;
    if ((bound - u) * direction <= 0) return bound;
    const double here = density(u);
    if (!std::isfinite(here)) return std::nullopt;
    if (peak - here > kNothing) return u;
  }
  return bound;
}

}  // namespace

std::optional<Evidence> evidence(const Problem& problem, const Minimum& best, std::optional<double> standard_error,
                                 const EvidenceOptions& choice, const SolverOptions& options) {
  const FreeParameter& parameter = problem.parameters()[0];
  if (!std::isfinite(parameter.upper - parameter.lower)) return std::nullopt;
  LogDensity density(problem, best, choice, options);
  density.begin();
  const double peak = density(density.start());
  if (!std::isfinite(peak)) return std::nullopt;
  const double range = density.upper() - density.lower();
  double step = standard_error.value_or(0) * (density.logarithmic() ? 1 / std::max(best.x[0], 1e-300) : 1);
  if (!(step > 0 && step < 0.2 * range)) step = standard_error ? 0.2 * range : 1e-6 * range;
  std::vector<Side> sides;
  for (const double bound : {density.lower(), density.upper()}) {
    if (bound == density.start()) continue;
    const auto end = reach(density, bound, 5 * step, peak);
    density.begin();
    Side side;
    if (!end || !side.sample(density, std::min(*end, density.start()), std::max(*end, density.start()), peak))
      return std::nullopt;
    sides.push_back(std::move(side));
  }
  if (sides.empty()) return std::nullopt;
  Moments all;
  for (const Side& side : sides) {
    const Moments part = side.until(side.high());
    all.whole += part.whole;
    all.first += part.first;
    all.second += part.second;
  }
  const double mean = all.first / all.whole;
  const auto quantile = [&](double share) {
    double rest = share * all.whole;
    for (const Side& side : sides) {
      const double part = side.until(side.high()).whole;
      if (rest > part && &side != &sides.back()) {
        rest -= part;
        continue;
      }
      std::uintmax_t most = 100;
      const auto found = boost::math::tools::toms748_solve([&](double u) { return side.until(u).whole - rest; },
                                                           side.low(), side.high(), -rest, std::max(part - rest, 0.0),
                                                           boost::math::tools::eps_tolerance<double>(40), most);
      return density.outer(0.5 * (found.first + found.second));
    }
    return mean;
  };
  return Evidence{peak + std::log(all.whole) + density.constant(), mean,
                  std::sqrt(std::max(all.second / all.whole - mean * mean, 0.0)),
                  quantile(0.5 * (1 - choice.confidence)), quantile(0.5 * (1 + choice.confidence))};
}

}  // namespace mixity
