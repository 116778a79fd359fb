// The built program as its users run it: arguments in, exit code and both output streams out.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "dataset/temporary_folder.h"

namespace mixity::cli {

using Words = std::vector<std::string>;

inline std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

/// The fields of a line of CSV without quotes.
inline std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line + ",");
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
  return fields;
}

/// The command line, to name it in a failure.
inline std::string joined(const Words& words) {
  std::string text;
  for (const std::string& word : words) text += word + " ";
  return text;
}

struct ProgramResult {
  int exit_code;  // 128 + signal if one ended the program
  std::string out, err;

  /// The complaint, if there is exactly one line of it; otherwise all of it in angle brackets.
  std::string complaint() const {
    const bool one = lines_of(err).size() == 1 && err.ends_with('\n');
    return one ? err.substr(0, err.size() - 1) : "<" + err + ">";
  }
};

/// Runs the program and waits for it. The working directory is that of the test.
inline ProgramResult run_program(const Words& arguments) {
  const TemporaryFolder folder;
  const std::string out = folder.write("out", ""), err = folder.write("err", "");
  posix_spawn_file_actions_t streams;
  posix_spawn_file_actions_init(&streams);
  posix_spawn_file_actions_addopen(&streams, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&streams, STDOUT_FILENO, out.c_str(), O_WRONLY | O_TRUNC, 0);
  posix_spawn_file_actions_addopen(&streams, STDERR_FILENO, err.c_str(), O_WRONLY | O_TRUNC, 0);

  std::string program = MIXITY_PROGRAM;
  Words words = arguments;
  std::vector<char*> argv{program.data()};
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t child = 0;
  const int error = ::posix_spawn(&child, program.c_str(), &streams, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&streams);
  if (error != 0) throw std::runtime_error("cannot run " + program);
  int status = 0;
  if (::waitpid(child, &status, 0) != child) throw std::runtime_error("cannot wait for " + program);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), content_of(out), content_of(err)};
}

/// The program must end with this exit code, this one line of complaint and no output.
inline void expect_refused(const Words& words, int exit_code, const std::string& complaint) {
  const ProgramResult result = run_program(words);
  EXPECT_EQ(result.exit_code, exit_code) << joined(words);
  EXPECT_EQ(result.complaint(), "mixity: " + complaint) << joined(words);
  EXPECT_EQ(result.out, "") << joined(words);
}

}  // namespace mixity::cli
