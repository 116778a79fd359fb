#include <iostream>

#include "analysis/laws.h"
#include "base/number_text.h"
#include "cli/commands.h"
#include "cli/flags.h"
#include "mechanics/contact_model.h"

namespace mixity::cli {
namespace {

void explain_program() {
  std::cout << "mixity fits mode-mixity models to soft adhesive contacts that lose area under shear.\n\n"
               "  mixity COMMAND [flags] [files]\n\nCommands\n";
  for (const Command& command : commands())
    std::cout << "  " << command.name << std::string(13 - command.name.size(), ' ') << command.summary << '\n';
  std::cout << "\nModels\n";
  const auto explain_model = [](std::string_view key, std::string_view name, std::string_view formula,
                                const auto& parameters) {
    std::cout << "  " << key << std::string(key.size() < 13 ? 13 - key.size() : 1, ' ') << name << ": " << formula;
    for (const auto& one : parameters)
      std::cout << ", " << one.name << " in " << rounded(one.lower, 4) << ".." << rounded(one.upper, 4);
    std::cout << '\n';
  };
  for (const ContactModel& model : ContactModel::published())
    explain_model(model.info().key, model.info().name, model.info().formula, model.parameters());
  for (const auto& [law, source] : shipped_laws())
    explain_model(law.key, law.name, (law.text.find('=') == std::string::npos ? "f = " : "") + law.text,
                  law.parameters);
  std::cout << "  your own     --law=\"mine: 1 + (1-l)*tan(psi)^2; l=0..1\", or [laws.mine] in a definition\n";
  std::cout << "\nmixity help COMMAND lists the flags of a command; mixity --version prints the version. mixity help "
               "man and\n"
               "mixity help completion print the manual page and the completion of bash.\n\n"
               "Exit codes: 0 fine, 1 a fit did not end ok, 2 bad usage, 3 bad input, 4 output cannot be written,\n"
               "5 a fault of mixity itself.\n";
}

gflags::CommandLineFlagInfo flag_info(std::string_view flag) {
  gflags::CommandLineFlagInfo info;
  gflags::GetCommandLineFlagInfo(std::string(flag).c_str(), &info);
  return info;
}

/// The flag's help, with the formats of the command and its default.
std::string description(std::string_view flag, const Command& command) {
  const auto info = flag_info(flag);
  return info.description + (flag == "format" ? ": " + formats_text(command) : "") +
         (info.default_value.empty() ? "" : " (default " + info.default_value + ")");
}

void explain(const Command& command) {
  std::cout << "mixity " << command.usage << "\n\n" << command.summary << '\n';
  if (command.flags.empty()) return;
  std::cout << "\nFlags\n";
  for (const std::string_view flag : command.flags)
    std::cout << "  --" << flag << std::string(flag.size() < 15 ? 16 - flag.size() : 1, ' ')
              << description(flag, command) << '\n';
}

/// Escapes hyphens, backslashes and leading dots for roff.
std::string roff(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '-' || c == '\\') escaped += '\\';
    if (escaped.empty() && (c == '.' || c == '\'')) escaped += "\\&";
    escaped += c;
  }
  return escaped;
}

void print_manual_page() {
  std::cout << ".TH MIXITY 1 \"\" \"mixity " MIXITY_VERSION
               "\"\n.SH NAME\nmixity \\- fits mode\\-mixity models to soft adhesive contacts that lose area under "
               "shear\n.SH SYNOPSIS\n.B mixity\n.I COMMAND\n[flags] [files]\n.SH COMMANDS\n";
  for (const Command& command : commands()) {
    std::cout << ".SS " << roff(command.name) << "\n.B mixity\n"
              << roff(command.usage) << "\n.PP\n"
              << roff(command.summary) << '\n';
    for (const std::string_view flag : command.flags)
      std::cout << ".TP\n.B \\-\\-" << roff(flag) << '\n' << roff(description(flag, command)) << '\n';
  }
  std::cout << ".SH EXIT STATUS\n0 fine, 1 a fit did not end ok, 2 bad usage, 3 bad input, 4 output cannot be written, "
               "5 a fault of mixity itself.\n";
}

void print_completion() {
  std::string names;
  for (const Command& command : commands()) names += std::string(command.name) + " ";
  std::cout << "# Completion of mixity for bash: commands, their flags, files.\n_mixity() {\n"
               "  local word=${COMP_WORDS[COMP_CWORD]} flags=\n"
               "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n    COMPREPLY=($(compgen -W \""
            << names << "--version\" -- \"$word\"))\n    return\n  fi\n  case ${COMP_WORDS[1]} in\n";
  for (const Command& command : commands()) {
    std::cout << "    " << command.name << ") flags=\"";
    if (command.name == "help") std::cout << names;
    for (const std::string_view flag : command.flags)
      std::cout << "--" << flag << (flag_info(flag).type == "bool" ? " " : "= ");
    std::cout << "\" ;;\n";
  }
  std::cout << "  esac\n  COMPREPLY=($(compgen -W \"$flags\" -- \"$word\"))\n"
               "  [[ ${COMPREPLY-} == *= ]] && compopt -o nospace\n}\ncomplete -o default -F _mixity mixity\n";
}

}  // namespace

int run_help(const Arguments& arguments) {
  if (arguments.empty()) {
    explain_program();
    return kFine;
  }
  if (arguments[0] == "man") return print_manual_page(), kFine;
  if (arguments[0] == "completion") return print_completion(), kFine;
  explain(find_command(arguments[0]));
  return kFine;
}

}  // namespace mixity::cli
