// Forces and areas of one experiment on one clock: a frame for each picture of the contact.
#pragma once

#include <string>
#include <vector>

#include "dataset/logs/recording.h"

namespace mixity {

/// In SI. Forces are means over the duration of a frame, centred on it.
struct Frames {
  double interval = 0;       // s, from frame to frame
  std::vector<double> time;  // s, of the clock of the areas
  std::vector<double> P, T, A;
  double samples = 1;      // of the force in a frame, typically
  double noise_P = 0;      // N, of one sample
  std::size_t spikes = 0;  // outliers among the samples of the force, which were replaced
  double lag_error = 0;    // s, standard error
  double lag = 0;          // s: the clock of the forces reads time - lag when that of the areas reads time
  std::vector<double> force_time, force_T;  // every sample of T, on the areas' clock
  std::string lag_source;  // "one clock", "stated", "from 5 sudden changes of T", "from 5 onsets of sliding"
};

/// Times and areas of pictures: of the rows with an area the first of each picture, which may be repeated in others.
struct Pictures {
  std::vector<double> time, A;
};
Pictures pictures(const Recording& recording);

/// Median step of times.
double typical_step(const std::vector<double>& time);

/// Averages the forces over the frames of the areas, whose clock is ahead of theirs by `lag` seconds. `areas` may be
/// the same recording. Frames without force are left out. Throws InputError if the two do not overlap in time.
Frames make_frames(const Recording& forces, const Recording& areas, double lag = 0);

}  // namespace mixity
