// The folds of equilibrium curves as text and JSON: dimensionless, or in a reader's units with standard errors.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fitting/prediction.h"

namespace mixity {

/// Units by name, empty if dimensionless; shown = dimensionless * scale.
struct InstabilityUnits {
  std::string force{}, area{}, displacement{}, stiffness{};
  double force_scale = 1, area_scale = 1, displacement_scale = 1, stiffness_scale = 1;
};

struct InstabilityReport {
  std::string model;
  std::vector<std::pair<std::string, Derived>> parameters;
  std::string source{};  // "mergel2018, status ok": what was fitted; empty: parameters were given
  InstabilityUnits units{};
  struct AtLoad {
    double load;  // as shown
    FoldsPrediction predicted;
  };
  std::vector<AtLoad> loads{};
  std::optional<double> shear_strength{};  // tau0, dimensionless, where it is stated

  /// Whether T = tau0 A is met before this fold: the interface slides first. False without a strength.
  bool slides_before(const FoldPrediction& fold) const {
    return shear_strength && *fold.T.value > *shear_strength * *fold.A.value;
  }
};

/// A table for each load.
std::string to_text(const InstabilityReport& report);

/// Of given parameters: {model, lambda (or the model's own parameters), units (if there are some), load, folds:
/// [{control, stiffness (if that is the control), met_on ("loading" or "reversal"), T, u, A, psi, jumps_to,
/// area_lost}]}. Of a fit: {model, source, parameters: {name: {value, stderr}}, units, loads: [{load, folds, problem
/// (if there are none)}]}, with slides_first: [loads] where a shear strength is stated, and where T, u and A have
/// T_stderr, u_stderr, A_stderr beside them, null where they are not known. Full precision.
std::string to_json(const InstabilityReport& report);

}  // namespace mixity
