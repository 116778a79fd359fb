// What a plan will tell, and which loads tell most.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fitting/options.h"
#include "studies/plan.h"

namespace mixity {

enum class Goal { error, model };  // the least error of the parameter; the largest least chi^2 of the rivals

/// Of a plan, before it is done.
struct Expectation {
  /// Of the model's first parameter, by the Fisher information of all points with what is known of the constants
  /// (nuisance constants: Ds-optimality, Silvey 1980): the error of a fit to the plan without noise. Null where
  /// the plan does not determine it.
  std::optional<double> standard_error;
  /// How far each rival's best fit to the plan without noise is off, as chi^2: the T-criterion of Atkinson & Fedorov
  /// 1975 (Biometrika 62, 57). Twice the expected logarithm of the odds against it, but for what its freedom costs.
  struct Rival {
    std::string model;
    double chi2;
    double odds() const;  // exp(chi2/2), infinite where that is no double
  };
  std::vector<Rival> rivals;
  /// Of the least chi^2 of the rivals; infinite without any.
  double least_chi2() const;
  /// The smaller the better: the standard error, infinite where there is none; or less the least chi^2.
  double cost(Goal goal) const;
};

/// `rivals`: keys of models; the plan's own is left out. Throws std::invalid_argument where problem_of names one.
Expectation expect(const Plan& plan, const std::vector<std::string>& rivals);

/// Which load is best for one more run: candidates from `least` to `most` [N], evenly in load, each with the
/// expectation of the plan with it.
struct LoadCandidate {
  double load;
  Expectation expected;
};
std::vector<LoadCandidate> next_loads(const Plan& plan, double least, double most, std::size_t candidates,
                                      const std::vector<std::string>& rivals, const Progress& progress = {});

/// The plan with so many more runs, at the loads that serve the goal best: one after the other, then exchanged until no
/// exchange helps (Fedorov 1972). How many that takes is not known before: `progress` is told of the loads tried for
/// the next run.
Plan best_plan(const Plan& plan, double least, double most, std::size_t runs, Goal goal,
               const std::vector<std::string>& rivals, const Progress& progress = {});

/// Experiments of a plan, simulated and fitted as they will be: the answer that the expectation foretells.
struct Outcome {
  std::size_t experiments = 0, with_value = 0, ok = 0;
  double mean = 0, spread = 0;     // of the parameter: mean, standard deviation
  double mean_standard_error = 0;  // as the fits state it
  double covered = 0;              // share of 95 % intervals that hold the truth
  std::optional<double> decided;   // share in which the right model's probability exceeds 0.95; null without rivals
};
Outcome try_plan(const Plan& plan, std::uint64_t seed, std::size_t experiments, const std::vector<std::string>& rivals,
                 const Progress& progress = {});

}  // namespace mixity
