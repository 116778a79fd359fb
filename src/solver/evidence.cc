#include "solver/evidence.h"

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <tuple>
#include <type_traits>
#include <vector>

#include "solver/interval.h"
#include "solver/linear_algebra.h"

namespace mixity {
namespace {

/// ln of the posterior density of parameter 0, up to a constant, as a function of u: the parameter or its logarithm.
class LogDensity {
 public:
  LogDensity(const Problem& problem, const Minimum& best, const EvidenceOptions& choice, const SolverOptions& options)
      : problem_(problem), choice_(choice), profile_(problem, best, 1e-9, options) {
    const auto& parameters = problem.parameters();
    for (std::size_t k = 1; k < parameters.size(); ++k) {
      const double prior = parameters[k].prior;
      constant_ -= prior > 0 ? std::log(prior) : std::log(parameters[k].width()) - 0.5 * std::log(2 * std::numbers::pi);
      n_ -= prior > 0;
    }
    n_ += static_cast<double>(problem.residual_count());
    constant_ -= std::log(upper() - lower());
    start_ = inner(best.x[0]);
  }

  bool logarithmic() const { return choice_.prior == RangePrior::log_uniform; }
  double inner(double x) const { return logarithmic() ? std::log(std::max(x, std::exp(lower()))) : x; }
  double outer(double u) const { return logarithmic() ? std::exp(u) : u; }
  double lower() const {
    const FreeParameter& parameter = problem_.parameters()[0];
    return logarithmic() ? std::log(choice_.from > 0 ? choice_.from : kLeastOfUpper * parameter.upper)
                         : parameter.lower;
  }
  double upper() const { return inner(problem_.parameters()[0].upper); }
  double start() const { return start_; }
  double constant() const { return constant_; }
  /// With an unknown unit the density is a power of a sum of squares, which is easier to interpolate than its
  /// logarithm. `below`: the logarithm of the density relative to the peak.
  double smooth(double below) const { return power() > 0 ? std::exp(-below / power()) : below; }
  /// Its derivative, given that of the logarithm.
  double smooth_slope(double smooth, double slope) const { return power() > 0 ? -smooth / power() * slope : slope; }
  double below(double smooth) const { return power() > 0 ? -power() * std::log(smooth) : smooth; }
  /// Standard errors from the peak where a density without curvature of its own has fallen by e^-fall.
  double distance_of(double fall) const {
    return power() > 0 ? std::sqrt(2 * power() * std::expm1(fall / power())) : std::sqrt(2 * fall);
  }
  /// The error of `below` per error of `smooth` near the peak.
  double error_of(double smooth) const { return power() > 0 ? power() * smooth : smooth; }
  void begin() { profile_.begin(0); }
  /// The density at the start, where begin() leads; it is known if that is the minimum.
  double at_start(const Minimum& best) {
    return !logarithmic() || start_ > lower() ? of_cost(best.sum_of_squares) : (*this)(start_).density;
  }

  /// A value of the density, with its slope where there is a single parameter. Minus infinity where the cost is not
  /// finite.
  struct Value {
    double u, density, slope = 0;
  };
  bool has_slopes() const { return problem_.parameters().size() == 1; }
  Value operator()(double u) {
    const double none = -std::numeric_limits<double>::infinity();
    constexpr int kMostUnsettled = 5;  // values, each after hundreds of steps: such a density cannot be integrated
    if (unsettled_ > kMostUnsettled) return {u, none};
    const double x = problem_.parameters()[0].clamped(outer(u));
    const auto here = profile_(x);
    if (!here) return {u, none};
    unsettled_ += !here->settled;
    const double density = of_cost(here->cost);
    if (!has_slopes()) return {u, density};
    const double per_cost = -0.5 * (choice_.unit == 0 ? 1 : n_ / here->cost);
    return {u, density, per_cost * here->slope * (logarithmic() ? x : 1)};
  }

 private:
  double power() const { return choice_.unit == 0 ? 0 : 0.5 * n_; }

  /// The density at the profile's present point.
  double of_cost(double cost) const {
    const double none = -std::numeric_limits<double>::infinity();
    double of_priors = 0, of_others = 0;
    const std::size_t p = problem_.parameters().size();
    for (std::size_t k = 1; k < p; ++k)
      if (const FreeParameter& parameter = problem_.parameters()[k]; parameter.prior > 0)
        of_priors += std::pow((profile_.point()[k] - *parameter.start) / parameter.prior, 2);
    if (p > 1) {
      const auto others = static_cast<Eigen::Index>(p - 1);
      const auto found = log_determinant(profile_.cost().hessian.bottomRightCorner(others, others));
      if (!found) return none;
      of_others = *found;
    }
    if (choice_.unit == 0) return -0.5 * cost - 0.5 * of_others;
    // averaging over the unit leaves S^(-n/2), where S is the data's sum of squares
    const double squares = (cost - of_priors) * choice_.unit * choice_.unit;
    return squares > 0 ? -0.5 * n_ * std::log(squares) - 0.5 * of_priors - 0.5 * of_others : none;
  }

