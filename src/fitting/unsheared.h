// The areas without shear compared with JKR: a test of the constants of the experiment that needs no mode-mixity model.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dataset/dataset.h"
#include "fitting/options.h"

namespace mixity {

struct UnshearedTest {
  std::size_t points = 0, loads = 0;
  /// With the constants as stated, within their standard errors. Each point counts up to nine.
  double chi2 = 0, p_value = 1;
  /// The value of one constant that these areas imply, with the others as stated.
  struct Implied {
    std::string constant, unit;
    double stated, value, standard_error;  // in the reader's unit
    double chi2, p_value;                  // with that value
  };
  std::vector<Implied> implied;  // modulus, toughness, load_offset
};

/// `options.errors`: of the points, as a fit has found them; null: as stated, or from the scatter of neighbours.
/// Points with T up to 1 % of the largest of their run. Null without loads, where no run has such a point, or where the
/// stated constants allow no contact at one of these loads. Throws InputError as a fit does where errors are unusable.
std::optional<UnshearedTest> test_unsheared(const Dataset& data, const FitOptions& options);

}  // namespace mixity
