// Files as people break them. expected.txt says for each command line how the program must end and in which words.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/run_program.h"
#include "dataset/temporary_folder.h"

namespace mixity::cli {
namespace bad_input_test {

const std::string kFolder = MIXITY_ROOT "/tests/bad_input";

struct Expected {
  std::string words;  // the command line, parted by blanks; OUT stands for a folder that is not there yet
  int exit_code;
  std::string complaint;
};

/// Lines "EXIT CODE | COMMAND LINE | MESSAGE"; those that begin with '#' are comments.
std::vector<Expected> table() {
  std::vector<Expected> rows;
  for (const std::string& line : lines_of(content_of(kFolder + "/expected.txt"))) {
    if (line.empty() || line[0] == '#') continue;
    const std::size_t first = line.find(" | "), second = line.find(" | ", first + 3);
    if (second == std::string::npos) throw std::runtime_error("expected.txt: " + line);
    rows.push_back(
        {line.substr(first + 3, second - first - 3), std::stoi(line.substr(0, first)), line.substr(second + 3)});
  }
  return rows;
}

Words words_of(const std::string& text, const std::string& out) {
  Words words;
  std::istringstream stream(text);
  for (std::string word; stream >> word;) words.push_back(std::regex_replace(word, std::regex("OUT$"), out));
  return words;
}

/// Messages name files as the command line does: relative to the folder they are in.
class BadInput : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::current_path(kFolder + "/files"); }
  void TearDown() override { std::filesystem::current_path(before_); }

 private:
  std::filesystem::path before_ = std::filesystem::current_path();
};

TEST_F(BadInput, IsRefusedInTheWordsOfTheTable) {
  const std::vector<Expected> rows = table();
  EXPECT_GE(rows.size(), 60u);
  const TemporaryFolder folder;
  for (const Expected& row : rows) {
    const std::string out = folder.path("out");
    expect_refused(words_of(row.words, out), row.exit_code, row.complaint);
    EXPECT_FALSE(std::filesystem::exists(out)) << "a result was written by " << row.words;
  }
}

TEST_F(BadInput, EveryMessageOfExitThreeNamesTheFileAndThePlaceInIt) {
  // What concerns a file as a whole has no place in it.
  const std::regex whole(
      "cannot be (opened|read|looked up): .*|(weighted |scale )?needs \\w+(, \\w+)* .*|the constants? .* "
      "missing.*|states .*|the key data is "
      "missing"
      "|.*out of range|objective \\w+ needs .*|parameter .*|a bootstrap of curves .*|the header '.*"
      "|holds \\(G_I, G_II\\) points; .*|sigma_T and sigma_A are errors .*"
      "|has no (point|run) .*|is a workbook (or an archive that is damaged|of Excel 97).*|no file has such a name");
  const std::regex placed("([^:]+):([1-9][0-9]*):([1-9][0-9]*): (.+)"), unplaced("([^:]+): (.+)");
  std::size_t seen = 0;
  for (const Expected& row : table()) {
    const bool flag_at_fault = row.complaint.starts_with("--");
    if (row.exit_code != 3 || flag_at_fault) continue;
    ++seen;
    std::smatch parts;
    const bool has_place = std::regex_match(row.complaint, parts, placed);
    if (!has_place) {
      ASSERT_TRUE(std::regex_match(row.complaint, parts, unplaced)) << row.complaint;
      EXPECT_TRUE(std::regex_match(parts[2].str(), whole)) << "without a place: " << row.complaint;
    }
    const std::string name = parts[1];
    // A file that is not there is named by the command line or by the definition that refers to it.
    EXPECT_TRUE(std::filesystem::exists(name) || row.words.find(name) != std::string::npos ||
                row.complaint.find("cannot be opened") != std::string::npos)
        << row.complaint;
    if (has_place && std::filesystem::is_regular_file(name) && std::stoul(parts[2]) > 1) {
      const std::size_t lines = lines_of(content_of(name)).size();
      EXPECT_LE(std::stoul(parts[2]), lines + 1) << row.complaint;
    }
  }
  EXPECT_GE(seen, 60u);
}

TEST_F(BadInput, EveryFileOfTheFolderIsUsed) {
  std::string all = content_of(kFolder + "/expected.txt");
  for (const auto& entry : std::filesystem::directory_iterator(".")) {
    const std::string stem = entry.path().stem().string();
    const bool named = all.find(stem + ".") != std::string::npos;
    EXPECT_TRUE(named) << entry.path() << " stands in no row";
  }
}

}  // namespace bad_input_test
}  // namespace mixity::cli
