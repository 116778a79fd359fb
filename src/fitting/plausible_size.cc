#include "fitting/plausible_size.h"

#include <cmath>

#include "fitting/constants.h"
#include "fitting/standard_errors.h"

namespace mixity {
namespace {

/// The usual size: adhesion differs most from day to day; gauges and cameras are calibrated.
double usual_size(const Dataset& data, Constant constant) {
  constexpr double kOfLargest = 0.01;  // of the largest reading, for the zero of a load cell or of a threshold
  switch (constant) {
    case kToughness:
    case kToughnessDrift:
      return 0.1;
    case kModulus:
    case kModulusDrift:
      return 0.05;
    case kHysteresis:
      return 0.15;
    case kLoadOffset:
    case kApproachOffset:
      return kOfLargest * largest_value(data, &Point::P);
    case kShearOffset:
      return kOfLargest * largest_value(data, &Point::T);
    case kAreaOffset:
      return kOfLargest * largest_value(data, &Point::A);
    default:  // radius, scales, shape
      return 0.02;
  }
}

}  // namespace

double implausibility(const Dataset& data, const std::string& quantity, double deviation, double value) {
  constexpr double kOfParameter = 0.3;
  const auto constant = constant_named(quantity);
  const double usual = constant ? usual_size(data, *constant) : kOfParameter * std::abs(value);
  return usual > 0 ? std::pow(deviation / usual, 2) : 0;
}

}  // namespace mixity
