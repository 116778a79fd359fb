// mixity check: shows how data were read, and their oddities.
#include <functional>
#include <iostream>

#include "cli/commands.h"
#include "cli/fit_flags.h"
#include "cli/flag_words.h"
#include "cli/flags.h"
#include "dataset/pooled.h"
#include "report/data_check.h"

namespace mixity::cli {

int run_check(const Arguments& arguments) {
  if (arguments.empty()) throw UsageError("check needs a data CSV (see mixity help check)");
  const Overrides overrides = data_overrides();
  bool usable = true;
  std::string text;
  const auto check = [&](const std::function<Dataset(const Overrides&)>& load) {
    if (!text.empty()) text += '\n';
    const CheckedData found = check_data(load, overrides, in_flags);
    text += found.text;
    usable &= found.usable;
    if (!found.missing) return;
    std::cout << text << std::flush;
    throw *found.missing;
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
