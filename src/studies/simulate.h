// Planned experiments, and simulated ones.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dataset/dataset.h"
#include "fitting/standard_errors.h"

namespace mixity {

/// A planned experiment: what is guessed of the interface, what is known of the constants, and what the apparatus can
/// do.
struct Plan {
  std::string model = "c";
  std::vector<double> parameters;  // guesses, in the order of the model's
  Metadata constants;              // radius, modulus, toughness and offsets, with standard errors where they have some
  std::vector<double> loads;       // N, one run each
  std::size_t points = 25;         // of a run, at equal steps of T from 0
  double reach = 0.9;              // the longest T, as a share of that at which the contact jumps
  StatedError sigma_T, sigma_A;    // "1%" of each value, or one quantity
};

/// Why the plan is not possible: unknown model, parameters out of range, missing constants, loads below pull-off, fewer
/// than three points, reach out of range, errors of the wrong unit or 0. Empty if it is possible.
std::string problem_of(const Plan& plan);

/// Experiment number `index` of the stream `seed`, independent of the order of calls. Its constants differ from the
/// stated ones by their standard errors (log-normal, or normal for offsets), its readings from the truth by those of T
/// and A, which it states. Null index: no errors. Provenance reconstructed. Throws std::invalid_argument with
/// problem_of(plan) unless that is empty.
Dataset simulate(const Plan& plan, std::uint64_t seed, std::optional<std::uint64_t> index);

}  // namespace mixity