  const Problem& problem_;
  EvidenceOptions choice_;
  Profile profile_;
  double n_ = 0, constant_ = 0, start_ = 0;
  int unsettled_ = 0;
};

/// A function on [low, high] interpolated at Chebyshev points.
class Interpolated {
 public:
  Interpolated(double low, double high, std::size_t points) : values_(points) {
    for (std::size_t i = 0; i < points; ++i) {
      nodes_.push_back(0.5 * (low + high) + 0.5 * (low - high) * std::cos(angle(i)));
      weights_.push_back((i % 2 == 0 ? 1 : -1) * (i == 0 || i + 1 == points ? 0.5 : 1));
    }
  }
  /// The polynomial that has these values and these slopes, too (Hermite). It has twice as many nodes.
  Interpolated(const Interpolated& values, const std::vector<double>& slopes)
      : Interpolated(values.nodes_.front(), values.nodes_.back(), 2 * values.size()) {
    const std::vector<double>& nodes = values.nodes_;
    std::vector<double> basis_slopes(nodes.size());  // of each of Lagrange's polynomials at its own node
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (std::size_t j = 0; j < nodes.size(); ++j)
        if (j != i) basis_slopes[i] -= values.weights_[j] / values.weights_[i] / (nodes[i] - nodes[j]);
    values_.front() = values.values_.front();
    values_.back() = values.values_.back();
    for (std::size_t k = 1; k + 1 < values_.size(); ++k) {  // only the ends coincide with nodes of the values
      double sum = 0, below = 0;
      for (std::size_t i = 0; i < nodes.size(); ++i) below += values.weights_[i] / (nodes_[k] - nodes[i]);
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        const double off = nodes_[k] - nodes[i], basis = values.weights_[i] / off / below;
        sum += basis * basis * ((1 - 2 * basis_slopes[i] * off) * values.values_[i] + off * slopes[i]);
      }
      values_[k] = sum;
    }
  }

  std::size_t size() const { return nodes_.size(); }
  double node(std::size_t i) const { return nodes_[i]; }
  double& value(std::size_t i) { return values_[i]; }
  /// Barycentric interpolation (Berrut & Trefethen 2004) at several points at once.
  template <std::size_t kPoints>
  std::array<double, kPoints> operator()(const std::array<double, kPoints>& u) const {
    std::array<double, kPoints> above{}, below{};
    for (std::size_t i = 0; i < values_.size(); ++i)
      for (std::size_t j = 0; j < kPoints; ++j) {
        const double share = weights_[i] / (u[j] - nodes_[i]);
        above[j] += share * values_[i];
        below[j] += share;
      }
    for (std::size_t j = 0; j < kPoints; ++j) {
      const auto node = std::isfinite(below[j]) ? nodes_.end() : std::find(nodes_.begin(), nodes_.end(), u[j]);
      above[j] = node == nodes_.end() ? above[j] / below[j] : values_[static_cast<std::size_t>(node - nodes_.begin())];
    }
    return above;
  }
  /// The larger of two neighbouring Chebyshev coefficients, the last ones but `before`. The last two bound the error
  /// of a smooth function; what is left out is smaller by the ratio of neighbouring pairs.
  double tail(std::size_t before = 0) const {
    const std::size_t last = values_.size() - 1;
    double largest = 0;
    for (const std::size_t k : {last - 1 - before, last - before}) {
      double sum = 0;
      for (std::size_t i = 0; i <= last; ++i)
        sum += (i == 0 || i == last ? 0.5 : 1) * values_[i] * std::cos(angle(i) * static_cast<double>(k));
      largest = std::max(largest, std::abs(sum) * (k == last ? 1 : 2) / static_cast<double>(last));
    }
    return largest;
  }

 private:
  double angle(std::size_t i) const {
    return std::numbers::pi * static_cast<double>(i) / static_cast<double>(values_.size() - 1);
  }

  std::vector<double> nodes_, weights_, values_;
};

/// Integrals of e^(density - peak) multiplied by 1, x and x^2.
using Moments = Eigen::Array3d;

/// The density over the range where it is not negligible.
class Posterior {
 public:
  Posterior(const LogDensity& density, double peak) : density_(density), peak_(peak) {}

