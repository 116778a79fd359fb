// Experiments of a plan, made by the models and random numbers.
#pragma once

#include <cstdint>
#include <optional>

#include "dataset/dataset.h"
#include "studies/plan.h"

namespace mixity {

/// Experiment number `index` of the stream `seed`: the same whoever asks for it, in whatever order. The constants of
/// its laboratory differ from those stated by their standard errors (log-normal, or normal for offsets), its readings
/// from the truth by those of T and A, which it states. Null index: nothing differs, the mean of all. Provenance
/// reconstructed. Throws std::invalid_argument where problem_of(plan) names one.
Dataset simulate(const Plan& plan, std::uint64_t seed, std::optional<std::uint64_t> index);

}  // namespace mixity
