// Where a sheared contact begins to slide.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "statistics/change_points.h"

namespace mixity {

inline constexpr double kFallOfNoise = 8;   // standard deviations of T that a fall exceeds and noise does not
inline constexpr double kLeastFall = 0.01;  // of the rise so far

/// The last frame in shear..end before the contact slides, and how well it is known: of a fall of T that is more than
/// noise, or a break of T, or of T and A, from the line before it, the most likely break of both. Null if there is
/// none. Standard deviations of T and A are positive.
std::optional<ChangePoint> onset_of(const std::vector<double>& T, const std::vector<double>& A, std::size_t shear,
                                    std::size_t end, double noise_T, double noise_A);

/// The last frame in begin..end before a course leaves, downwards, the parabola that it followed. Null if it does not.
std::optional<ChangePoint> first_break_below(const Course& course, std::size_t begin, std::size_t end);

}  // namespace mixity
