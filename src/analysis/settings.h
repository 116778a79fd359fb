// The options of a request by name and text, as flags and definitions state them alike.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "analysis/request.h"

namespace mixity {

/// In the order in which a definition is written.
inline constexpr std::array<std::string_view, 23> kOptionNames{
    "models",    "objective", "scale",   "weighted",  "sigma_T",   "sigma_A",    "loss",   "loss_scale",
    "hold",      "free",      "exclude", "leave_out", "interval",  "confidence", "checks", "lambda_prior",
    "bootstrap", "resample",  "seed",    "threads",   "influence", "compare",    "per"};

/// Sets one option, which `request.stated` then has. Lists are separated by commas. Returns what is wrong with the
/// text, as what follows its name in a sentence ("is 'cubic'; it must be log or linear"), or an empty string.
std::string set_option(FitRequest& request, std::string_view name, std::string_view text);

/// Of options that do not go together: the one to name, and what follows its name.
struct Contradiction {
  std::string option, problem;
};
/// Null if all do. To be asked when all are set.
std::optional<Contradiction> contradiction(const FitRequest& request);

}  // namespace mixity
