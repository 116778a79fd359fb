// Pull-off loads of sheared contacts, (T, P_c) or (u, P_c).
#pragma once

#include "dataset/dataset.h"

namespace mixity {

/// Completes pull-off loads when all rows are read: those with tension positive are reversed, with a note, where this
/// is certain. Every load of pull-off lies above that without shear, which is below 0 (JKR), and rises with shear.
void finish_pull_off(Dataset& data);

/// How many readings state no standard error of their load.
std::size_t without_pull_off_error(const Dataset& data);

/// The largest |P| and the largest |T| that is held; 0 without any.
struct LargestPullOff {
  double load = 0, shear = 0;
};
LargestPullOff largest_pull_off(const Dataset& data);

/// The areas alone.
Dataset without_pull_off(Dataset data);

}  // namespace mixity
