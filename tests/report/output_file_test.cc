#include "report/output_file.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "dataset/csv.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace {

std::size_t files_in(const std::filesystem::path& folder) {
  std::size_t n = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder)) ++n;
  return n;
}

TEST(OutputFile, CreatesFoldersAndLeavesNoTemporaryName) {
  const TemporaryFolder folder;
  const std::string path = folder.path("a/b/file.csv");
  write_file(path, "1,2\n");
  EXPECT_EQ(read_file(path), "1,2\n");
  EXPECT_EQ(files_in(folder.path("a/b")), 1u);
}

TEST(OutputFile, ReplacesWhatWasThere) {
  const TemporaryFolder folder;
  const std::string path = folder.write("file", std::string(100000, 'x'));
  write_file(path, "short");
  EXPECT_EQ(read_file(path), "short");
}

TEST(OutputFile, RemovesWhatAKilledProcessLeftOfItAndNothingElse) {
  const TemporaryFolder folder;
  const pid_t gone = ::fork();
  if (gone == 0) ::_exit(0);
  ASSERT_EQ(::waitpid(gone, nullptr, 0), gone);
  folder.write("file.tmp" + std::to_string(gone), "half");
  const std::vector<std::string> kept{"file.tmp" + std::to_string(::getppid()), "file.tmpx", "file.tmp", "file.tmp1x",
                                      "other.tmp" + std::to_string(gone)};
  for (const std::string& name : kept) folder.write(name, "not ours");
  write_file(folder.path("file"), "whole");
  EXPECT_EQ(files_in(folder.path()), kept.size() + 1);
  for (const std::string& name : kept) EXPECT_EQ(read_file(folder.path(name)), "not ours") << name;
}

TEST(OutputFile, LeavesTheOldFileWhereTheNewOneCannotBeWritten) {
  EXPECT_THROW(write_file("/dev/null/file", "x"), OutputError);
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path("taken"));
  folder.write("taken/inside", "x");
  EXPECT_THROW(write_file(folder.path("taken"), "y"), OutputError);
  EXPECT_EQ(files_in(folder.path()), 1u);  // no temporary file remains
}

}  // namespace
}  // namespace mixity
