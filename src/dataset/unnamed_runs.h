// Finds the loading runs of a file that does not name them.
#pragma once

#include <vector>

#include "dataset/dataset.h"

namespace mixity {

/// Groups readings of the normal load by nominal load; returns the group of each, numbered in order of appearance.
/// `readings` are in the order of measurement. A new group begins where the mean changes (PELT) within a few readings
/// by nearly four standard deviations, which are estimated from successive differences. Drift begins no group, and
/// groups of equal mean are merged. If the rows are in another order, groups are separated by gaps between the sorted
/// readings. The result may be one group if all readings are within 25 % or successive ones are independent (von
/// Neumann's ratio above 1). Empty if the loads do not scatter: a few recurring values, or blocks of equal values.
std::vector<std::size_t> group_by_nominal_load(const std::vector<double>& readings);

/// Replaces runs, one per reading of the load, by one run per nominal load. Each point keeps its own reading. Adds a
/// note if readings scatter.
void join_noisy_loads(Dataset& data);

/// Splits a run where T falls between successive points from more than half of its largest value to near its start, and
/// then rises again. A run in which T falls and stays low, or that is not ordered by T, remains one. Adds a note.
void split_repeated_shear(Dataset& data);

}  // namespace mixity
