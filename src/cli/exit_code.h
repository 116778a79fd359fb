// Process exit codes: a contract, extended but not changed.
#pragma once

namespace mixity::cli {

enum ExitCode : int {
  kFine = 0,
  kFitNotOk = 1,  // a fit did not end with status ok
  kBadUsage = 2,  // unknown command or flag, unusable value of a flag
  kBadInput = 3,  // a file cannot be read or understood
  kCannotWrite = 4,
  kInternalError = 5,  // the program's own fault: none is known
};

}  // namespace mixity::cli
