// How far the fitted parameters depend on the choice of points: bootstrap, jackknife, influence. Parameters are those a
// reader sees (FreeParameter::shown); weights are those of the fit, also where they depend on its parameters.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fitting/minimise.h"

namespace mixity {

/// Told how much is done, 0..1, from any thread.
using Progress = std::function<void(double)>;

enum class Resample { points, curves };

struct BootstrapOptions {
  std::size_t replicates = 0;
  Resample resample = Resample::points;  // points within their runs, or whole runs
  std::uint64_t seed = 1;
  unsigned threads = 0;  // 0: as many as the machine has
};

/// One parameter's bootstrap distribution: percentile interval, standard deviation, and bias of the estimate (mean of
/// the replicates minus the fit).
struct Bootstrapped {
  double low, high, standard_deviation, bias;
};

struct BootstrapResult {
  BootstrapOptions options;
  std::size_t failed = 0;                // replicates without a minimum, left out
  std::vector<Bootstrapped> parameters;  // empty if fewer than half of the replicates have one
};

/// Refits of resampled points, each from the fit itself. `runs[i]` is the run of point i. Every replicate has a random
/// stream of its own, so that the result does not depend on the number of threads.
BootstrapResult bootstrap(const LeastSquares& problem, const std::vector<double>& fitted,
                          const std::vector<std::size_t>& runs, const BootstrapOptions& options, double confidence,
                          const Progress& progress = {});

/// How much one point, or one whole run, moves the fit.
struct PointInfluence {
  double leverage;             // diagonal of J (J'J)^-1 J', 0..1
  double cooks_distance;       // r^2 h/(p s^2 (1 - h)^2)
  std::vector<double> change;  // of each parameter when the point is left out and the rest refitted; empty if that
                               // fit fails
};
struct Influence {
  std::vector<PointInfluence> points;
  std::vector<std::vector<double>> runs;  // change of each parameter when the run is left out; empty: that fit fails
};
Influence influence(const LeastSquares& problem, const std::vector<double>& fitted,
                    const std::vector<std::size_t>& runs, unsigned threads, const Progress& progress = {});

}  // namespace mixity
