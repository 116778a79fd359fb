// The commands of the program. Each is a function that takes arguments and returns an exit code.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace mixity::cli {

/// Process exit codes. Scripts rely on them: codes may be added but not changed.
enum ExitCode : int {
  kFine = 0,
  kFitNotOk = 1,  // a fit ended without status ok
  kBadUsage = 2,  // unknown command or flag, or unusable value of a flag
  kBadInput = 3,  // a file cannot be read or understood
  kCannotWrite = 4,
  kInternalError = 5,  // a fault of the program
};

/// A command line that cannot be executed: one line on standard error, exit code 2.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

using Arguments = std::vector<std::string>;  // from the command line, without the command and flags

int run_fit(const Arguments& arguments);
int run_report(const Arguments& arguments);
int run_predict(const Arguments& arguments);
int run_curve(const Arguments& arguments);
int run_instability(const Arguments& arguments);
int run_map(const Arguments& arguments);
int run_sahli(const Arguments& arguments);
int run_figures(const Arguments& arguments);
int run_design(const Arguments& arguments);
int run_simulate(const Arguments& arguments);
int run_merge(const Arguments& arguments);
int run_check(const Arguments& arguments);
int run_points(const Arguments& arguments);
int run_runs(const Arguments& arguments);
int run_import(const Arguments& arguments);
int run_help(const Arguments& arguments);

struct Command {
  std::string_view name;
  int (*run)(const Arguments&);
  std::string_view usage;    // after the program's name
  std::string_view summary;  // one sentence
  std::vector<std::string_view> flags;
  std::vector<std::string_view> formats{};  // values of --format
};

std::span<const Command> commands();

/// Throws UsageError for an unknown name.
const Command& find_command(const std::string& name);

/// `flags`, followed by the flags of fits, laws and metadata, which several commands have.
std::vector<std::string_view> with_fit_flags(std::vector<std::string_view> flags);

/// Throws UsageError if there are any arguments.
void require_flags_only(const std::string& command, const Arguments& arguments);

/// Prints the program's name and a message to standard error.
void warn(const std::string& message);

}  // namespace mixity::cli
