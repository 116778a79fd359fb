#include "cli/program.h"

#include <glog/logging.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>

#include "base/files.h"
#include "base/input_error.h"
#include "base/inputs.h"
#include "base/text.h"
#include "cli/commands.h"
#include "cli/flag_words.h"
#include "cli/flags.h"

namespace mixity::cli {
namespace {

int run_command(const Arguments& words) {
  if (words.empty()) return run_help({}), kBadUsage;
  const std::string& name = words[0];
  if (name == "--version" || name == "-version") {
    std::cout << "mixity " MIXITY_VERSION "\n";
    return kFine;
  }
  if (name == "--help" || name == "-help" || name == "-h") return run_help({});
  define_flags_of_tables();
  const Command& command = find_command(name);
  for (const std::string& word : words)
    if (word == "--help" || word == "-h") return run_help({name});
  const Arguments arguments = parse_flags(command, {words.begin() + 1, words.end()});
  define_laws_of_flags();
  return command.run(arguments);
}

int fail(const std::string& message, int code) {
  warn(printable(message));
  return code;
}

}  // namespace

int run_program(const std::vector<std::string>& words) {
  FLAGS_logtostderr = true;
  FLAGS_minloglevel = google::GLOG_FATAL;  // silences Ceres, since the status of a fit says more
  google::InitGoogleLogging("mixity");
  std::signal(SIGXFSZ, SIG_IGN);  // makes write() fail for a file that grows too large, instead of ending the program
  remember_files_read();
  int code = kFine;
  try {
    code = run_command(words);
    std::cout.flush();
    if (!std::cout) code = fail("standard output cannot be written", kCannotWrite);
  } catch (const UsageError& error) {
    code = fail(error.what(), kBadUsage);
  } catch (const InputError& error) {
    code = fail(error.text(in_flags), kBadInput);
  } catch (const OutputError& error) {
    code = fail(error.text(in_flags), kCannotWrite);
  } catch (const std::bad_alloc&) {
    code = fail("not enough memory", kBadInput);
  } catch (const std::exception& error) {
    code = fail(std::string("internal error, please report it: ") + error.what(), kInternalError);
  }
  return code;
}

}  // namespace mixity::cli