  /// Interpolates the logarithm of the density between two of its values. False if the largest number of points does
  /// not suffice. `width`: of the peak, if known.
  bool sample(LogDensity& density, LogDensity::Value low, LogDensity::Value high, std::optional<double> width) {
    // Values with slopes determine a polynomial of twice the degree.
    const std::size_t each = density.has_slopes() ? 2 : 1, fewest = 8 / each + 1, doubtful = 64 / each + 1,
                      most = 256 / each + 1;
    constexpr double kLeftOut = 5e-7;  // error of the logarithm: relative error of the density
    constexpr double kSteep = 3e-5;    // where their fall is believed: a kink would leave coefficients of its size
    constexpr double kScatter = 1e-5;
    // Of a density with a kink: coefficients of this size leave out up to 1e-3. Each doubling takes a half at least.
    const double enough = density.has_slopes() ? 5e-5 : 1e-3, within_reach = 16 * enough;
    // Without scatter the density may be as narrow as the rounding of its parameter.
    const double resolved = 1e4 * std::numeric_limits<double>::epsilon() * std::max(std::abs(low.u), std::abs(high.u));
    if (!(high.u - low.u > resolved)) return false;
    std::vector<LogDensity::Value> values{low, high};
    std::optional<Interpolated> before;
    for (std::size_t n = fewest; n <= most; n = 2 * n - 1) {
      Interpolated points(low.u, high.u, n);
      values = with_more(std::move(values), points, density);
      std::vector<double> slopes;
      for (std::size_t i = 0; i < n; ++i) {
        points.value(i) = density.smooth(values[i].density - peak_);
        slopes.push_back(density.smooth_slope(points.value(i), values[i].slope));
        if (!std::isfinite(points.value(i)) || !std::isfinite(slopes.back())) return false;
      }
      Interpolated now = density.has_slopes() ? Interpolated(points, slopes) : std::move(points);
      const double error = density.error_of(now.tail()), error_before = before ? density.error_of(before->tail()) : 0;
      // Coefficients that fall steeply leave out what follows in proportion.
      const double falls = error / std::max(error, density.error_of(now.tail(2)));
      const bool first = !before || before->size() == each * fewest;
      before = std::move(now);
      if (error <= kSteep && falls * error <= kLeftOut) break;
      // Values that are themselves only known to this are not interpolated better by more of them.
      if (error <= kLeftOut || (error_before <= kScatter && error > 0.2 * error_before && !first)) break;
      // For a smooth density the error is squared each time. With kinks, as where a point's nearest place comes to an
      // end of the law's curve, it falls by a factor, which will not do in time: what is enough for three digits is
      // taken.
      const double factor = error / error_before, at_most = error * std::pow(factor, std::log2((most - 1) / (n - 1)));
      if (n >= doubtful && at_most > kLeftOut && error <= enough) break;
      if (n == most || (n >= doubtful && error > 0.2 * error_before && error > within_reach)) return false;
    }
    interpolated_ = std::move(before);
    // for ends one peak width apart, ten points are exact
    const int panels = static_cast<int>(std::clamp(width ? std::ceil((high.u - low.u) / *width) : 64, 16.0, 1000.0));
    for (int i = 0; i <= panels; ++i) {
      ends_.push_back(low.u + (high.u - low.u) * i / panels);
      if (i > 0) parts_.push_back(between(ends_[ends_.size() - 2], ends_.back()));
    }
    return true;
  }

  Moments all() const {
    return std::accumulate(parts_.begin(), parts_.end(), Moments(Moments::Zero()),
                           [](const Moments& sum, const Moments& part) -> Moments { return sum + part; });
  }

  /// The u below which the integral of the density is `rest`.
  double quantile(double rest) const {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const double part = parts_[i][0];
      if (rest > part && i + 1 < parts_.size()) {
        rest -= part;
        continue;
      }
      std::uintmax_t most = 100;
      const auto found = boost::math::tools::toms748_solve([&](double u) { return between(ends_[i], u)[0] - rest; },
                                                           ends_[i], ends_[i + 1], -rest, std::max(part - rest, 0.0),
                                                           boost::math::tools::eps_tolerance<double>(40), most);
      return 0.5 * (found.first + found.second);
    }
    return ends_.back();
  }

