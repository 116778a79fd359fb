// Loading runs of a file that does not name them.
#pragma once

#include <vector>

#include "dataset/dataset.h"

namespace mixity {

/// The group of each reading of the normal load, numbered in order of appearance; each group has one nominal load.
/// `readings` are in the order of measurement. A new group begins where their mean changes (PELT) within a few readings
/// by nearly four standard deviations, which are estimated from successive differences; a drift begins none, and groups
/// of equal mean are one. If the rows are in another order, groups are separated by gaps between the sorted readings.
/// The result may be one group if all readings are within 25 % or successive ones are independent (von Neumann's ratio
/// above 1). Empty if the loads do not scatter: a few values that recur, or blocks of equal values.
std::vector<std::size_t> group_by_nominal_load(const std::vector<double>& readings);

/// Replaces the runs, one for each reading of the load, by one for each nominal load. Each point keeps its own reading.
/// Adds a note if readings scatter.
void join_noisy_loads(Dataset& data);

/// Splits a run where T goes back, from one point to the next, from more than half of its largest value to near its
/// start, and then rises again. A run in which T falls and stays low, or that is not ordered by T, remains one. Adds a
/// note.
void split_repeated_shear(Dataset& data);

}  // namespace mixity
