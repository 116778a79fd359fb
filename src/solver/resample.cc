#include "solver/resample.h"

#include <algorithm>
#include <atomic>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/taus88.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <random>

#include "base/threads.h"
#include "solver/kernel.h"
#include "solver/linear_algebra.h"
#include "solver/run_errors.h"

namespace mixity {
namespace {

/// A problem with shifts added to its last residuals, those of priors: the stated values as another laboratory would
/// have them.
class Redrawn final : public WrappedProblem {
 public:
  Redrawn(const Problem& problem, std::size_t priors) : WrappedProblem(problem), shifts(priors) {}
  std::unique_ptr<Cost> cost() const override { return shifts.empty() ? problem_.cost() : Problem::cost(); }

  std::vector<double> shifts;

 private:
  void change(std::span<const double>, std::span<double> residuals, std::span<double>) const override {
    const auto priors = residuals.last(shifts.size());
    for (std::size_t i = 0; i < shifts.size(); ++i) priors[i] += shifts[i];
  }
};

/// Refits from one start, one object per thread. `points`: number of residuals of data; the others are of priors.
class Refitter {
 public:
  Refitter(const Problem& problem, const std::vector<double>& start, std::size_t points)
      : problem_(problem, problem.residual_count() - points), start_(start), kernel_(problem_) {
    kernel_.keep(start_);
  }
  /// Shifts of the residuals of priors: normal with variance 1.
  std::vector<double>& shifts() { return problem_.shifts; }
  /// Empty if no minimum was found.
  std::vector<double> operator()(std::span<const double> weights) {
    const auto points = std::count_if(weights.begin(), weights.end(), [](double w) { return w > 0; });
    if (static_cast<std::size_t>(points) <= start_.size()) return {};
    kernel_.restore();  // so that a refit does not depend on earlier ones on this thread
    const auto minimum = kernel_.descend(start_, weights);
    return minimum && minimum->stationary ? minimum->x : std::vector<double>{};
  }

 private:
  Redrawn problem_;
  const std::vector<double>& start_;
  Kernel kernel_;
};

/// Calls body(i, refitter, weights) for i < n on several threads, each with its own refitter and weights.
template <class Body>
void for_each_refit(const Problem& problem, const std::vector<double>& fitted, std::size_t points, std::size_t n,
                    unsigned threads, const Progress& progress, Body body) {
  constexpr std::size_t kShare = 16;  // number taken at a time
  std::atomic<std::size_t> taken = 0, done = 0;
  const auto work = [&] {
    Refitter refit(problem, fitted, points);
    std::vector<double> weights(problem.residual_count());
    for (std::size_t first; (first = taken.fetch_add(kShare)) < n;) {
      const std::size_t last = std::min(first + kShare, n);
      for (std::size_t i = first; i < last; ++i) body(i, refit, weights);
      done += last - first;
      if (progress) progress(static_cast<double>(done) / static_cast<double>(n));
    }
  };
  run_on_threads(std::min(threads > 0 ? threads : processors(), (n + kShare - 1) / kShare), work);
}

std::vector<std::vector<std::size_t>> members(const std::vector<std::size_t>& runs) {
  std::vector<std::vector<std::size_t>> list;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs[i] >= list.size()) list.resize(runs[i] + 1);
    list[runs[i]].push_back(i);
  }
  std::erase_if(list, [](const auto& run) { return run.empty(); });
  return list;
}

std::uint32_t low_word(std::uint64_t x) { return static_cast<std::uint32_t>(x); }
std::uint32_t high_word(std::uint64_t x) { return static_cast<std::uint32_t>(x >> 32); }

/// Linear interpolation between order statistics (the common type 7).
double quantile_of(const std::vector<double>& sorted, double q) {
  const double rank = q * static_cast<double>(sorted.size() - 1), below = std::floor(rank);
  const auto i = static_cast<std::size_t>(below);
  return i + 1 < sorted.size() ? sorted[i] + (rank - below) * (sorted[i + 1] - sorted[i]) : sorted[i];
}

}  // namespace

