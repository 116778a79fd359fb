// Which readings of the normal load are those of one nominal load.
#pragma once

#include <vector>

#include "dataset/dataset.h"

namespace mixity {

/// Of readings in the order in which they were taken, the level that each belongs to, numbered as they come. Levels
/// change where the mean does (PELT) by nearly four standard deviations, which the steps between successive readings
/// tell, within a few readings: what drifts is one level, and so are stretches with one mean. Where the rows come in an
/// order of something else, levels are parted by gaps between the sorted readings. One level, if no other is found and
/// all lie within 25 % or successive readings know nothing of each other (von Neumann's ratio above 1). Empty where
/// loads do not scatter, a few that come again and again, or blocks of equal ones.
std::vector<std::size_t> nominal_levels(const std::vector<double>& readings);

/// Makes runs of the points of a data set whose file does not name any, one for each nominal load; each point keeps the
/// load that was read. Adds a note if readings scatter.
void join_noisy_loads(Dataset& data);

/// Gives each run the mean of the loads that its points read; where all read the same, that itself.
void take_mean_loads(Dataset& data);

}  // namespace mixity
