// What `mixity check` reports: how data are read, and their oddities.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "base/input_error.h"
#include "dataset/dataset.h"
#include "dataset/definition.h"

namespace mixity {

struct CheckedData {
  std::string text;                           // check_text, or reading_text if constants are missing
  bool usable = false;                        // there are points
  UnderstoodFile file;                        // for a definition
  std::optional<MissingConstants> missing{};  // constants that the data need and that are not stated
};

/// `load` reads the data with these constants. Passes on its exceptions, except for missing constants.
CheckedData check_data(const std::function<Dataset(const Overrides&)>& load, const Overrides& constants, Wording words);

}  // namespace mixity
