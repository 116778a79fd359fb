// What becomes of results when the program is killed half-way.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <thread>

#include "cli/started_program.h"
#include "dataset/temporary_folder.h"

namespace mixity::cli {
namespace killed_test {

/// Whether a stopped program is about to rename a file. False where the kernel does not say.
bool is_about_to_rename(pid_t child) {
  __ptrace_syscall_info info{};
  if (::ptrace(PTRACE_GET_SYSCALL_INFO, child, sizeof info, &info) <= 0) return false;
  return info.op == PTRACE_SYSCALL_INFO_ENTRY &&
         (info.entry.nr == SYS_rename || info.entry.nr == SYS_renameat || info.entry.nr == SYS_renameat2);
}

constexpr long kEndless = 1'000'000;
struct Calls {
  long all = 0, renames = 0;
};

/// Lets a program that begins with PTRACE_TRACEME run until it has entered or left so many system calls, or is about to
/// rename for so many a time. Returns how many it had when it stopped, or ended and was waited for.
Calls run_to(pid_t child, const Calls& most) {
  int status = 0, signal = 0;
  Calls calls;
  if (::waitpid(child, &status, 0) != child || !WIFSTOPPED(status)) return calls;
  // a stop at a system call is then told from others, and only such a stop says which call it is
  ::ptrace(PTRACE_SETOPTIONS, child, nullptr, PTRACE_O_TRACESYSGOOD);
  while (calls.all < most.all && calls.renames < most.renames &&
         ::ptrace(PTRACE_SYSCALL, child, nullptr, static_cast<long>(signal)) == 0) {
    if (::waitpid(child, &status, 0) != child || !WIFSTOPPED(status)) break;
    const bool at_call = WSTOPSIG(status) == (SIGTRAP | 0x80);
    signal = at_call || WSTOPSIG(status) == SIGTRAP ? 0 : WSTOPSIG(status);
    if (!at_call) continue;
    ++calls.all;
    calls.renames += is_about_to_rename(child);
  }
  return calls;
}

void be_traced() { ::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr); }

/// Overwrites an earlier result and is killed: at any moment, or at one of the system calls that write, which are its
/// last.
class Killed : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    ::setenv("TMPDIR", folder_.path().c_str(), 1);  // what a killed program leaves goes with the folder
    ::setenv("ASAN_OPTIONS", "detect_leaks=0", 1);  // which cannot be done to a program that is traced
  }
  void TearDown() override {
    ::unsetenv("TMPDIR");
    ::unsetenv("ASAN_OPTIONS");
  }

  Words words(const char* confidence) const {
    return {GetParam(), kDefinition, "--out", out_, std::string("--confidence=") + confidence};
  }

  void put_back(const Contents& contents) const {
    std::filesystem::remove_all(out_);
    for (const auto& [name, content] : contents) {
      std::filesystem::create_directories(std::filesystem::path(out_ + "/" + name).parent_path());
      folder_.write("out/" + name, content);
    }
  }

  const TemporaryFolder folder_;
  const std::string out_ = folder_.path("out"), err_ = folder_.path("err");
};

