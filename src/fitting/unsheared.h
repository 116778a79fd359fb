// Compares the areas without shear with JKR: a test of the constants of the experiment without a mode-mixity model.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dataset/dataset.h"
#include "fitting/options.h"

namespace mixity {

struct UnshearedTest {
  std::size_t points = 0, loads = 0;
  /// With the constants as stated, within their standard errors. A point contributes at most 9 to chi2.
  double chi2 = 0, p_value = 1;
  /// The value of one constant that these areas imply if the others are as stated.
  struct Implied {
    std::string constant, unit;
    double stated, value, standard_error;  // in the reader's unit
    double chi2, p_value;                  // at that value
  };
  std::vector<Implied> implied;  // modulus, toughness, load_offset
};

/// `options.errors`: of the points, from a fit; null: as stated, or from the scatter of neighbours. Uses points with T
/// up to 1 % of the largest of their run. Null without loads, where no run has such a point, or where the stated
/// constants allow no contact at one of these loads. Throws InputError as a fit does where errors are unusable.
std::optional<UnshearedTest> test_unsheared(const Dataset& data, const FitOptions& options);

}  // namespace mixity
