// The loading runs of a log: in each contact at one normal load, what lies between the start of the shear and the onset
// of sliding.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/input_error.h"
#include "dataset/logs/cycles.h"
#include "dataset/logs/frames.h"
#include "statistics/change_points.h"

namespace mixity {

/// A time of the areas' clock, and the shortest stretch about it that holds it with 95 %.
struct CutTime {
  double time = 0, low = 0, high = 0;  // s
  bool stated = false;
};

struct LoadingRun {
  std::string name;
  double P = 0, scatter_P = 0;  // N: mean and standard deviation of what was read
  double baseline = 0;          // N, of T before the shear, which was taken off; in the direction of the shear
  double baseline_time = 0;     // s, where that was read
  double direction = 1;         // of the shear: -1 where T was turned round
  std::size_t contact = 0, begin = 0, end = 0,
              last = 0;          // frames: of the contact; kept, from begin to before end; behind
  CutTime shear;                 // its start
  std::optional<CutTime> onset;  // of sliding; null: none was seen, and the run goes on to its largest T
  std::vector<double> smooth_P, T, sigma_T, sigma_A;  // N, N, N, m^2, of the frames that are kept
  std::vector<Cycle> cycles;                          // T less the baseline
};

/// What becomes of a stretch of frames.
struct Phase {
  std::size_t begin, end;
  std::string_view name;    // "out of contact", "approach", "hold", "shear", "sliding", "no run"
  std::string_view reason;  // why its frames are not kept; empty of those that are
};

struct StatedCut {
  std::optional<double> shear{}, onset{};  // s
  bool leave_out = false;
  std::string file{};  // that states them, and where
  FilePlace shear_place{}, onset_place{};
};

struct RunOptions {
  std::map<std::string, StatedCut> cuts{};  // by the name of a run
  bool by_shear_alone = false;              // the area has no say in where sliding begins
  std::optional<bool> drift{};              // take a line through the baselines of all runs off T; null: if it is sure
};

struct LoadingRuns {
  Frames frames;
  double zero_P = 0;                          // N, what was read out of contact and taken off P
  double zero_P_error = 0, zero_T_error = 0;  // N, standard errors: of that; of the zeros of T and of the lag, typical
  double drift_T = 0;                         // N/s, of the zero of T from run to run
  double drift_error = 0;                     // N/s, standard error; 0 of two runs
  bool drift_removed = false;
  bool drifts = false;  // by more than noise, and it was not taken off
  std::vector<LoadingRun> runs;
  std::vector<Phase> phases;  // of all frames, in order
};

/// Contact is where the area is above its noise and a twentieth of the largest. In it, levels of the load are found by
/// PELT; a level of some length is one try. The shear begins where T leaves its level (hinge_point); it ends before the
/// first fall of T that is more than noise (Page's CUSUM of 1954 tells of it), where T and A together break most likely
/// (break_point), or where T stops rising. What happens later is sliding. Names are the loads, "P=4.68 mN", in the unit
/// given. Throws InputError for a cut that
/// is stated outside the contact of its run; `cuts` of names that no run has are left to the caller.
LoadingRuns find_loading_runs(Frames frames, const std::string& force_unit, double force_factor,
                              const RunOptions& options);

}  // namespace mixity
