// The folds of equilibrium curves as text and JSON: dimensionless, or in the user's units with standard errors.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dataset/metadata.h"
#include "fitting/prediction.h"

namespace mixity {

/// Units by name, empty if dimensionless; shown = dimensionless * scale.
struct InstabilityUnits {
  std::string force{}, area{}, displacement{}, stiffness{};
  double force_scale = 1, area_scale = 1, displacement_scale = 1, stiffness_scale = 1;
  std::string held{};  // the unit of an approach that is held in place of the load
};

struct InstabilityReport {
  std::string model;
  std::vector<std::pair<std::string, Derived>> parameters;
  std::string source{};  // "mergel2018, status ok": the fit; empty: parameters were given
  InstabilityUnits units{};
  struct AtLoad {
    double load;  // as shown
    FoldsPrediction predicted;
  };
  std::vector<AtLoad> loads{};
  std::optional<double> shear_strength{};  // tau0, dimensionless; null if not stated
  Metadata stated{};                       // what it states of mode III is shown
};

/// A table of the folds, and lists of loads without a fold and of loads at which the interface slides first.
std::string to_text(const InstabilityReport& report);

/// For given parameters: {model, lambda (or the model's own parameters), mode_III, units (if any), load, folds:
/// [{control, stiffness (for that control), met_on ("loading" or "reversal"), T, u, A, psi, jumps_to, area_lost}]}. For
/// a fit: {model, source, parameters: {name: {value, stderr}}, mode_III, units, slides_first: [loads] (if a
/// shear strength is stated), loads: [{load, folds, problem (without folds)}]}, with T_stderr, u_stderr and A_stderr in
/// the folds, null where unknown. A load at which the edge of an elliptic contact closes before a fold has closings:
/// [{control, end ("closes_along" or "closes_across"), T, u, A}]. Full precision.
std::string to_json(const InstabilityReport& report);

}  // namespace mixity
