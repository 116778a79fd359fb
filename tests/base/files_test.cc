#include "base/files.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "dataset/temporary_folder.h"

namespace mixity {
namespace files_test {

/// Without the record of what was written.
std::size_t files_in(const std::filesystem::path& folder) {
  std::size_t n = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) n += entry.path().filename() != ".mixity-files";
  return n;
}

const OutputRules kForce{{}, true, {}};

void write_file(const std::string& path, const std::string& content) { write_files({{path, content}}, kForce); }

TEST(OutputFile, APlainNameIsNothingElseToAnyone) {
  EXPECT_EQ(plain_file_name("mergel2018"), "mergel2018");
  EXPECT_EQ(plain_file_name("Probe 3 (µm).v-2"), "Probe 3 (µm).v-2");
  EXPECT_EQ(plain_file_name("`touch x`"), "_touch x_");
  EXPECT_EQ(plain_file_name("<a>|b;$c\"'\\/\n%@#*?!&~"), "_a__b__c" + std::string(13, '_'));
  for (const char* first : {"-a", ".a", " a", "=a", "|a"}) EXPECT_EQ(plain_file_name(first), "_a") << first;
  EXPECT_EQ(plain_file_name("a\xff"), "a_");
}

TEST(OutputFile, ANameWithoutAFolderIsOneHere) {
  const TemporaryFolder folder;
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  EXPECT_NO_THROW(write_file("new.csv", "1,2\n"));
  std::filesystem::current_path(before);
  EXPECT_EQ(read_file(folder.path("new.csv")), "1,2\n");
}

TEST(OutputFile, ADeviceThatIsFullLeavesTheOthersAsTheyWere) {
  const TemporaryFolder folder;
  const std::string first = folder.write("first", "old");
  EXPECT_THROW(write_files({{first, "new"}, {"/dev/full", "new"}}, kForce), OutputError);
  EXPECT_EQ(read_file(first), "old");
  EXPECT_EQ(files_in(folder.path()), 1u);
}

TEST(OutputFile, ATomlThatSomebodyMayHaveEditedIsKept) {
  const TemporaryFolder folder;
  const std::string edited = folder.write("runs.toml", "modulus = \"2.1 MPa +/- 5%\"\n");
  folder.write("runs.csv", "old\n");
  std::vector<OutputFile> files{{edited, "modulus = \"2.1 MPa\"\n"}, {folder.path("runs.csv"), "new\n"}};
  EXPECT_EQ(keep_former(files), std::vector<std::string>{edited + ".old"});
  write_files(files, kForce);
  EXPECT_EQ(read_file(edited + ".old"), "modulus = \"2.1 MPa +/- 5%\"\n");
  EXPECT_EQ(read_file(edited), "modulus = \"2.1 MPa\"\n");
  files.resize(2);
  EXPECT_TRUE(keep_former(files).empty());  // as it is to be
  // a second edit leaves the first where it is
  folder.write("runs.toml", "modulus = \"2.2 MPa\"\n");
  EXPECT_EQ(keep_former(files), std::vector<std::string>{edited + ".old.2"});
  write_files(files);
  EXPECT_EQ(read_file(edited + ".old"), "modulus = \"2.1 MPa +/- 5%\"\n");
  EXPECT_EQ(read_file(edited + ".old.2"), "modulus = \"2.2 MPa\"\n");
}

TEST(OutputFile, KeepsItsPermissions) {
  const TemporaryFolder folder;
  const std::string file = folder.write("private", "old");
  std::filesystem::permissions(file, std::filesystem::perms(0600));
  write_file(file, "new");
  EXPECT_EQ(std::filesystem::status(file).permissions(), std::filesystem::perms(0600));
}

TEST(OutputFile, ALinkStaysALinkAndADeviceADevice) {
  const TemporaryFolder folder;
  const std::string target = folder.write("target", "old"), link = folder.path("link"), pipe = folder.path("pipe");
  std::filesystem::create_symlink(target, link);
  write_file(link, "new");
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ(read_file(target), "new");
  write_file("/dev/null", "new");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  EXPECT_THROW(write_file("/dev/full", "new"), OutputError);
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  write_file(pipe, "new");
  char text[8];
  EXPECT_EQ(::read(reader, text, sizeof text), 3);
  ::close(reader);
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
}

TEST(OutputFile, ALinkToWhatIsNotThereYetStaysOne) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path("out"));
  const auto link = [&](const std::string& target, const std::string& name) {
    std::filesystem::create_symlink(target, folder.path("out/" + name));
    return folder.path("out/" + name);
  };
  write_files({{link("../new.csv", "relative.csv"), "1"},
               {link(folder.path("other/new.csv"), "absolute.csv"), "2"},
               {link("../third.csv", "one.csv"), "3"}});
  EXPECT_EQ(read_file(folder.path("new.csv")), "1");
  EXPECT_EQ(read_file(folder.path("other/new.csv")), "2");
  EXPECT_EQ(read_file(folder.path("third.csv")), "3");
  for (const char* name : {"relative.csv", "absolute.csv", "one.csv"})
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path(std::string("out/") + name))) << name;
  const std::string circle = link("circle.csv", "circle.csv");
  EXPECT_THROW(write_file(circle, "4"), OutputError);
  EXPECT_TRUE(std::filesystem::is_symlink(circle));
}

