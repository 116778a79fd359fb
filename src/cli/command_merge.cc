// mixity merge: merges the documents that `mixity fit --shard=i/n --format=json` wrote for the parts of a list.
#include "cli/commands.h"
#include "cli/flags.h"
#include "report/fit_json.h"

namespace mixity::cli {

int run_merge(const Arguments& arguments) {
  if (arguments.empty()) throw UsageError("merge needs the JSON files of all shards of mixity fit");
  print_or_write(merge_json(arguments));
  return kFine;
}

}  // namespace mixity::cli
