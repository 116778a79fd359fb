// The folds of one equilibrium curve as text and JSON. Dimensionless.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "mechanics/folds.h"

namespace mixity {

struct InstabilityReport {
  std::string model;
  std::vector<std::pair<std::string, double>> parameters;
  double load;
  std::vector<Fold> folds;
};

std::string to_text(const InstabilityReport& report);

/// {model, lambda (or the model's own parameters), load, folds: [{control, stiffness (if that is the control), met_on
/// ("loading" or "reversal"), T, u, A, psi, jumps_to, area_lost}]}, full precision.
std::string to_json(const InstabilityReport& report);

}  // namespace mixity
