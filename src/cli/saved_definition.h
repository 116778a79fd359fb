// --save of check and runs: the definition of the files that were read.
#pragma once

#include <string>
#include <vector>

#include "cli/commands.h"
#include "dataset/definition.h"

namespace mixity::cli {

/// Writes the definition to --save, which must not be a file that was read. Returns a line that says so; without --save
/// does nothing. Throws UsageError and OutputError.
std::string save_definition(const std::vector<UnderstoodFile>& files, const Arguments& arguments);

}  // namespace mixity::cli
