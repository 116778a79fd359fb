// mixity merge: what `mixity fit --shard=i/n --format=json` made of the parts of a list becomes one document.
#include <iostream>

#include "base/files.h"
#include "cli/commands.h"
#include "cli/flags.h"
#include "report/fit_json.h"

namespace mixity::cli {

int run_merge(const Arguments& arguments) {
  if (arguments.empty()) throw UsageError("merge needs the JSON files of all shards of mixity fit");
  const std::string merged = merge_json(arguments);
  if (FLAGS_out.empty())
    std::cout << merged;
  else
    write_files({{FLAGS_out, merged}}, arguments);
  return kFine;
}

}  // namespace mixity::cli
