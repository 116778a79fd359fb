// The areas without shear against JKR: what they say of the constants of the experiment, whatever the mode mixity.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dataset/dataset.h"
#include "fitting/options.h"

namespace mixity {

/// What the areas without shear say. Null members where they cannot tell.
struct UnshearedTest {
  std::size_t points = 0, loads = 0;
  /// Of the constants as stated, whose standard errors count; an error of a point that nobody states is that of the
  /// scatter.
  double chi2 = 0, p_value = 1;
  /// Of one constant, the others as stated: what these areas imply.
  struct Implied {
    std::string constant, unit;
    double stated, value, standard_error;  // in the reader's unit
    double chi2, p_value;                  // with that value
  };
  std::vector<Implied> implied;  // modulus, toughness, load_offset
};

/// Points with T up to 1 % of the largest of their run. Null without loads, where no run has such a point, or where the
/// stated constants allow no contact at one of these loads. Throws InputError as a fit does where errors are unusable.
std::optional<UnshearedTest> test_unsheared(const Dataset& data, const FitOptions& options);

}  // namespace mixity
