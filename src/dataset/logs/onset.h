// The time when a sheared contact begins to slide.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "dataset/logs/frames.h"
#include "statistics/change_points.h"

namespace mixity {

inline constexpr double kDropOfNoise = 8;   // standard deviations of T: a larger drop is not noise
inline constexpr double kLeastDrop = 0.01;  // relative to the rise so far

/// A time on the clock of the areas, and its 95 % interval.
struct CutTime {
  double time = 0, low = 0, high = 0;  // s
  bool stated = false;
};

/// The time of a change after a frame. The interval includes the error of the lag between the clocks.
CutTime cut_of(const Frames& frames, const ChangePoint& change);

/// The last frame in shear..end (end excluded) before the contact slides. Candidates are drops of T beyond its noise,
/// and places where T, or T and A, depart from the parabola that they follow; the frame is where T and A together most
/// likely change from one line to another. Null if there is none. `noise_T`, `noise_A`: standard deviations, positive.
std::optional<ChangePoint> onset_of(const std::vector<double>& T, const std::vector<double>& A, std::size_t shear,
                                    std::size_t end, double noise_T, double noise_A);

/// The onset of sliding in the samples of the force. `change`: the frame before the onset. `shear`: the first frame of
/// the shear. Null if a frame has few samples, or if they disagree with the frames.
std::optional<CutTime> onset_in_samples(const Frames& frames, const ChangePoint& change, std::size_t shear,
                                        double direction);

/// The last frame in begin..end before a course falls below the parabola that it follows. Null if it never does.
std::optional<ChangePoint> first_break_below(const Course& course, std::size_t begin, std::size_t end);

}  // namespace mixity
