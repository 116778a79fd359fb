// What becomes of results when the disk is full, a folder is closed, or the program is killed half-way.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "cli/run_program.h"
#include "dataset/temporary_folder.h"

namespace mixity::cli {
namespace output_safety_test {

using Contents = std::map<std::string, std::string>;  // of a folder's files, by path within it

const std::string kDefinition = MIXITY_ROOT "/fits/as4_peek_mmb.toml";

Contents contents_of(const std::string& folder) {
  Contents contents;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      contents[std::filesystem::relative(entry.path(), folder).string()] = content_of(entry.path().string());
  return contents;
}

bool is_temporary(const std::string& name) { return name.find(".mixity-tmp") != std::string::npos; }

/// A child that runs the program after `prepare`, its complaints in the file `err`; its output goes nowhere.
pid_t start(
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

ProgramResult finish(pid_t child, const std::string& err) {
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), "", content_of(err)};
}

void redirect_output(const char* path) { ::dup2(::open(path, O_WRONLY), STDOUT_FILENO); }

TEST(OutputSafety, AFullDiskBehindStandardOutputEndsWithFour) {
  const TemporaryFolder folder;
  const std::string err = folder.path("err");
  const std::string plot = folder.write("plot.csv", "run 1,\nX,Y\n0,19.6\n5,19.2\n");
  const std::string not_ok = folder.write("one.csv", "P,T,A\n1,0,19.6\n");  // by itself the fit would end with 1
  for (const Words& words : std::vector<Words>{
           {},
           {"fit", not_ok},
           {"fit", kDefinition},
           {"fit", kDefinition, "--format=json"},
           {"fit", kDefinition, "--format=csv"},
           {"check", MIXITY_ROOT "/data/mergel2018.csv"},
           {"sahli", MIXITY_ROOT "/data/mergel2018.csv"},
           {"import", plot, "--x=T", "--y=A", "--loads=1"},
           {"predict", "--model=c", "--lambda=0.1", "--load=1", "--shear=0,1"},
           {"curve", "--model=c", "--lambda=0.1", "--load=1"},
           {"instability", "--model=c", "--lambda=0.1", "--load=1"},
           {"help"},
           {"--version"},
       }) {
    const ProgramResult result = finish(start(words, err, [] { redirect_output("/dev/full"); }), err);
    EXPECT_EQ(result.exit_code, 4) << joined(words);
    EXPECT_EQ(result.complaint(), "mixity: standard output cannot be written") << joined(words);
  }
}

TEST(OutputSafety, AFolderForTemporaryFilesThatIsNoneEndsWithFour) {
  const TemporaryFolder folder;
  const std::string err = folder.path("err");
  const Words words{"figures", "--paper", "--formats=pdf", "--out", folder.path("out")};
  const ProgramResult result = finish(start(words, err, [] { ::setenv("TMPDIR", "/nonexistent", 1); }), err);
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_EQ(result.complaint(), "mixity: TMPDIR names no folder for temporary files: No such file or directory");
}

/// As on a full disk, a file can only be written in part: beyond this size, write() fails.
void limit_files() {
  const rlimit limit{600, 600};
  ::setrlimit(RLIMIT_FSIZE, &limit);
}

TEST(OutputSafety, AFileThatDoesNotFitLeavesTheEarlierResults) {
  const TemporaryFolder folder;
  const std::string err = folder.path("err"), out = folder.path("out");
  for (const Words& words : std::vector<Words>{{"fit", kDefinition, "--out", out},
                                               {"report", kDefinition, "--out", out},
                                               {"figures", "--paper", "--out", out}}) {
    std::filesystem::remove_all(out);
    ASSERT_EQ(run_program(words).exit_code, 0) << joined(words);
    const Contents before = contents_of(out);
    const ProgramResult result = finish(start(words, err, limit_files), err);
    EXPECT_EQ(result.exit_code, 4) << joined(words);
    EXPECT_NE(result.complaint().find(": cannot be written: File too large"), std::string::npos) << result.err;
    EXPECT_TRUE(contents_of(out) == before) << joined(words);
  }
}

TEST(OutputSafety, FilesOfLawsAndHeadingsAreNotWrittenOver) {
  const TemporaryFolder folder;
  const std::string law = "[mine]\nf = \"1 + (1-l)*tan(psi)^2\"\nl = [0, 1]\n", laws = folder.write("laws.toml", law);
  const std::string name = "[T]\nnames = [\"Querkraft\"]\n", headings = folder.write("headings.toml", name);
  for (const Words& words : std::vector<Words>{
           {"fit", MIXITY_ROOT "/data/mergel2018.csv", "--models=c", "--laws", laws, "--save", laws},
           {"fit", MIXITY_ROOT "/data/mergel2018.csv", "--models=c", "--headings", headings, "--save", headings},
           {"simulate", "--model=c", "--lambda=0.1", "--loads=1mN", "--radius=9mm", "--modulus=2MPa",
            "--toughness=30mJ/m^2", "--laws", laws, "--out", folder.path("laws.csv")}}) {
    const ProgramResult result = run_program(words);
    EXPECT_NE(result.exit_code, 0) << joined(words);
    EXPECT_NE(result.complaint().find("is an input and is not written over"), std::string::npos) << result.err;
  }
  EXPECT_EQ(content_of(laws), law);
  EXPECT_EQ(content_of(headings), name);
}

/// Results of one run and the definition that another run saved do not stand side by side.
TEST(OutputSafety, ResultsAndTheSavedDefinitionAreWrittenTogether) {
  const TemporaryFolder folder;
  const std::string saved = folder.write("fit.toml", "old"), out = folder.write("out", "a file, no folder");
  EXPECT_EQ(
      run_program({"fit", MIXITY_ROOT "/data/mergel2018.csv", "--models=c", "--out", out, "--save", saved}).exit_code,
      4);
  EXPECT_EQ(content_of(saved), "old");
}

TEST(OutputSafety, AnImportThatDoesNotFitLeavesTheEarlierOne) {
  const TemporaryFolder folder;
  std::string plot = "run 1,\nX,Y\n";
  for (int i = 0; i < 200; ++i) plot += std::to_string(i) + ",19.6\n";
  const std::string err = folder.path("err"), data = folder.write("data.csv", "mine");
  const Words words{"import", folder.write("plot.csv", plot), "--x=T", "--y=A", "--loads=1", "--out", data};
  EXPECT_EQ(finish(start(words, err, limit_files), err).exit_code, 4);
  EXPECT_EQ(content_of(data), "mine");
}

/// As a user without rights, whoever runs the test.
void become_nobody() {
  if (::geteuid() == 0 && (::setgid(65534) != 0 || ::setuid(65534) != 0)) ::_exit(126);
}

TEST(OutputSafety, AFolderOrFileThatIsClosedToWritingEndsWithFourAndKeepsWhatItHolds) {
  const TemporaryFolder folder, complaints;
  // Program and data are copied to where nobody may read them: the build may lie in a private folder.
  const std::string out = folder.path("out"), err = complaints.write("err", ""), program = folder.path("mixity"),
                    data = folder.path("run.csv");
  std::filesystem::copy_file(MIXITY_PROGRAM, program);
  std::filesystem::copy_file(MIXITY_ROOT "/data/mergel2018.csv", data);
  std::filesystem::copy_file(MIXITY_ROOT "/data/mergel2018.toml", folder.path("run.toml"));
  for (const std::string& path : {folder.path(), complaints.path(), err})
    std::filesystem::permissions(path, std::filesystem::perms::all);
  ASSERT_EQ(run_program({"fit", data, "--out", out}).exit_code, 0);
  const ProgramResult allowed = finish(start({"check", data}, err, become_nobody, program), err);
  ASSERT_EQ(allowed.exit_code, 0) << allowed.err;
  const Contents before = contents_of(out);
  const auto refuses = [&](const char* command) {
    const ProgramResult result = finish(start({command, data, "--out", out}, err, become_nobody, program), err);
    EXPECT_EQ(result.exit_code, 4) << command;
    EXPECT_NE(result.complaint().find("Permission denied"), std::string::npos) << result.err;
    EXPECT_TRUE(contents_of(out) == before) << command;
  };
  std::filesystem::permissions(out, std::filesystem::perms(0555));
  refuses("fit");
  refuses("report");
  std::filesystem::permissions(out, std::filesystem::perms::all);
  for (const auto& file : std::filesystem::directory_iterator(out))
    std::filesystem::permissions(file.path(), std::filesystem::perms(0444));
  refuses("fit");
}

TEST(OutputSafety, AFileThatWasReadIsNotWrittenOver) {
  const TemporaryFolder folder;
  const std::string& here = folder.path();
  const auto refuses = [&](const Words& words, const std::string& data) {
    const Contents before = contents_of(here);
    const ProgramResult result = run_program(words);
    EXPECT_EQ(result.exit_code, 4) << words[0];
    EXPECT_NE(result.complaint().find(data + ": is an input and is not written over"), std::string::npos) << result.err;
    EXPECT_TRUE(contents_of(here) == before) << words[0];
  };
  const std::string data = "P,T,A\n1,0,20\n1,3,19\n1,5,17\n";
  refuses({"fit", folder.write("fits.csv", data), "--out", here}, "fits.csv");
  refuses({"report", folder.write("curves.csv", data), "--out", here}, "curves.csv");
  std::filesystem::create_directory(folder.path("figures"));
  refuses({"report", folder.write("d.csv", data), folder.write("figures/d_toughness.dat", data), "--formats=gnuplot",
           "--out", here},
          "d_toughness.dat");
  const std::string plot = folder.write("plot.csv", "a,\nX,Y\n1,2\n");
  std::filesystem::create_symlink(plot, folder.path("link.csv"));
  refuses({"import", plot, "--x=T", "--y=A", "--loads=1", "--out", folder.path("link.csv")}, "link.csv");
}

TEST(OutputSafety, NoFileThatADefinitionNamesIsWrittenOver) {
  const TemporaryFolder folder;
  const std::string &here = folder.path(),
                    constants = "radius = \"9 mm\"\nmodulus = \"2 MPa\"\ntoughness = \"27 mJ/m^2\"\n";
  folder.write("g.csv", "P,T,A\n1,0,20\n1,3,19\n1,5,17\n");
  folder.write("g.toml", constants);
  folder.write("g_residuals.csv", "P [mN],T_max [mN]\n1,2\n");
  const std::string definition =
      folder.write("fit.toml", "data = \"g.csv\"\nmodels = [\"c\"]\npeaks = \"g_residuals.csv\"\n");
  const auto refuses = [&](const std::string& name) {
    const ProgramResult result = run_program({"fit", definition, "--out", here});
    EXPECT_EQ(result.exit_code, 4);
    EXPECT_NE(result.complaint().find(name + ": is an input and is not written over"), std::string::npos) << result.err;
  };
  refuses("g_residuals.csv");
  folder.write("fit.toml", "data = \"g.csv\"\nmodels = [\"c\"]\n");
  for (const std::string target : {"g.toml", "fit.toml"}) {
    const std::string link = folder.path("fits.txt");
    std::filesystem::remove(link);
    std::filesystem::create_symlink(folder.path(target), link);
    refuses("fits.txt");
  }
  EXPECT_EQ(content_of(folder.path("g.toml")), constants);
}

TEST(OutputSafety, AFileWhereAFolderIsWantedStaysAsItIs) {
  const TemporaryFolder folder;
  const std::string file = folder.write("out", "mine");
  for (const char* command : {"fit", "report"}) {
    const ProgramResult result = run_program({command, kDefinition, "--out", file});
    EXPECT_EQ(result.exit_code, 4) << command;
    EXPECT_NE(result.complaint().find(file), std::string::npos) << result.complaint();
    EXPECT_EQ(content_of(file), "mine");
  }
}

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
  }
  EXPECT_GE(killed, 40);
  EXPECT_GE(mixed, wanted_mixed) << "too few runs were killed while they wrote";

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

}  // namespace output_safety_test
}  // namespace mixity::cli