TEST(OutputFile, TwoThatLeadToOneAreRefusedBeforeAnyIsWritten) {
  const TemporaryFolder folder;
  const std::string first = folder.write("first", "old"), target = folder.write("target", "old"),
                    link = folder.path("link"), other = folder.path("other");
  std::filesystem::create_symlink("target", link);
  std::filesystem::create_symlink("link", other);
  try {
    write_files({{first, "new"}, {link, "new"}, {other, "newer"}}, kForce);
    FAIL();
  } catch (const OutputError& error) {
    EXPECT_EQ(error.what(), other + ": leads to the same file as " + link);
  }
  EXPECT_THROW(write_files({{target, "new"}, {link, "new"}}, kForce), OutputError);
  EXPECT_THROW(write_files({{first, "new"}, {folder.path("./first"), "new"}}, kForce), OutputError);
  EXPECT_EQ(read_file(first), "old");
  EXPECT_EQ(read_file(target), "old");
  EXPECT_NO_THROW(write_files({{"/dev/null", "new"}, {"/dev/null", "new"}}));
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

TEST(OutputFile, RemovesWhatKilledProgramsLeftInItsFolderAndNothingElse) {
  const TemporaryFolder folder;
  folder.write("file.mixity-tmpabcdefgh", "half");
  folder.write("figure of another run.svg.mixity-tmpabcdefgh", "half");
  const std::vector<std::string> kept{"file.mixity-tmpx", "file.mixity-tmp",          "file.mixity-tmpabcdefg1",
                                      "file.tmpabcdefgh", "file.mixity-tmpabcdefghi", ".mixity-tmpabcdefgh"};
  for (const std::string& name : kept) folder.write(name, "not ours");
  write_file(folder.path("file"), "whole");
  EXPECT_EQ(files_in(folder.path()), kept.size() + 1);
  for (const std::string& name : kept) EXPECT_EQ(read_file(folder.path(name)), "not ours") << name;
}

/// Whoever comes second waits, also from another container, where it may have the same process number.
TEST(OutputFile, OfTwoProgramsAreOfOneOfThem) {
  const TemporaryFolder folder;
  constexpr int kWriters = 6, kTimes = 30, kFiles = 4;
  std::vector<pid_t> writers;
  for (int writer = 0; writer < kWriters; ++writer) {
    writers.push_back(::fork());
    if (writers.back() != 0) continue;
    int code = 0;
    try {
      for (int time = 0; time < kTimes; ++time) {
        std::vector<OutputFile> files;
        for (int i = 0; i < kFiles; ++i)
          files.push_back(
              {folder.path("file" + std::to_string(i)), std::to_string(writer) + " " + std::to_string(time)});
        write_files(files);
      }
    } catch (const OutputError&) {
      code = 1;
    }
    ::_exit(code);
  }
  for (const pid_t writer : writers) {
    int ended = 0;
    ASSERT_EQ(::waitpid(writer, &ended, 0), writer);
    EXPECT_EQ(ended, 0);
  }
  EXPECT_EQ(files_in(folder.path()), std::size_t{kFiles});
  for (int i = 1; i < kFiles; ++i)
    EXPECT_EQ(read_file(folder.path("file" + std::to_string(i))), read_file(folder.path("file0")));
}

/// Another program holds the folder: its lock ends with it.
TEST(OutputFile, WaitsForWhoeverHoldsTheFolder) {
  const TemporaryFolder folder;
  const int held = ::open(folder.path().c_str(), O_RDONLY | O_DIRECTORY);
  ASSERT_EQ(::flock(held, LOCK_EX), 0);
  std::atomic<bool> written = false;
  std::thread other([&] {
    write_file(folder.path("file"), "x");
    written = true;
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  EXPECT_FALSE(written);
  EXPECT_EQ(files_in(folder.path()), 0u);
  ::close(held);
  other.join();
  EXPECT_EQ(read_file(folder.path("file")), "x");
}

TEST(OutputFile, LeavesTheOldFileWhereTheNewOneCannotBeWritten) {
  EXPECT_THROW(write_file("/dev/null/file", "x"), OutputError);
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path("taken"));
  folder.write("taken/inside", "x");
  EXPECT_THROW(write_file(folder.path("taken"), "y"), OutputError);
  EXPECT_EQ(files_in(folder.path()), 1u);  // no temporary file remains
}

/// A run that cannot write one of its files must not leave a mixture of two runs.
TEST(OutputFile, OfSeveralAllAreOldOrAllAreNew) {
  const TemporaryFolder folder;
  folder.write("one", "old");
  std::filesystem::create_directory(folder.path("three"));
  const std::vector<OutputFile> files{
      {folder.path("one"), "new"}, {folder.path("two"), "new"}, {folder.path("three"), "new"}};
  EXPECT_THROW(write_files(files, kForce), OutputError);
  EXPECT_EQ(read_file(folder.path("one")), "old");
  EXPECT_EQ(files_in(folder.path()), 2u);
  std::filesystem::remove(folder.path("three"));
  write_files(files, kForce);
  for (const char* name : {"one", "two", "three"}) EXPECT_EQ(read_file(folder.path(name)), "new");
}

TEST(OutputFile, OfARunThatIsRefusedOrFailsLeavesNoNewFolder) {
  const TemporaryFolder folder;
  const std::string theirs = folder.write("report.html", "of somebody else");
  const std::string figure = folder.path("figures/one/curve.svg");
  EXPECT_THROW(write_files({{figure, "new"}, {theirs, "new"}}), OutputError);  // refused
  EXPECT_FALSE(std::filesystem::exists(folder.path("figures")));
  EXPECT_THROW(write_files({{figure, "new"}, {"/dev/full", "new"}}, kForce), OutputError);  // fails
  EXPECT_FALSE(std::filesystem::exists(folder.path("figures")));
  std::filesystem::create_directory(folder.path("figures"));  // this one is the user's
  EXPECT_THROW(write_files({{figure, "new"}, {theirs, "new"}}), OutputError);
  EXPECT_TRUE(std::filesystem::exists(folder.path("figures")));
  EXPECT_FALSE(std::filesystem::exists(folder.path("figures/one")));
  write_file(figure, "new");
  EXPECT_EQ(read_file(figure), "new");
}

TEST(OutputFile, IsNeverOneOfTheInputs) {
  const TemporaryFolder folder;
  const std::string input = folder.write("data", "1");
  std::filesystem::create_symlink(input, folder.path("link"));
  for (const char* name : {"data", "link", "./data"}) {
    EXPECT_THROW(write_files({{folder.path("other"), "2"}, {folder.path(name), "2"}}, {{input}, true, {}}), OutputError)
        << name;
    EXPECT_EQ(read_file(input), "1");
    EXPECT_EQ(files_in(folder.path()), 2u);
  }
}

TEST(NamedTwice, IsAFileUnderAnyOfItsNames) {
  const TemporaryFolder folder;
  const std::string one = folder.write("one", "1"), two = folder.write("two", "2"), link = folder.path("link");
  std::filesystem::create_symlink(one, link);
  EXPECT_EQ(named_twice({one, two}), std::nullopt);
  EXPECT_EQ(named_twice({one, two, link}), link);
  EXPECT_EQ(named_twice({one, folder.path("./one")}), folder.path("./one"));
  EXPECT_EQ(named_twice({"missing", two, "missing"}), "missing");
}

}  // namespace files_test
}  // namespace mixity
