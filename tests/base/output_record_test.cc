#include "base/output_record.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "base/content_hash.h"
#include "base/files.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace output_record_test {

std::string refusal(const std::vector<OutputFile>& files, const OutputRules& rules = {}) {
  try {
    write_files(files, rules);
  } catch (const OutputError& error) {
    return error.what();
  }
  return {};
}

TEST(ContentHash, IsWhatXxh128sumPrints) {
  EXPECT_EQ(content_hash(""), "99aa06d3014798d86001c324468d497f");
  EXPECT_EQ(content_hash("P,T,A\n"), "839360a63fa6081ba2cc43d841af0462");
  ContentHash in_parts;
  for (const char* part : {"P,", "", "T,A\n"}) in_parts.add(part);
  EXPECT_EQ(in_parts.text(), content_hash("P,T,A\n"));
}

TEST(OutputRecord, AFileOfSomebodyElseIsNotReplaced) {
  const TemporaryFolder folder;
  const std::string theirs = folder.write("notes.csv", "theirs"), ours = folder.path("fits.csv");
  EXPECT_EQ(refusal({{ours, "1"}, {theirs, "2"}}),
            theirs + ": was not written by mixity and is not replaced: take another name, or force = \"true\"");
  EXPECT_EQ(read_file(theirs), "theirs");
  EXPECT_FALSE(std::filesystem::exists(ours));
  EXPECT_EQ(refusal({{theirs, "theirs"}}), "");  // nothing would be lost
  EXPECT_EQ(refusal({{theirs, "2"}}), "");       // it is ours now
  EXPECT_EQ(read_file(theirs), "2");
}

TEST(OutputRecord, AFileThatIsEmptyIsReplaced) {
  const TemporaryFolder folder;
  EXPECT_EQ(refusal({{folder.write("new.csv", ""), "1"}}), "");
}

TEST(OutputRecord, AFileThatWasEditedIsReplacedByForceOrWhereItIsKept) {
  const TemporaryFolder folder;
  const std::string path = folder.path("cuts.toml");
  write_files({{path, "1"}});
  write_files({{path, "2"}});
  folder.write("cuts.toml", "edited");
  EXPECT_EQ(refusal({{path, "3"}}),
            path + ": was edited since mixity wrote it and is not replaced: take another name, or force = \"true\"");
  EXPECT_EQ(read_file(path), "edited");
  std::vector<OutputFile> files{{path, "3"}};
  keep_former(files);
  EXPECT_EQ(refusal(files), "");
  EXPECT_EQ(read_file(path + ".old"), "edited");
  folder.write("cuts.toml", "edited again");
  EXPECT_EQ(refusal({{path, "4"}}, {{}, true, {}}), "");
  EXPECT_EQ(read_file(path), "4");
}

/// A program that is killed between two renames leaves the new record beside the former file.
TEST(OutputRecord, KnowsTheFormerContentToo) {
  const TemporaryFolder folder;
  const std::string path = folder.path("fits.csv");
  write_files({{path, "1"}});
  write_files({{path, "2"}});
  folder.write("fits.csv", "1");
  EXPECT_EQ(refusal({{path, "3"}}), "");
}

TEST(OutputRecord, SurvivesAnyName) {
  const TemporaryFolder folder;
  const std::string path = folder.path("a\\n\nb  c.csv");
  write_files({{path, "1"}});
  EXPECT_EQ(refusal({{path, "2"}}), "");
  EXPECT_TRUE(OutputRecord::of(folder.path()).knows("a\\n\nb  c.csv"));
}

/// A record from somebody else removes and replaces nothing outside its folder.
TEST(OutputRecord, IsOfItsFolderAlone) {
  const TemporaryFolder folder;
  const std::string theirs = folder.write("theirs", "theirs"), record = std::string("out/") + OutputRecord::kName;
  std::filesystem::create_directory(folder.path("out"));
  folder.write(record, content_hash("theirs") + "  ../theirs\n" + content_hash("theirs") + "  " + theirs + "\n");
  EXPECT_EQ(refusal({{folder.path("out/1"), "1"}}, {{}, false, {folder.path("out")}}), "");
  EXPECT_EQ(read_file(theirs), "theirs");
  std::filesystem::remove(folder.path(record));
  std::filesystem::create_symlink(theirs, folder.path(record));
  EXPECT_EQ(refusal({{folder.path("out/1"), "2"}}),
            folder.path(record) + ": is no file, as mixity's record of what it wrote there is: remove it");
  EXPECT_EQ(read_file(theirs), "theirs");
}

TEST(OutputRecord, ForgetsWhatIsNoLongerThere) {
  const TemporaryFolder folder;
  write_files({{folder.path("one"), "1"}, {folder.path("two"), "2"}});
  std::filesystem::remove(folder.path("one"));
  write_files({{folder.path("two"), "3"}});
  EXPECT_EQ(OutputRecord::of(folder.path()).names(), std::vector<std::string>{"two"});
}

TEST(OutputRecord, OfARenewedFolderWhatAFormerRunWroteIsRemovedAndNothingElse) {
  const TemporaryFolder folder;
  const auto in = [&](const std::string& name) { return folder.path("figures/" + name); };
  write_files({{in("old.svg"), "1"}, {in("edited.svg"), "1"}, {in("again.svg"), "1"}, {folder.path("fits.csv"), "1"}});
  folder.write("figures/edited.svg", "edited");
  folder.write("figures/theirs.svg", "theirs");
  write_files({{in("again.svg"), "2"}}, {{}, false, {folder.path("figures")}});
  EXPECT_FALSE(std::filesystem::exists(in("old.svg")));
  EXPECT_EQ(read_file(in("again.svg")), "2");
  EXPECT_EQ(read_file(in("edited.svg")), "edited");
  EXPECT_EQ(read_file(in("theirs.svg")), "theirs");
  EXPECT_EQ(read_file(folder.path("fits.csv")), "1");
}

}  // namespace output_record_test
}  // namespace mixity
