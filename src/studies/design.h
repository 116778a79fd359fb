// Expected results of a plan, and the best loads for it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fitting/options.h"
#include "studies/simulate.h"

namespace mixity {

enum class Goal { error, model };  // the smallest error of the parameter; the largest minimum of the rivals' chi^2

/// The expected results of a plan.
struct Expectation {
  /// Expected standard error of the model's first parameter, from the Fisher information of all points and the priors
  /// of the constants (as nuisance constants: Ds-optimality, Silvey 1980): that of a fit to the plan without noise.
  /// Null if the plan does not determine it.
  std::optional<double> standard_error;
  /// The same of the model's other free parameters, lambda_III of an ellipse, eta of bk, and of drifts that may be.
  struct Other {
    std::string parameter;
    double value;
    std::optional<double> standard_error;
  };
  std::vector<Other> others;
  /// chi^2 of each rival's best fit to the plan without noise: the T-criterion of Atkinson & Fedorov 1975 (Biometrika
  /// 62, 57). Twice the expected logarithm of the odds against it, without the penalty for free parameters.
  struct Rival {
    std::string model;
    double chi2;
    double odds() const;  // exp(chi2/2), infinite where that is no double
  };
  std::vector<Rival> rivals;
  /// Infinite without rivals.
  double least_chi2() const;
  /// The quantity to minimise: the standard error (infinite if there is none), or minus the least chi^2.
  double cost(Goal goal) const;
};

/// `rivals`: keys of models; ignored are the plan's own and, for an ellipse, its circle, which is no model of axes.
/// Throws as simulate does.
Expectation expect(const Plan& plan, const std::vector<std::string>& rivals);

/// Runs of one load up to a share of its jump, of a plan of elliptic contacts.
struct CouplingRuns {
  double load, reach;  // [N]; share
  double chi2;         // per run, of the best fit with equal couplings
  /// How many runs take these odds against equal couplings; infinite where they are equal. chi^2 grows with the runs.
  double needed(double odds) const;
};
/// For each load and each reach.
std::vector<CouplingRuns> runs_for_couplings(const Plan& plan, std::span<const double> loads,
                                             std::span<const double> reaches);

/// Candidate loads for one more run, evenly from `least` to `most` [N], with the expectation of the extended plan.
struct LoadCandidate {
  double load;
  Expectation expected;
};
std::vector<LoadCandidate> next_loads(const Plan& plan, double least, double most, std::size_t candidates,
                                      const std::vector<std::string>& rivals, const Progress& progress = {});

/// The plan with `runs` more runs at the best loads for the goal: added one by one, then exchanged until no exchange
/// helps (Fedorov 1972). `progress` refers to the next run alone, since the number of exchanges is unknown.
Plan best_plan(const Plan& plan, double least, double most, std::size_t runs, Goal goal,
               const std::vector<std::string>& rivals, const Progress& progress = {});

/// Results of simulated and fitted experiments of a plan, to compare with its expectation.
struct Outcome {
  std::size_t experiments = 0, with_value = 0, ok = 0;
  double mean = 0, spread = 0;     // of the parameter: mean, standard deviation
  double mean_standard_error = 0;  // of the fits
  double covered = 0;              // share of 95 % intervals that contain the truth
  std::optional<double> decided;   // fraction in which the right model's probability exceeds 0.95; null without rivals
};
Outcome try_plan(const Plan& plan, std::uint64_t seed, std::size_t experiments, const std::vector<std::string>& rivals,
                 const Progress& progress = {});

}  // namespace mixity
