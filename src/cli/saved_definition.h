// --save of check and runs: the definition of the files that were read.
#pragma once

#include <string>
#include <vector>

#include "base/files.h"
#include "dataset/definition.h"

namespace mixity::cli {

/// The file --save; none without --save. Throws UsageError.
std::vector<OutputFile> definition_to_save(const std::vector<UnderstoodFile>& files);
/// The line that says that it was written; empty without --save.
std::string saved_text();

}  // namespace mixity::cli
