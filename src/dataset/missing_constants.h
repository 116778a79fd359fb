// The error of a file that could be read, had constants been stated that its points are made dimensionless with.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/input_error.h"

namespace mixity {

class MissingConstants : public InputError {
 public:
  MissingConstants(const std::string& file, const std::string& message, std::vector<std::string> missing)
      : InputError(file, message), names(std::move(missing)) {}

  std::vector<std::string> names;
};

}  // namespace mixity
