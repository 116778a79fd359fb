// Student's t distribution of errors, some of which are far larger than most.
#pragma once

#include <span>

namespace mixity {

/// Errors are `scale` times a variable of Student's t distribution.
struct StudentErrors {
  double freedom;  // 1..100: the fewer degrees of freedom, the more outliers; 100 is nearly Gaussian
  double scale;
};
/// Of greatest likelihood (Lange, Little & Taylor 1989, J. Am. Stat. Assoc. 84, 881). `known_scale`: it is 1. Fewer
/// than half of the deviations are 0.
StudentErrors student_errors(std::span<const double> deviations, bool known_scale);

}  // namespace mixity
