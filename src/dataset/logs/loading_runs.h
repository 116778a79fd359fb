// The loading runs of a log: each is the part of a load step between the start of the shear and the onset of sliding.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/input_error.h"
#include "dataset/logs/cycles.h"
#include "dataset/logs/frames.h"
#include "dataset/logs/onset.h"

namespace mixity {

struct LoadingRun {
  std::string name;
  double P = 0, scatter_P = 0;                        // N: mean and standard deviation of the readings
  double baseline = 0;                                // N, T before the shear, in its direction; was subtracted from T
  double baseline_time = 0;                           // s, when the baseline was read
  double direction = 1;                               // of the shear; -1: the sign of T was changed
  double noise_T = 0;                                 // N, standard deviation of a frame
  std::size_t contact = 0, last = 0;                  // frames contact..last (last excluded) are the load step
  std::size_t begin = 0, end = 0;                     // frames begin..end (end excluded) are kept
  CutTime shear;                                      // the start of the shear
  std::optional<CutTime> onset;                       // of sliding; null: not seen, the run ends at its largest T
  std::vector<double> smooth_P, T, sigma_T, sigma_A;  // of the kept frames: N, N, N, m^2
  std::vector<Cycle> cycles;                          // with the baseline subtracted from T
};

/// The use of a range of frames.
struct Phase {
  std::size_t begin, end;
  std::string_view name;    // "out of contact", "approach", "hold", "shear", "sliding", "no run"
  std::string_view reason;  // why its frames are not kept; empty if they are
};

struct StatedCut {
  std::optional<double> shear{}, onset{};  // s
  bool leave_out = false;
  std::string file{};  // the file that states the cut, and its places there
  FilePlace shear_place{}, onset_place{};
};

struct RunOptions {
  std::map<std::string, StatedCut> cuts{};  // by name of the run
  bool by_shear_alone = false;              // find the onset of sliding without the area
  std::vector<std::string> taken{};         // names that other runs have
  std::optional<bool> drift{};              // subtract a line through the baselines of all runs; null: if significant
};

struct LoadingRuns {
  Frames frames;
  double zero_P = 0;        // N, read out of contact and subtracted from P
  double zero_P_error = 0;  // N, its standard error
  double zero_T_error = 0;  // N, standard error of T due to the zeros and the lag, typical of the runs
  double drift_T = 0;       // N/s, of the zero of T from run to run
  double drift_error = 0;   // N/s, standard error; 0 if there are only two runs
  bool drift_removed = false;
  bool drifts = false;  // the zero drifts by more than noise, and this was not subtracted
  std::vector<LoadingRun> runs;
  std::vector<std::string> left_out;  // names of runs that are left out as stated, which others do not take
  std::vector<Phase> phases;          // of all frames, in order
};

/// Finds the contacts of a log and the load steps in each (contacts.h). The shear of a step begins where T leaves its
/// baseline (hinge_point), and the run ends at the onset of sliding (onset_of), or where T stops rising. Names are the
/// loads, "P=4.68 mN", in the given unit. Throws InputError for a stated cut outside the load step of its run. Cuts of
/// names that no run has are ignored.
LoadingRuns find_loading_runs(Frames frames, const std::string& force_unit, double force_factor,
                              const RunOptions& options);

}  // namespace mixity
