// mixity check: what was understood, what is odd.
#include <iostream>

#include "cli/commands.h"
#include "cli/fit_flags.h"
#include "cli/flag_words.h"
#include "cli/flags.h"
#include "dataset/pooled.h"
#include "fitting/unsheared.h"
#include "report/data_text.h"

namespace mixity::cli {

namespace {

/// Null if the stated errors cannot be used, which the text reports elsewhere.
std::optional<UnshearedTest> unsheared_if_errors_allow(const Dataset& data) {
  try {
    return test_unsheared(data, {});
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// Adds values for missing constants, on which the reading of a file does not depend.
Overrides with_some(const std::vector<std::string>& constants, Overrides stated) {
  for (const std::string& name : constants)
    stated.emplace_back(name, name == "radius" ? "1 mm" : name == "modulus" ? "1 MPa" : "1 J/m^2");
  return stated;
}

}  // namespace

int run_check(const Arguments& arguments) {
  if (arguments.empty()) throw UsageError("check needs a data CSV (see mixity help check)");
  const Overrides overrides = data_overrides();
  bool usable = true;
  std::string text;
  const auto check = [&](const auto& load) {
    if (!text.empty()) text += '\n';
    try {
      const Dataset data = load(overrides);
      usable &= !data.points.empty();
      text += check_text(data, unsheared_if_errors_allow(data), in_flags);
    } catch (const MissingConstants& error) {
      std::cout << text << reading_text(load(with_some(error.message().options(), overrides))) << std::flush;
      throw;
    }
  };
  if (FLAGS_pool)
    check([files = pooled_files(arguments)](const Overrides& constants) { return load_pooled(files, constants); });
  else
    for (const std::string& path : arguments)
      check([&path](const Overrides& constants) { return load_dataset(path, constants); });
  std::cout << text;
  return usable ? kFine : kBadInput;
}

}  // namespace mixity::cli
