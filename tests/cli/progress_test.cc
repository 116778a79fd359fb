// Progress as a user at a terminal sees it, and what an interruption leaves behind.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <set>

#include "cli/run_program.h"
#include "dataset/temporary_folder.h"

namespace mixity::cli {
namespace progress_test {

/// The program with a terminal for its standard error; ended when this goes.
class AtATerminal {
 public:
  explicit AtATerminal(const Words& arguments) : master_(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)) {
    if (master_ < 0 || ::grantpt(master_) != 0 || ::unlockpt(master_) != 0) throw std::runtime_error("no terminal");
    const std::string slave = ::ptsname(master_);
    posix_spawn_file_actions_t streams;
    posix_spawn_file_actions_init(&streams);
    posix_spawn_file_actions_addopen(&streams, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&streams, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&streams, STDERR_FILENO, slave.c_str(), O_RDWR | O_NOCTTY, 0);
    std::string program = MIXITY_PROGRAM;
    Words words = arguments;
    std::vector<char*> argv{program.data()};
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const int error = ::posix_spawn(&child_, program.c_str(), &streams, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&streams);
    if (error != 0) throw std::runtime_error("cannot run " + program);
  }
  AtATerminal(const AtATerminal&) = delete;
  AtATerminal& operator=(const AtATerminal&) = delete;
  ~AtATerminal() {
    if (child_ > 0) end_with(SIGKILL);
    ::close(master_);
  }

  /// Percentages seen, until there are so many different ones or the program says no more for ten seconds.
  std::set<int> percentages(std::size_t wanted) {
    std::set<int> seen;
    pollfd waiting{master_, POLLIN, 0};
    const std::regex bar(R"(fit \[=* *\] +(\d+)%, \d+ s)");
    while (seen.size() < wanted && ::poll(&waiting, 1, 10000) > 0) {
      char part[4096];
      const ssize_t n = ::read(master_, part, sizeof part);
      if (n <= 0) break;
      said_.append(part, static_cast<std::size_t>(n));
      for (std::sregex_iterator i(said_.begin(), said_.end(), bar), end; i != end; ++i)
        seen.insert(std::stoi((*i)[1].str()));
    }
    return seen;
  }
  const std::string& said() const { return said_; }

  /// Returns the signal that ended the program, 0 if it ended by itself.
  int end_with(int signal) {
    ::kill(child_, signal);
    int status = 0;
    ::waitpid(child_, &status, 0);
    child_ = 0;
    return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  }

 private:
  int master_;
  pid_t child_ = 0;
  std::string said_;
};

TEST(Progress, IsShownAtATerminalAndAnInterruptionLeavesNoFile) {
  const TemporaryFolder folder;
  const std::string out = folder.path("out");
  // a million refits take many seconds on any machine; the first two percentages are waited for
  AtATerminal fit({"fit", MIXITY_ROOT "/data/mergel2018.csv", "--models=c", "--bootstrap=1000000", "--out", out});
  const std::set<int> seen = fit.percentages(2);
  EXPECT_EQ(seen.size(), 2u) << fit.said();  // it moves
  EXPECT_EQ(fit.end_with(SIGINT), SIGINT);
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(Progress, IsNotShownWhereNothingTakesASecond) {
  AtATerminal quick({"help"});
  EXPECT_EQ(quick.percentages(1).size(), 0u);
  EXPECT_EQ(quick.said(), "");
}

}  // namespace progress_test
}  // namespace mixity::cli
