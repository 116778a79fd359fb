// A data set from arrays in memory.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "dataset/dataset.h"

namespace mixity {

/// One column: a heading as in a file ("P [mN]", "curve"), and either numbers or texts, as many as in all others. The
/// arrays are not copied; they must outlive the call.
struct ArrayColumn {
  std::string heading;
  std::span<const double> numbers{};
  std::span<const std::string> texts{};
};

/// The data set that load_dataset makes of a file with these columns, to the last bit, with the same names, units,
/// notes and reasons. The first row is line 2, as below a header. `name`: the file in messages. Throws InputError as
/// load_dataset does, and if columns differ in length or there are no columns.
Dataset make_dataset(const std::string& name, const std::vector<ArrayColumn>& columns, const Overrides& constants);
Dataset make_dataset(const std::string& name, const std::vector<ArrayColumn>& columns, const Metadata& metadata);

}  // namespace mixity
