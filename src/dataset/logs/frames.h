// Forces and areas of one experiment on one clock: one frame per picture of the contact.
#pragma once

#include <string>
#include <vector>

#include "dataset/logs/recording.h"

namespace mixity {

/// The lag between two clocks from events of one kind.
struct LagPart {
  std::string by;  // "contacts made", "contacts lost", "falls of T"
  std::size_t events;
  double lag, error;  // s, standard error
};

/// Values are in SI. Forces are means over the duration of a frame, centred on it.
struct Frames {
  double interval = 0;               // s, between frames
  std::vector<double> time;          // s, on the clock of the areas
  std::vector<double> P, T, A, q;    // q = ln(a/b) of the axes; empty: not known
  double samples = 1;                // typical number of samples of the force in a frame
  bool load_is_stated = false;       // and has no zero to be read
  double noise_P = 0;                // N, standard deviation of one sample
  std::size_t spikes = 0;            // force samples that were outliers and were replaced
  double lag_error = 0;              // s, standard error
  double lag_low = 0, lag_high = 0;  // s, 95 % interval of an estimated lag
  double lag = 0;                    // s: the clock of the forces reads time - lag when that of the areas reads time
  std::vector<double> force_time, force_T;  // every sample of T, on the areas' clock
  std::string lag_source;          // "one clock", "stated", "from 3 contacts made, 3 contacts lost, 5 falls of T"
  std::vector<LagPart> lag_parts;  // of an estimated lag
  bool lags_disagree = false;      // by more than their errors; lag_error then covers both
};

/// Times and areas of pictures, each from its first row; further rows may repeat the area.
struct Pictures {
  std::vector<double> time, A, q;  // q: as in Recording
};
Pictures pictures(const Recording& recording);

/// The median difference of successive times.
double typical_step(const std::vector<double>& time);

/// The index of the first of the times that is not before `time`.
std::size_t index_of(double time, const std::vector<double>& times);

/// Averages the forces over the frames of the areas, whose clock is ahead of theirs by `lag` seconds. `areas` may be
/// the same recording. Frames without forces are left out. Throws InputError if the two do not overlap in time.
Frames make_frames(const Recording& forces, const Recording& areas, double lag = 0);

}  // namespace mixity
