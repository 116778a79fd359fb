// Makes a data set from arrays in memory.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "dataset/dataset.h"

namespace mixity {

/// One column: a heading as in a file ("P [mN]", "curve"), and either numbers or texts. All columns have the same
/// length. The arrays are not copied; they must outlive the call.
struct ArrayColumn {
  std::string heading;
  std::span<const double> numbers{};
  std::span<const std::string> texts{};
};

/// Returns what load_dataset makes of a file with these columns, equal to the last bit, with the same names, units,
/// notes and reasons. The first row counts as line 2, as below a header. `name`: the file named in messages. Throws
/// InputError as load_dataset does, and if columns differ in length or there are none.
Dataset make_dataset(const std::string& name, const std::vector<ArrayColumn>& columns, const Overrides& constants);
Dataset make_dataset(const std::string& name, const std::vector<ArrayColumn>& columns, const Metadata& metadata);

}  // namespace mixity