BootstrapResult bootstrap(const Problem& problem, const std::vector<double>& fitted,
                          const std::vector<std::size_t>& runs, const BootstrapOptions& options, double confidence,
                          const Progress& progress) {
  // Fewer runs do not determine their own error for so many parameters.
  const std::size_t fewest = 2 * fitted.size() + 2;
  const auto groups = members(runs);
  const auto points = static_cast<std::ptrdiff_t>(runs.size());  // the other residuals are of priors
  const bool studentised = options.resample == Resample::curves && groups.size() >= fewest;
  std::optional<RunErrors> errors;
  if (studentised) errors.emplace(problem, fitted, groups);
  const std::vector<double> error =
      errors ? (*errors)(std::vector<double>(groups.size(), 1), std::vector<double>(fitted.size()))
             : std::vector<double>();
  std::vector<std::vector<double>> replicates(options.replicates), ratios(options.replicates);
  const auto draw = [&](std::size_t replicate, std::vector<double>& weights, std::vector<double>& shifts) {
    // Three state words, so that seeding one stream per replicate is cheap.
    const auto words = {low_word(options.seed), high_word(options.seed), low_word(replicate), high_word(replicate)};
    std::seed_seq seed(words);
    boost::random::taus88 random(seed);
    std::fill(weights.begin(), weights.begin() + points, 0.0);
    std::fill(weights.begin() + points, weights.end(), 1.0);
    const auto pick = [&](std::size_t n) {
      return boost::random::uniform_int_distribution<std::uint32_t>(0, low_word(n - 1))(random);
    };
    for (const auto& group : groups) {
      if (options.resample == Resample::points)
        for (std::size_t i = 0; i < group.size(); ++i) weights[group[pick(group.size())]] += 1;
      else
        for (const std::size_t i : groups[pick(groups.size())]) weights[i] += 1;
    }
    for (double& shift : shifts) shift = boost::random::normal_distribution<double>()(random);
  };
  for_each_refit(problem, fitted, runs.size(), options.replicates, options.threads, progress,
                 [&](std::size_t i, Refitter& refit, std::vector<double>& weights) {
                   draw(i, weights, refit.shifts());
                   replicates[i] = refit(weights);
                   if (!errors || replicates[i].empty()) return;
                   std::vector<double> drawn, change;
                   for (const auto& group : groups) drawn.push_back(weights[group.front()]);
                   for (std::size_t k = 0; k < fitted.size(); ++k) change.push_back(replicates[i][k] - fitted[k]);
                   ratios[i] = (*errors)(drawn, change);
                   for (std::size_t k = 0; k < ratios[i].size(); ++k) ratios[i][k] = change[k] / ratios[i][k];
                 });

  BootstrapResult result{options.replicates, options.seed, options.resample == Resample::curves, 0, {}};
  std::erase_if(replicates, [](const auto& x) { return x.empty(); });
  std::erase_if(ratios, [](const auto& x) { return x.empty(); });
  result.failed = options.replicates - replicates.size();
  if (2 * replicates.size() < options.replicates || replicates.size() < 2) return result;
  for (std::size_t k = 0; k < fitted.size(); ++k) {
    const FreeParameter& parameter = problem.parameters()[k];
    std::vector<double> values;
    values.reserve(replicates.size());
    for (const auto& x : replicates) values.push_back(parameter.shown(x[k]));
    std::sort(values.begin(), values.end());
    const auto n = static_cast<double>(values.size());
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
    double square = 0;
    for (const double value : values) square += (value - mean) * (value - mean);
    result.parameters.push_back({quantile_of(values, 0.5 * (1 - confidence)),
                                 quantile_of(values, 0.5 * (1 + confidence)), std::sqrt(square / (n - 1)),
                                 mean - parameter.shown(fitted[k])});
    const bool reaches_bound =
        std::any_of(replicates.begin(), replicates.end(), [&](const auto& x) { return parameter.at_bound(x[k]); });
    if (reaches_bound || parameter.at_bound(fitted[k])) continue;  // it changes to one side only
    if (error.empty() || 2 * ratios.size() < options.replicates) continue;
    std::vector<double> sorted;
    for (const auto& one : ratios)
      if (std::isfinite(one[k])) sorted.push_back(one[k]);
    if (2 * sorted.size() < options.replicates) continue;
    std::sort(sorted.begin(), sorted.end());
    const auto end = [&](double q) {
      return parameter.shown(
          std::clamp(fitted[k] - quantile_of(sorted, q) * error[k], parameter.lower, parameter.upper));
    };
    result.parameters.back().low = end(0.5 * (1 + confidence));
    result.parameters.back().high = end(0.5 * (1 - confidence));
  }
  return result;
}

Influence influence(const Problem& problem, const std::vector<double>& fitted, const std::vector<std::size_t>& runs,
                    unsigned threads, const Progress& progress) {
  const std::size_t n = runs.size(), rows = problem.residual_count(), p = fitted.size();
  Influence result;
  std::vector<double> residuals(rows), jacobian(rows * p);
  if (rows <= p || p == 0 || !problem.evaluate(fitted, residuals, jacobian)) return result;
  const Eigen::VectorXd leverage = leverages(as_matrix(jacobian, p));
  const double squares = std::inner_product(residuals.begin(), residuals.end(), residuals.begin(), 0.0);
  const double variance = squares / static_cast<double>(rows - p);
  const auto groups = members(runs);
  result.points.resize(n);
  result.runs.resize(groups.size());
  const auto change_without = [&](const std::vector<std::size_t>& left_out, Refitter& refit,
                                  std::vector<double>& weights) {
    std::fill(weights.begin(), weights.end(), 1.0);
    for (const std::size_t i : left_out) weights[i] = 0;
    std::vector<double> change = refit(weights);
    for (std::size_t k = 0; k < change.size(); ++k) {
      const FreeParameter& parameter = problem.parameters()[k];
      change[k] = parameter.shown(change[k]) - parameter.shown(fitted[k]);
    }
    return change;
  };
  for_each_refit(
      problem, fitted, n, n + groups.size(), threads, progress,
      [&](std::size_t i, Refitter& refit, std::vector<double>& weights) {
        if (i >= n) {
          result.runs[i - n] = change_without(groups[i - n], refit, weights);
          return;
        }
        const double h = leverage[static_cast<Eigen::Index>(i)], rest = std::max(1 - h, 1e-12);
        const double r = residuals[i], expected = static_cast<double>(p) * variance * rest * rest;
        result.points[i] = {h, variance > 0 ? r * r * h / expected : 0.0, change_without({i}, refit, weights)};
      });
  return result;
}

}  // namespace mixity
