// What `mixity check` reports: how data are read, and their oddities.
#pragma once

#include <functional>
#include <string>

#include "base/input_error.h"
#include "dataset/dataset.h"
#include "dataset/definition.h"

namespace mixity {

struct CheckedData {
  std::string text;     // check_text; if constants are missing, reading_text and which ones
  bool usable = false;  // there are points
  UnderstoodFile file;  // for a definition
};

/// `load` reads the data with these constants. Passes on its exceptions, except for missing constants.
CheckedData check_data(const std::function<Dataset(const Overrides&)>& load, const Overrides& constants, Wording words);

}  // namespace mixity