 private:
  /// The values at all of these points; known are those at the ends, or at every other point.
  static std::vector<LogDensity::Value> with_more(std::vector<LogDensity::Value> known, const Interpolated& points,
                                                  LogDensity& density) {
    const std::size_t n = points.size(), step = (n - 1) / (known.size() - 1);
    std::vector<LogDensity::Value> all;
    density.begin();
    for (std::size_t i = 0; i < n; ++i) all.push_back(i % step == 0 ? known[i / step] : density(points.node(i)));
    return all;
  }

  Moments between(double low, double high) const {
    using Gauss = boost::math::quadrature::gauss<double, 10>;
    constexpr std::size_t kHalf = std::tuple_size_v<std::remove_cvref_t<decltype(Gauss::abscissa())>>;
    Moments sum = Moments::Zero();
    const double middle = 0.5 * (low + high), half = 0.5 * (high - low);
    std::array<double, 2 * kHalf> u;
    for (std::size_t k = 0; k < kHalf; ++k) {
      u[k] = middle - half * Gauss::abscissa()[k];
      u[kHalf + k] = middle + half * Gauss::abscissa()[k];
    }
    const auto smooth = (*interpolated_)(u);
    for (std::size_t k = 0; k < u.size(); ++k) {
      const double x = density_.outer(u[k]),
                   value = half * Gauss::weights()[k % kHalf] * std::exp(density_.below(smooth[k]));
      sum += Moments(value, value * x, value * x * x);
    }
    return sum;
  }

  const LogDensity& density_;
  double peak_;
  std::optional<Interpolated> interpolated_;
  std::vector<double> ends_;    // of the panels
  std::vector<Moments> parts_;  // of each panel
};

/// The density's fall, in its logarithm, at which it is negligible: beyond lie 4e-12 of a normal density.
constexpr double kNothing = 24;
/// A fall that leaves 8e-6, for a density that is smooth no farther: where points of exact shear leave the curve.
constexpr double kLittle = 10;

/// The place where the density has fallen by `fall`, or the bound. Null if it becomes infinite before.
std::optional<LogDensity::Value> reach(LogDensity& density, double bound, double step, double peak, double fall) {
  const double direction = bound < density.start() ? -1 : 1;
  density.begin();
  double far = step;
  for (int i = 0; i < 200; ++i) {
    const double beyond = density.start() + direction * far, u = (bound - beyond) * direction <= 0 ? bound : beyond;
    const LogDensity::Value here = density(u);
    if (!std::isfinite(here.density)) return std::nullopt;
    const double fallen = peak - here.density;
    if (fallen > fall || u == bound) return here;
    far *= std::clamp(1.05 * std::sqrt(fall / std::max(fallen, 0.0)), 1.05, 1.5);  // a parabola's way
  }
  return std::nullopt;
}

}  // namespace

std::optional<Evidence> evidence(const Problem& problem, const Minimum& best, std::optional<double> standard_error,
                                 const EvidenceOptions& choice, const SolverOptions& options) {
  const FreeParameter& parameter = problem.parameters()[0];
  if (!std::isfinite(parameter.width())) return std::nullopt;
  LogDensity density(problem, best, choice, options);
  if (!(density.lower() < density.upper())) return std::nullopt;
  density.begin();
  const double peak = density.at_start(best);
  if (!std::isfinite(peak)) return std::nullopt;
  const double range = density.upper() - density.lower();
  const double width = standard_error.value_or(0) * (density.logarithmic() ? 1 / std::max(best.x[0], 1e-300) : 1);
  std::optional<Posterior> found;
  for (const double fall : {kNothing, kLittle}) {
    const double far_off = 1.02 * density.distance_of(fall);  // standard errors; a little beyond, for curvature
    double step = far_off * width;
    if (!(step > 0 && step < range)) step = standard_error ? range : 1e-6 * range;
    const auto end = [&](double bound) {
      return bound == density.start() ? std::optional(density(bound)) : reach(density, bound, step, peak, fall);
    };
    const auto low = end(density.lower()), high = end(density.upper());
    found.emplace(density, peak);
    if (low && high && low->u < high->u &&
        found->sample(density, *low, *high, width > 0 ? std::optional(width) : std::nullopt))
      break;
    found.reset();
  }
  if (!found) return std::nullopt;
  const Posterior& posterior = *found;
  const Moments all = posterior.all();
  const double mean = all[1] / all[0];
  const auto quantile = [&](double share) { return density.outer(posterior.quantile(share * all[0])); };
  return Evidence{peak + std::log(all[0]) + density.constant(), mean,
                  std::sqrt(std::max(all[2] / all[0] - mean * mean, 0.0)), quantile(0.5 * (1 - choice.confidence)),
                  quantile(0.5 * (1 + choice.confidence))};
}

}  // namespace mixity
