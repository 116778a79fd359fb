// mixity check: shows how data were read, and their oddities.
#include <functional>
#include <iostream>

#include "cli/commands.h"
#include "cli/fit_flags.h"
#include "cli/flag_words.h"
#include "cli/flags.h"
#include "cli/saved_definition.h"
#include "dataset/pooled.h"
#include "report/data_check.h"

namespace mixity::cli {

int run_check(const Arguments& arguments) {
  if (arguments.empty()) throw UsageError("check needs a data CSV (see mixity help check)");
  const Overrides overrides = data_overrides();
  bool usable = true;
  std::string text;
  std::vector<UnderstoodFile> files;
  const auto check = [&](const std::function<Dataset(const Overrides&)>& load) {
    if (!text.empty()) text += '\n';
    const CheckedData found = check_data(load, overrides, in_flags);
    text += found.text;
    usable &= found.usable;
    files.push_back(found.file);
  };
  if (FLAGS_pool) {
    const std::vector<RunFile> runs = pooled_files(arguments);
    check([&](const Overrides& constants) { return load_pooled(runs, constants); });
  } else {
    for (const std::string& path : arguments)
      check([&path](const Overrides& constants) { return load_dataset(path, constants); });
  }
  write_outputs(definition_to_save(files));  // prints nothing if that is refused
  std::cout << text << saved_text();
  return usable ? kFine : kBadInput;
}

}  // namespace mixity::cli
