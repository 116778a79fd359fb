// The program as a child that can be killed, and what it leaves in a folder.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "cli/run_program.h"

namespace mixity::cli {

using Contents = std::map<std::string, std::string>;  // of a folder's files, by path within it

inline const std::string kDefinition = MIXITY_ROOT "/fits/as4_peek_mmb.toml";

inline Contents contents_of(const std::string& folder) {
  Contents contents;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      contents[std::filesystem::relative(entry.path(), folder).string()] = content_of(entry.path().string());
  return contents;
}

/// What is there only while a run writes.
inline bool is_temporary(const std::string& name) {
  return name.find(".mixity-tmp") != std::string::npos || name.find(".mixity-unfinished") != std::string::npos;
}

/// A child that runs the program after `prepare`, its complaints in the file `err`; its output goes nowhere.
inline pid_t start(
    const Words& words, const std::string& err, const std::function<void()>& prepare = [] {},
    const std::string& program = MIXITY_PROGRAM) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  const int nowhere = ::open("/dev/null", O_RDWR), complaints = ::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  ::dup2(nowhere, STDIN_FILENO);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(complaints, STDERR_FILENO);
  prepare();
  Words copies = words;
  copies.insert(copies.begin(), program);
  std::vector<char*> argv;
  for (std::string& word : copies) argv.push_back(word.data());
  argv.push_back(nullptr);
  ::execv(program.c_str(), argv.data());
  ::_exit(127);
}

inline ProgramResult finish(pid_t child, const std::string& err) {
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), "", content_of(err)};
}

}  // namespace mixity::cli
