// mixity check: what was understood, what is odd.
#include <iostream>

#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/fit_flags.h"
#include "cli/flags.h"
#include "cli/usage_error.h"
#include "dataset/input_error.h"
#include "dataset/pooled.h"
#include "fitting/unsheared.h"
#include "report/check_text.h"

namespace mixity::cli {

namespace {

/// A file whose errors no fit would take says so among what is odd.
std::optional<UnshearedTest> unsheared_if_errors_allow(const Dataset& data) {
  try {
    return test_unsheared(data, {});
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace

int run_check(const Arguments& arguments) {
  if (arguments.empty()) throw UsageError("check needs a data CSV (see mixity help check)");
  const Overrides overrides = data_overrides();
  std::string text;
  bool usable = true;
  const auto check = [&](const Dataset& data) {
    usable &= !data.points.empty();
    text += (text.empty() ? "" : "\n") + check_text(data, unsheared_if_errors_allow(data));
  };
  if (FLAGS_pool)
    check(load_pooled(pooled_files(arguments), overrides));
  else
    for (const std::string& path : arguments) check(load_dataset(path, overrides));
  std::cout << text;
  return usable ? kFine : kBadInput;
}

}  // namespace mixity::cli
