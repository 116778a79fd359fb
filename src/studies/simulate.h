// Planned and simulated experiments.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dataset/dataset.h"
#include "fitting/standard_errors.h"

namespace mixity {

/// A planned experiment: guesses about the interface, knowledge of the constants, and capabilities of the apparatus.
struct Plan {
  std::string model = "c";
  std::vector<double> parameters;  // guesses, in the model's order
  Metadata constants;              // radius, modulus, toughness and offsets, with standard errors if they have any
  std::vector<double> loads;       // N, one run each; m if constants.control is approach
  std::size_t points = 25;         // per run, at equal steps of T from 0
  double reach = 0.9;              // the largest T, as a fraction of that at which the contact jumps
  StatedError sigma_T, sigma_A;    // "1%" of each value, or one quantity
};

/// Why the plan is impossible: unknown model, parameters out of range, missing constants, loads below pull-off, fewer
/// than three points, reach out of range, errors of 0 or in a wrong unit. Empty if it is possible.
std::string problem_of(const Plan& plan);

/// Experiment number `index` of the stream `seed`, independent of the order of calls. Its constants differ from the
/// stated ones by random errors (log-normal, or normal for offsets); so do its readings of T and A from the true
/// values, and it states their standard errors. Null index: no errors. Provenance reconstructed. Throws
/// std::invalid_argument with problem_of(plan) unless that is empty.
Dataset simulate(const Plan& plan, std::uint64_t seed, std::optional<std::uint64_t> index);

}  // namespace mixity