TEST_P(Killed, LeavesEachFileOldOrNewAndTheNextRunIsWhole) {
  ASSERT_EQ(run_program(words("0.9")).exit_code, 0);
  const Contents before = contents_of(out_);
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_EQ(run_program(words("0.95")).exit_code, 0);
  const auto whole_run =
      std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - begin).count();
  const Contents after = contents_of(out_);
  ASSERT_FALSE(before == after);

  // Where programs may not be traced, all are killed at any moment, of which few fall among the writes.
  const Calls calls = run_to(start(words("0.95"), err_, be_traced), {kEndless, kEndless});
  const bool traced = calls.all > 0;
  // system calls, roughly: the files are written, and at last all are renamed
  const std::size_t writing = 25 * after.size(), renaming = 2 * after.size() + 30;
  ASSERT_TRUE(!traced || calls.all > static_cast<long>(writing)) << calls.all;
  const int wanted_mixed = traced ? 3 : 0;
  std::mt19937 random(1);
  int killed = 0, mixed = 0;
  for (int run = 0; run < 400 && (killed < 40 || mixed < wanted_mixed); ++run) {  // some end before they are killed
    put_back(before);
    const bool anywhen = !traced || run % 2 == 0;
    const pid_t child = anywhen ? start(words("0.95"), err_) : start(words("0.95"), err_, be_traced);
    if (anywhen)
      std::this_thread::sleep_for(std::chrono::microseconds(random() % static_cast<std::uint64_t>(whole_run)));
    else
      run_to(child,
             run % 4 == 3 && calls.renames > 0
                 ? Calls{kEndless, 1 + static_cast<long>(random()) % calls.renames}
                 : Calls{calls.all - static_cast<long>(random() % (run % 4 == 1 ? writing : renaming)), kEndless});
    ::kill(child, SIGKILL);
    int status = 0;
    killed += ::waitpid(child, &status, 0) == child && WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;

    bool old_left = false, new_there = false;
    const Contents left = contents_of(out_);
    for (const auto& [name, content] : before) EXPECT_TRUE(left.contains(name)) << name << " is gone";
    for (const auto& [name, content] : left) {
      if (is_temporary(name)) continue;  // never mistaken for a result: no reader looks for such a name
      const bool is_old = before.contains(name) && content == before.at(name);
      const bool is_new = after.contains(name) && content == after.at(name);
      EXPECT_TRUE(is_old || is_new) << name << " is neither the old file nor the new one, run " << run;
      old_left |= is_old && !is_new;
      new_there |= is_new && !is_old;
    }
    mixed += old_left && new_there;
    // Whoever reads one of the files has the others of the same run.
    run_program({"check", out_ + "/fits.csv"});
    Contents read = contents_of(out_);
    std::erase_if(read, [](const auto& file) { return is_temporary(file.first); });
    EXPECT_TRUE(read == before || read == after) << "a reader finds files of two runs, run " << run;
  }
  EXPECT_GE(killed, 40);
  EXPECT_GE(mixed, wanted_mixed) << "too few runs were killed while they wrote: nothing was left to complete";

  ASSERT_EQ(run_program(words("0.95")).exit_code, 0);
  EXPECT_TRUE(contents_of(out_) == after) << "what killed runs left behind is still there";
}

TEST_P(Killed, WhoIsAskedToEndWhileFilesTakeTheirNamesLeavesOneRunOrTheOther) {
  ASSERT_EQ(run_program(words("0.9")).exit_code, 0);
  const Contents before = contents_of(out_);
  ASSERT_EQ(run_program(words("0.95")).exit_code, 0);
  const Contents after = contents_of(out_);
  const long calls = run_to(start(words("0.95"), err_, be_traced), {kEndless, kEndless}).all;
  if (calls == 0) return;  // programs may not be traced here
  int old_runs = 0, new_runs = 0;
  // From the end backwards, through the renames to the writing before them
  for (long back = 4; old_runs < 4 && back < calls; back += 3) {
    put_back(before);
    const pid_t child = start(words("0.95"), err_, be_traced);
    run_to(child, {calls - back, kEndless});
    ::ptrace(PTRACE_DETACH, child, nullptr, static_cast<long>(SIGTERM));
    int status = 0;
    ::waitpid(child, &status, 0);
    Contents left = contents_of(out_);
    std::erase_if(left, [](const auto& file) { return is_temporary(file.first); });
    old_runs += left == before;
    new_runs += left == after;
    EXPECT_TRUE(left == before || left == after) << "files of two runs, " << back << " calls before the end";
  }
  EXPECT_GT(old_runs, 0);
  EXPECT_GT(new_runs, 0);
}

INSTANTIATE_TEST_SUITE_P(OutputSafety, Killed, testing::Values("fit", "report"),
                         [](const auto& command) { return std::string(command.param); });

}  // namespace killed_test
}  // namespace mixity::cli
