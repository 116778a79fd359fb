#include "base/unfinished_run.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "base/content_hash.h"
#include "base/files.h"
#include "base/input_error.h"
#include "base/inputs.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace unfinished_run_test {

/// A run that was killed between its renames: of results in `out`, a figure in `out/figures` and a definition
/// elsewhere.
class UnfinishedRun : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : {"out/figures", "saved"}) std::filesystem::create_directories(folder_.path(name));
    for (const char* name : {"out/fits.csv", "saved/fit.toml", "out/figures/old.svg"}) folder_.write(name, "old");
    for (const char* name : {"out/fits.csv", "saved/fit.toml", "out/figures/new.svg"})
      folder_.write(name + std::string(kTemporary), "new");
    const std::string old = content_hash("old");
    const auto temporary = [](const char* name) { return name + std::string(kTemporary); };
    changes_ = {{folder_.path("saved"), {{temporary("fit.toml"), old}}, {}},
                {folder_.path("out"), {{temporary("fits.csv"), old}}, {}},
                {folder_.path("out/figures"), {{temporary("new.svg"), ""}}, {{"old.svg", old}}}};
  }
  void announce(std::size_t from) {
    const std::vector<OutputFile> files = unfinished_files(changes_);
    for (std::size_t i = from; i < files.size(); ++i) write_scratch_file(files[i].path, files[i].content);
  }
  std::string content(const std::string& name) const {
    return Inputs().exists(folder_.path(name)) ? read_file(folder_.path(name)) : "none";
  }
  /// Without reading, which would complete the run.
  bool exists(const std::string& name) const { return std::filesystem::exists(folder_.path(name)); }
  std::size_t files() const {
    std::size_t n = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.path()))
      n += entry.is_regular_file();
    return n;
  }

  static constexpr const char* kTemporary = ".mixity-tmpabcdefgh";
  const TemporaryFolder folder_;
  std::vector<FolderChanges> changes_;
};

TEST_F(UnfinishedRun, IsCompletedInAllItsFoldersByAReaderOfOne) {
  for (const char* read : {"saved/fit.toml", "out/fits.csv", "out/figures/new.svg"}) {
    SetUp();
    announce(0);
    EXPECT_EQ(content(read), "new");
    for (const char* name : {"saved/fit.toml", "out/fits.csv", "out/figures/new.svg"}) EXPECT_EQ(content(name), "new");
    EXPECT_EQ(files(), 3u) << "what is outdated or hidden is still there";
  }
}

TEST_F(UnfinishedRun, IsCompletedFromAnyOfItsSteps) {
  announce(0);
  std::filesystem::rename(folder_.path(std::string("saved/fit.toml") + kTemporary), folder_.path("saved/fit.toml"));
  std::filesystem::remove(folder_.path("out/figures/old.svg"));
  std::filesystem::remove(folder_.path("out/.mixity-unfinished"));
  std::filesystem::rename(folder_.path(std::string("out/fits.csv") + kTemporary), folder_.path("out/fits.csv"));
  EXPECT_EQ(content("out/figures/new.svg"), "new");
  EXPECT_EQ(files(), 3u);
  EXPECT_FALSE(has_unfinished_run(folder_.path("saved")));
}

TEST_F(UnfinishedRun, IsCompletedAfterItsFoldersWereMoved) {
  announce(0);
  const std::string moved = folder_.path("moved");
  std::filesystem::create_directory(moved);
  for (const char* name : {"out", "saved"}) std::filesystem::rename(folder_.path(name), moved + "/" + name);
  EXPECT_EQ(content("moved/out/fits.csv"), "new");
  EXPECT_EQ(content("moved/saved/fit.toml"), "new");
}

TEST_F(UnfinishedRun, HasDoneNothingBeforeItsFirstHiddenFileIsThere) {
  announce(1);
  for (const char* name : {"out/fits.csv", "saved/fit.toml", "out/figures/old.svg"}) EXPECT_EQ(content(name), "old");
  EXPECT_FALSE(exists("out/figures/new.svg"));
  for (const char* name : {"out", "out/figures"}) EXPECT_FALSE(has_unfinished_run(folder_.path(name)));
}

TEST_F(UnfinishedRun, IsCompletedByTheNextWriter) {
  announce(0);
  write_files({{folder_.path("out/other.csv"), "1"}});
  EXPECT_EQ(content("out/fits.csv"), "new");
  EXPECT_EQ(content("saved/fit.toml"), "new");
}

TEST_F(UnfinishedRun, LeavesWhatWasEditedSince) {
  announce(0);
  folder_.write("out/fits.csv", "edited");
  folder_.write("out/figures/old.svg", "edited");
  folder_.write("out/figures/new.svg", "theirs");
  EXPECT_EQ(content("saved/fit.toml"), "new");
  EXPECT_EQ(content("out/fits.csv"), "edited");
  EXPECT_EQ(content("out/figures/old.svg"), "edited");
  EXPECT_EQ(content("out/figures/new.svg"), "theirs");
  EXPECT_EQ(files(), 4u);
}

