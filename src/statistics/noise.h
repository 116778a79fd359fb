// The noise of readings that follow a smooth course.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace mixity {

/// Standard deviation of readings about a smooth course, by the median of their second differences, which neither a
/// trend nor a few jumps move; 0 of so few that these say nothing.
double noise_of(const std::vector<double>& values);

/// Replaces single readings that lie far from the median of the five about them by that median (Hampel 1974, J. Am.
/// Stat. Assoc. 69, 383): what wires catch is no force. Returns how many.
std::size_t remove_spikes(std::vector<double>& values);

/// Noise that grows with what is read: variance = constant + relative^2 x^2.
struct NoiseModel {
  double constant = 0, relative = 0;  // a variance; a share
  double at(double x) const { return std::sqrt(constant + relative * relative * x * x); }
};

/// Of second differences of courses that one apparatus has read, by weighted least squares of their squares on those of
/// the readings; what lies far above that (a jump) is left out. `otherwise`: where they are too few.
NoiseModel noise_model(const std::vector<std::vector<double>>& courses, double otherwise);

}  // namespace mixity
