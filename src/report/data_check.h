// What `mixity check` finds: how data are read, and what is odd about them.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "base/input_error.h"
#include "dataset/dataset.h"

namespace mixity {

struct CheckedData {
  std::string text;                           // check_text, or reading_text where constants are missing
  bool usable = false;                        // there are points
  std::optional<MissingConstants> missing{};  // constants that the data need and nobody states
};

/// `load`: reads the data with these constants. Throws what it throws, but for missing constants.
CheckedData check_data(const std::function<Dataset(const Overrides&)>& load, const Overrides& constants, Wording words);

}  // namespace mixity
