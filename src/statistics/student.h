// Student's t distribution for errors with outliers.
#pragma once

#include <span>

namespace mixity {

/// Errors are `scale` times a variable of Student's t distribution.
struct StudentErrors {
  double freedom;  // 1..100: the fewer degrees of freedom, the more outliers; 100 is nearly Gaussian
  double scale;
};
/// The scale of maximum likelihood (Lange, Little & Taylor 1989, J. Am. Stat. Assoc. 84, 881), or 1 if `known_scale`.
/// The likelihood of the degrees of freedom is multiplied by freedom^2 exp(-freedom/10), a gamma prior for their
/// logarithm (Juarez & Steel 2010, J. Bus. Econ. Stat. 28, 52): few deviations hardly determine them, and an estimate
/// that is too low gives most points too little weight. Fewer than half of the deviations may be 0.
StudentErrors student_errors(std::span<const double> deviations, bool known_scale);

}  // namespace mixity
