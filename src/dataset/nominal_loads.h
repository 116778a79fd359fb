// Groups scattered readings of the normal load by their nominal loads.
#pragma once

#include <vector>

#include "dataset/dataset.h"

namespace mixity {

/// The group of each reading, numbered in order of appearance; a group has one nominal load. `readings` are in the
/// order in which they were taken: a new group begins where their mean changes (PELT) within a few readings by nearly
/// four standard deviations, which are estimated from successive differences; a drift begins none, and groups of equal
/// mean are one. If the rows are ordered by something else, groups are separated by gaps between the sorted readings.
/// One group, if no other is found and all readings are within 25 % or successive ones are independent (von Neumann's
/// ratio above 1). Empty if the loads do not scatter: a few values that recur, or blocks of equal ones.
std::vector<std::size_t> group_by_nominal_load(const std::vector<double>& readings);

/// Replaces the runs of a data set whose file names none by one for each nominal load; each point keeps its own reading
/// of the load. Adds a note if readings scatter.
void join_noisy_loads(Dataset& data);

/// Sets the load of each run to the mean over its points, exactly if all are equal.
void take_mean_loads(Dataset& data);

}  // namespace mixity
