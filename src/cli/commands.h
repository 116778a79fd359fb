// The commands of the program: one function each, from arguments to exit code.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mixity::cli {

using Arguments = std::vector<std::string>;  // what is left of the command line after command and flags

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
int run_runs(const Arguments& arguments);
int run_import(const Arguments& arguments);
int run_help(const Arguments& arguments);

struct Command {
  std::string_view name;
  int (*run)(const Arguments&);
  std::string_view usage;    // after the program's name
  std::string_view summary;  // one sentence
  std::vector<std::string_view> flags;
  std::vector<std::string_view> formats{};  // that --format may name
};

std::span<const Command> commands();

/// Null if there is no such command.
const Command* find_command(std::string_view name);

}  // namespace mixity::cli
