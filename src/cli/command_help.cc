#include <iostream>

#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/flags.h"
#include "cli/usage_error.h"
#include "dataset/number_text.h"
#include "mechanics/registry.h"

namespace mixity::cli {
namespace {

void explain_program() {
  std::cout << "mixity fits mode-mixity models to soft adhesive contacts that lose area under shear.\n\n"
               "  mixity COMMAND [flags] [files]\n\nCommands\n";
  for (const Command& command : commands()) {
    std::cout << "  " << command.name << std::string(13 - command.name.size(), ' ') << command.summary << '\n';
  }
  std::cout << "\nModels\n";
  for_each_model([](auto model) {
    using Model = decltype(model);
    std::cout << "  " << Model::info.key << std::string(13 - Model::info.key.size(), ' ') << Model::info.name << ": "
              << Model::info.formula;
    for (const ParameterInfo& parameter : Model::parameters)
      std::cout << ", " << parameter.name << " in " << rounded(parameter.lower, 4) << ".."
                << rounded(parameter.upper, 4);
    std::cout << '\n';
  });
  std::cout << "\nmixity help COMMAND lists the flags of a command; mixity --version prints the version.\n\n"
               "Exit codes: 0 fine, 1 a fit did not end ok, 2 bad usage, 3 bad input, 4 output cannot be written,\n"
               "5 a fault of mixity itself.\n";
}

void explain(const Command& command) {
  std::cout << "mixity " << command.usage << "\n\n" << command.summary << '\n';
  if (command.flags.empty()) return;
  std::cout << "\nFlags\n";
  for (const std::string_view flag : command.flags) {
    gflags::CommandLineFlagInfo info;
    gflags::GetCommandLineFlagInfo(std::string(flag).c_str(), &info);
    std::cout << "  --" << flag << std::string(flag.size() < 15 ? 16 - flag.size() : 1, ' ') << info.description;
    if (flag == "format") std::cout << ": " << formats_text(command);
    if (!info.default_value.empty()) std::cout << " (default " << info.default_value << ')';
    std::cout << '\n';
  }
}

}  // namespace

int run_help(const Arguments& arguments) {
  if (arguments.empty()) {
    explain_program();
    return kFine;
  }
  const Command* command = find_command(arguments[0]);
  if (!command) throw UsageError("unknown command '" + arguments[0] + "' (see mixity help)");
  explain(*command);
  return kFine;
}

}  // namespace mixity::cli
