#include "base/inputs.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <thread>

#include "base/input_error.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace inputs_test {

template <class Body>
std::string error_of(const Body& body) {
  try {
    body();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(Inputs, HoldWhatWasReadWhateverHappensToTheFile) {
  const TemporaryFolder folder;
  const std::string path = folder.write("data.csv", "P,T,A\n");
  Inputs inputs;
  EXPECT_EQ(inputs.read(path), "P,T,A\n");
  folder.write("data.csv", "shorter");
  ASSERT_EQ(inputs.files().size(), 1u);
  const InputFile& file = inputs.files()[0];
  EXPECT_EQ(file.path, path);
  EXPECT_EQ(file.bytes, 6u);
  EXPECT_EQ(file.hash, content_hash("P,T,A\n"));
  EXPECT_EQ(content_of(file), "P,T,A\n");
}

/// As the names of columns that the files of one data set share.
TEST(Inputs, AreReadOnceEach) {
  const TemporaryFolder folder;
  const std::string path = folder.write("headings.toml", "first");
  Inputs inputs;
  EXPECT_EQ(inputs.read(path), "first");
  folder.write("headings.toml", "second");
  EXPECT_EQ(inputs.read(path), "first");
  EXPECT_EQ(inputs.files().size(), 1u);
}

TEST(Inputs, ThatAreGivenAreNotReadFromDisk) {
  const TemporaryFolder folder;
  const std::string path = folder.write("data.csv", "on disk"), other = folder.write("other.csv", "1");
  Inputs inputs({{path, 0, {}, std::make_shared<const std::string>("given")}});
  EXPECT_TRUE(inputs.exists(path));
  EXPECT_FALSE(inputs.exists(other));
  EXPECT_EQ(inputs.read(path), "given");
  EXPECT_EQ(inputs.files()[0].hash, content_hash("given"));
  EXPECT_EQ(error_of([&] { inputs.read(other); }), other + ": is not among the files that were read before");
}

TEST(Inputs, ThatAreGivenMayStandBesideFilesOnDisk) {
  const TemporaryFolder folder;
  const std::string here = folder.write("a.toml", "radius"), made = folder.write("a.mat", "binary");
  Inputs inputs({{made, 0, {}, std::make_shared<const std::string>("P,T,A\n")}}, Inputs::Others::from_disk);
  EXPECT_TRUE(inputs.exists(here) && inputs.exists(made));
  EXPECT_FALSE(inputs.exists(folder.path("none")));
  EXPECT_EQ(inputs.read(made), "P,T,A\n");
  EXPECT_EQ(inputs.read(here), "radius");
}

TEST(InputStream, NoticesAFileThatIsCutOrGrowsWhileItIsRead) {
  const TemporaryFolder folder;
  const std::string whole(100000, 'x');
  for (const std::string& later : {std::string(60000, 'x'), whole + "more", std::string(100000, 'y')}) {
    const std::string path = folder.write("data.csv", whole);
    Inputs inputs;
    InputStream stream(path, inputs);
    std::string text;
    stream.read(50000, text);
    // past the resolution of the times of files
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    {
      std::ofstream file(path, std::ios::binary | std::ios::in | std::ios::out);
      file << later;
    }
    std::filesystem::resize_file(path, later.size());
    EXPECT_EQ(error_of([&] {
                while (!stream.at_end()) stream.read(50000, text);
              }),
              path + ": was changed while it was read: read it again when it is complete");
    EXPECT_TRUE(inputs.files().empty());
  }
}

TEST(InputStream, AFileThatIsReplacedMeanwhileIsReadAsItWas) {
  const TemporaryFolder folder;
  const std::string path = folder.write("data.csv", std::string(100000, 'x'));
  Inputs inputs;
  InputStream stream(path, inputs);
  std::string text;
  stream.read(50000, text);
  std::filesystem::rename(folder.write("new.csv", "y"), path);
  while (!stream.at_end()) stream.read(50000, text);
  EXPECT_EQ(text, std::string(100000, 'x'));
}

TEST(InputStream, APipeIsReadOnce) {
  const TemporaryFolder folder;
  const std::string pipe = folder.path("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(pipe) << std::string(200000, 'x'); });
  Inputs inputs;
  EXPECT_EQ(inputs.read(pipe).size(), 200000u);
  writer.join();
  EXPECT_EQ(content_of(inputs.files()[0]).size(), 200000u);
}

TEST(InputStream, OfMoreThanIsKeptTheHashAloneIsAndTheFileIsReadAgain) {
  const TemporaryFolder folder;
  const std::string path = folder.path("large.csv");
  std::ofstream(path) << "x";
  std::filesystem::resize_file(path, Inputs::kMostKept + 1);  // a file of holes
  Inputs inputs;
  const std::string content = inputs.read(path);
  const InputFile& file = inputs.files()[0];
  EXPECT_EQ(file.content, nullptr);
  EXPECT_EQ(content_of(file), content);
  // also from another working directory
  const std::filesystem::path here = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  Inputs relative;
  relative.read("large.csv");
  std::filesystem::current_path(here);
  EXPECT_EQ(content_of(relative.files()[0]), content);
  std::filesystem::resize_file(path, Inputs::kMostKept);
  EXPECT_EQ(error_of([&] { content_of(file); }),
            path + ": is another than the one that was read: its hash is not " + file.hash);
}

TEST(Inputs, OfMoreThanAMegabyteAreReadAgainOnceForgotten) {
  const TemporaryFolder folder;
  const std::string small = folder.write("small.csv", "P,T,A\n"),
                    large = folder.write("large.csv", std::string((1 << 20) + 1, 'x'));
  Inputs inputs;
  inputs.read(small);
  const std::string content = inputs.read(large);
  std::vector<InputFile> files = inputs.files();
  forget_large_contents(files);
  EXPECT_NE(files[0].content, nullptr);
  EXPECT_EQ(files[1].content, nullptr);
  EXPECT_EQ(content_of(files[1]), content);
  folder.write("large.csv", "shorter");
  EXPECT_EQ(error_of([&] { content_of(files[1]); }),
            large + ": is another than the one that was read: its hash is not " + files[1].hash);
}

}  // namespace inputs_test
}  // namespace mixity
