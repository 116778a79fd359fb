// The noise of readings that follow a smooth course.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace mixity {

/// Standard deviation of readings about a smooth course, from the median of their second differences, which is robust
/// against trends and a few jumps; 0 if there are too few readings.
double noise_of(const std::vector<double>& values);

/// Replaces single outliers (electrical spikes) far from the median of the five readings around them by that median
/// (Hampel 1974, J. Am. Stat. Assoc. 69, 383). Returns their number.
std::size_t remove_spikes(std::vector<double>& values);

/// Noise that grows with the reading: variance = constant + relative^2 x^2.
struct NoiseModel {
  double constant = 0, relative = 0;  // a variance; a relative standard deviation
  double at(double x) const { return std::sqrt(constant + relative * relative * x * x); }
};

/// Noise from the second differences of courses measured with one apparatus: weighted least squares of their squares on
/// those of the readings, without jumps. `otherwise`: the standard deviation if there are too few readings.
NoiseModel noise_model(const std::vector<std::vector<double>>& courses, double otherwise);

}  // namespace mixity
