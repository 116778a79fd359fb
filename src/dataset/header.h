// What the header of a table and the constants beside it say of a data set.
#pragma once

#include <optional>
#include <string>

#include "dataset/dataset.h"
#include "dataset/table/columns.h"

namespace mixity {

/// SI units in those of a point: of force, length and toughness; 1 where the data are dimensionless.
struct PointUnits {
  double force = 1, length = 1, ratio = 1;
};

/// The load of all points, in SI, as the metadata or the name of the file state it; null if neither does. Throws
/// InputError for a name that does not have the form of `load_from`.
std::optional<double> stated_load(const Dataset& data);

/// Fills in the kind of data, the contact, the display units, the ignored columns, and notes. Throws InputError if
/// units are out of range, MissingConstants if constants are needed and not stated.
PointUnits take_header(const Columns& columns, bool load_stated, const std::string& metadata_path, Dataset& data);

}  // namespace mixity
