// mixity check: what was understood, what is odd.
#include <iostream>

#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/flags.h"
#include "cli/usage_error.h"
#include "report/check_text.h"

namespace mixity::cli {

int run_check(const Arguments& arguments) {
  if (arguments.empty()) throw UsageError("check needs a data CSV (see mixity help check)");
  const Overrides overrides = metadata_overrides();
  std::string text;
  for (const std::string& path : arguments)
    text += (text.empty() ? "" : "\n") + check_text(load_dataset(path, overrides));
  std::cout << text;
  return kFine;
}

}  // namespace mixity::cli
