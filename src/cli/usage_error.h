// A command line that cannot be acted on: one line on standard error, exit code 2.
#pragma once

#include <stdexcept>

namespace mixity::cli {

struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace mixity::cli