/// A folder from somebody else changes nothing outside itself.
TEST_F(UnfinishedRun, ChangesNoFolderThatDoesNotNameIt) {
  const std::string old = content_hash("old");
  folder_.write("out/.mixity-unfinished", "run x\nfirst .\nwith ../saved\nrename " + old + " ../saved/fit.toml" +
                                              kTemporary + "\nremove " + old + " ../saved/fit.toml\n");
  EXPECT_EQ(content("out/fits.csv"), "old");
  EXPECT_EQ(content("saved/fit.toml"), "old");
  EXPECT_TRUE(exists(std::string("saved/fit.toml") + kTemporary));
  folder_.write("out/.mixity-unfinished", "run x\nfirst .\nwith ../saved\n");
  folder_.write("saved/.mixity-unfinished", "run y\nfirst .\nremove " + old + " fit.toml\n");
  EXPECT_EQ(content("out/fits.csv"), "old");
  EXPECT_TRUE(exists("saved/fit.toml"));
  std::filesystem::remove(folder_.path("saved/.mixity-unfinished"));
  std::filesystem::create_symlink(folder_.path("saved/fit.toml"), folder_.path("out/.mixity-unfinished"));
  write_files({{folder_.path("out/other.csv"), "1"}});
  EXPECT_EQ(content("saved/fit.toml"), "old");
}

TEST_F(UnfinishedRun, IsNoneWhereHiddenFilesAreNot) {
  for (const char* text : {"", "run", "first", "first .\nrun x\nrename", "rename - a\nremove -\nwith \n", "\n\n\x01"}) {
    folder_.write("out/.mixity-unfinished", text);
    EXPECT_EQ(content("out/fits.csv"), "old") << text;
    EXPECT_FALSE(has_unfinished_run(folder_.path("out"))) << text;
  }
}

TEST_F(UnfinishedRun, OfFoldersThatAreNotThereEndsWhereItIs) {
  announce(0);
  std::filesystem::remove_all(folder_.path("out"));
  EXPECT_EQ(content("saved/fit.toml"), "new");
  folder_.write("saved/.mixity-unfinished", "run x\nfirst .\nwith /nowhere\nwith /proc/1\n");
  write_files({{folder_.path("saved/other.csv"), "1"}});
  EXPECT_FALSE(has_unfinished_run(folder_.path("saved")));
}

TEST_F(UnfinishedRun, IsNoFolder) {
  const std::string hidden = folder_.path("out/.mixity-unfinished");
  std::filesystem::create_directory(hidden);
  for (const bool reads : {true, false}) {
    try {
      reads ? void(read_file(folder_.path("out/fits.csv"))) : write_files({{folder_.path("out/other.csv"), "1"}});
      FAIL();
    } catch (const OutputError& error) {
      EXPECT_EQ(error.what(), std::filesystem::canonical(hidden).string() +
                                  ": is no file, as that of a run that was killed is: remove it");
    }
  }
}

TEST_F(UnfinishedRun, HasANameThatNoOutputHas) {
  for (const char* name : {".mixity-unfinished", ".mixity-files"})
    EXPECT_THROW(write_files({{folder_.path(name), "1"}}, {{}, true, {}}), OutputError);
}

/// As a user without rights, whoever runs the test.
TEST_F(UnfinishedRun, IsNamedToWhoMayNotCompleteIt) {
  announce(0);
  for (const char* name : {"", "out", "out/figures", "saved"})
    std::filesystem::permissions(folder_.path(name), std::filesystem::perms(0555));
  const pid_t child = ::fork();
  if (child == 0) {
    if (::geteuid() == 0 && (::setgid(65534) != 0 || ::setuid(65534) != 0)) ::_exit(126);
    try {
      read_file(folder_.path("out/fits.csv"));
    } catch (const OutputError& error) {
      ::_exit(std::string(error.what()).find("cannot be completed: Permission denied") != std::string::npos ? 1 : 2);
    }
    ::_exit(0);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(WEXITSTATUS(status), 1);
  for (const char* name : {"", "out", "out/figures", "saved"})
    std::filesystem::permissions(folder_.path(name), std::filesystem::perms(0755));
}

/// Each writes to both folders, in another order: neither waits for the other for ever.
TEST(TwoWriters, OfTwoFoldersDoNotWaitForEachOther) {
  const TemporaryFolder folder;
  const auto began = std::chrono::steady_clock::now();
  std::vector<pid_t> writers;
  for (const bool forwards : {true, false}) {
    writers.push_back(::fork());
    if (writers.back() != 0) continue;
    for (int i = 0; i < 40; ++i) {
      std::vector<OutputFile> files{{folder.path("a/one"), std::to_string(i)},
                                    {folder.path("b/two"), std::to_string(i)}};
      if (!forwards) std::swap(files[0], files[1]);
      write_files(files);
    }
    ::_exit(0);
  }
  for (const pid_t writer : writers) {
    int ended = 0;
    ASSERT_EQ(::waitpid(writer, &ended, 0), writer);
    EXPECT_EQ(ended, 0);
  }
  // Whoever waits for a lock that is not given up ends after a minute.
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(50));
}

/// What this program reads while it remembers is not written over; what it only compares is.
TEST(FilesRemembered, AreNotWrittenOver) {
  const TemporaryFolder folder;
  const std::string read = folder.write("read.toml", "1"), compared = folder.path("compared.toml");
  const pid_t child = ::fork();  // remembering has no end
  if (child == 0) {
    remember_files_read();
    read_file(read);
    write_files({{compared, "1"}});
    std::vector<OutputFile> files{{compared, "2"}};
    keep_former(files);
    write_files(files);
    try {
      write_files({{read, "2"}}, {{}, true, {}});
    } catch (const OutputError& error) {
      ::_exit(error.what() == read + ": is an input and is not written over" ? 0 : 2);
    }
    ::_exit(1);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_EQ(read_file(compared), "2");
}

}  // namespace unfinished_run_test
}  // namespace mixity
