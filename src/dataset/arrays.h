// A data set of numbers that are already in memory.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "dataset/dataset.h"

namespace mixity {

/// One column: a heading as a file's would be ("P [mN]", "curve"), and as many numbers, or as many texts, as all others
/// have. Not copied: what it refers to must live through the call.
struct ArrayColumn {
  std::string heading;
  std::span<const double> numbers{};
  std::span<const std::string> texts{};
};

/// What load_dataset makes of a file with these columns, to the last bit: the same names, units, notes and reasons. The
/// first row is line 2, as below a header. `name` stands for the file in messages. Throws InputError as that does, and
/// if columns differ in length or there are none.
Dataset make_dataset(const std::string& name, const std::vector<ArrayColumn>& columns, const Overrides& constants);
Dataset make_dataset(const std::string& name, const std::vector<ArrayColumn>& columns, const Metadata& metadata);

}  // namespace mixity
