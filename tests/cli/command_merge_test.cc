// Shards of a list of files, fitted apart and merged, are the document of all.
#include <gtest/gtest.h>

#include <cstdlib>

#include "cli/run_program.h"
#include "dataset/temporary_folder.h"

namespace mixity::cli {
namespace {

class Shards : public testing::Test {
 protected:
  Shards() {
    for (int i = 1; i <= 5; ++i)
      run_program({"simulate", "--model=c", "--lambda=0.0" + std::to_string(i), "--loads=1,4 mN", "--radius=9.42 mm",
                   "--modulus=2.133 MPa", "--toughness=27 mJ/m^2", "--seed=" + std::to_string(i),
                   "--out=" + folder_.path("run_" + std::to_string(i) + ".csv")});
    for (int i = 1; i <= 5; ++i) files_.push_back(folder_.path("run_" + std::to_string(i) + ".csv"));
  }
  ProgramResult fit(const std::string& shard) {
    Words words{"fit"};
    words.insert(words.end(), files_.begin(), files_.end());
    words.insert(words.end(), {"--models=c", "--format=json"});
    if (!shard.empty()) words.push_back("--shard=" + shard);
    return run_program(words);
  }
  TemporaryFolder folder_;
  Words files_;
};

TEST_F(Shards, MergedAreTheDocumentOfAll) {
  const std::string whole = fit("").out;
  Words parts{"merge"};
  for (const char* shard : {"1/3", "2/3", "3/3"})
    parts.push_back(folder_.write("part" + std::string(1, shard[0]) + ".json", fit(shard).out));
  EXPECT_EQ(run_program(parts).out, whole);
  EXPECT_EQ(run_program({"merge", parts[3], parts[1], parts[2]}).out, whole);  // in whatever order
  const auto refused = [&](const Words& names) {
    Words words{"merge"};
    words.insert(words.end(), names.begin(), names.end());
    const ProgramResult result = run_program(words);
    EXPECT_EQ(result.exit_code, 3);
    return result.err;
  };
  EXPECT_NE(refused({parts[1], parts[3]}).find("shard 2/3: is missing"), std::string::npos);
  EXPECT_NE(refused({parts[1], parts[2]}).find("shard 3/3: is missing"), std::string::npos);
  EXPECT_NE(refused({parts[1], parts[2], parts[2], parts[3]}).find("is shard 2, as "), std::string::npos);
  EXPECT_NE(refused({parts[1], folder_.write("other.json", fit("2/2").out)}).find("is one of 2 shards"),
            std::string::npos);
  EXPECT_NE(refused({folder_.write("whole.json", whole)}).find("does not say which shard it is"), std::string::npos);
}

TEST_F(Shards, OfAnArrayOfTasksAreMerged) {
  const std::string script = std::string(MIXITY_ROOT) + "/tests/examples/slurm/fit_array.sh";
  for (const char* task : {"1", "2"}) {
    const std::string command = "MIXITY='" MIXITY_PROGRAM "' FILES='" + folder_.path("run_*.csv") + "' PARTS='" +
                                folder_.path("parts") + "' SLURM_ARRAY_TASK_COUNT=2 SLURM_ARRAY_TASK_ID=" + task + " " +
                                script;
    ASSERT_EQ(std::system(command.c_str()), 0);
  }
  const ProgramResult merged = run_program({"merge", folder_.path("parts/0001.json"), folder_.path("parts/0002.json")});
  Words all{"fit"};
  all.insert(all.end(), files_.begin(), files_.end());
  all.push_back("--format=json");
  EXPECT_EQ(merged.out, run_program(all).out);
}

TEST_F(Shards, ThatCannotBeAreRefused) {
  for (const char* shard : {"0/2", "3/2", "1", "a/b", "1.5/2"}) {
    const ProgramResult result = fit(shard);
    EXPECT_EQ(result.exit_code, 2) << shard;
    EXPECT_NE(result.err.find("it must be i/n"), std::string::npos) << shard;
  }
  EXPECT_EQ(run_program({"merge", files_[0]}).exit_code, 3);
}

}  // namespace
}  // namespace mixity::cli
