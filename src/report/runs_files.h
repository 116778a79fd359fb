// What `mixity runs` writes of a log: points to be fitted, the phases, the peaks, the cuts to be changed.
#pragma once

#include <string>

#include "dataset/logs/reduced_log.h"

namespace mixity {

/// curve, time, P, T, A, sigma_T, sigma_A of the frames that are kept, in the units of the log.
std::string runs_csv(const ReducedLog& log);
/// The constants of the log and where the points come from, to stand beside them.
std::string runs_toml(const ReducedLog& log);
/// run, P, cycle, time, T_peak, T_min, sigma_T_peak, sigma_T_min: the maximum of T in each cycle of stick and slip, the
/// minimum behind it (slip_cycles), and their standard errors.
std::string peaks_csv(const ReducedLog& log);
/// phase, from, to, frames, run or why they are not kept.
std::string phases_csv(const ReducedLog& log);
/// The cuts as they were made, with their 95 % intervals, in the form that the option cuts reads.
std::string cuts_toml(const ReducedLog& log, Wording words = in_neutral_words);
/// For a terminal: how the log was read, each run with its cuts, what was left out.
std::string runs_text(const ReducedLog& log, Wording words = in_neutral_words);

}  // namespace mixity
