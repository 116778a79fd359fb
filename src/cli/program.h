// mixity COMMAND [flags] [files]: finds the command, and turns every failure into one line and an exit code.
#pragma once

#include <string>
#include <vector>

namespace mixity::cli {

/// Runs the program with these words behind its name, once in a process: flags keep their values. Returns its exit code.
int run_program(const std::vector<std::string>& words);

}  // namespace mixity::cli
