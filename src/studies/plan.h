// An experiment that is to be done: what is guessed of the interface, what is known of the constants, and what the
// apparatus can do.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "dataset/metadata.h"
#include "fitting/standard_errors.h"

namespace mixity {

struct Plan {
  std::string model = "c";
  std::vector<double> parameters;  // the guess, in the order of the model's
  Metadata constants;              // radius, modulus, toughness and offsets, with standard errors where they have some
  std::vector<double> loads;       // N, one run each
  std::size_t points = 25;         // of a run, at equal steps of T from 0
  double reach = 0.9;              // the longest T, as a share of that at which the contact jumps
  StatedError sigma_T, sigma_A;    // "1%" of each value, or one quantity
};

/// Why no experiment can be made of it: a model or parameters that cannot be, constants that are missing, loads below
/// pull-off, fewer than three points, a reach that is none, errors of the wrong kind or 0. Empty if one can.
std::string problem_of(const Plan& plan);

}  // namespace mixity
