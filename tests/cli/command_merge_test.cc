// Shards of a list of files, fitted apart and merged, are the document of all.
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "cli/run_program.h"
#include "dataset/temporary_folder.h"

namespace mixity::cli {
namespace command_merge_test {

class Shards : public testing::Test {
 protected:
  Shards() {
    for (int i = 1; i <= 5; ++i)
      run_program({"simulate", "--model=c", "--lambda=0.0" + std::to_string(i), "--loads=1,4 mN", "--radius=9.42 mm",
                   "--modulus=2.133 MPa", "--toughness=27 mJ/m^2", "--seed=" + std::to_string(i),
                   "--out=" + folder_.path("run_" + std::to_string(i) + ".csv")});
    for (int i = 1; i <= 5; ++i) files_.push_back(folder_.path("run_" + std::to_string(i) + ".csv"));
  }
  ProgramResult fit(const std::string& shard, const Words& more = {"--models=c"}) {
    Words words{"fit"};
    words.insert(words.end(), files_.begin(), files_.end());
    words.insert(words.end(), more.begin(), more.end());
    words.push_back("--format=json");
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
  // 2^32 + 1 is not 1
  std::string wrapped = fit("1/3").out;
  wrapped.replace(wrapped.find("\"1/3\""), 5, "\"4294967297/4294967299\"");
  EXPECT_NE(
      refused({folder_.write("wrapped.json", wrapped), parts[2], parts[3]}).find("does not say which shard it is"),
      std::string::npos);
}

TEST_F(Shards, ThatDoNotBelongTogetherAreRefused) {
  const auto part = [&](const std::string& name, const std::string& shard, const Words& more) {
    return folder_.write(name, fit(shard, more).out);
  };
  const std::string first = part("first.json", "1/2", {"--models=c"});
  const auto refused = [&](const std::string& second) {
    const ProgramResult result = run_program({"merge", first, second});
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_EQ(result.out, "");
    return result.err;
  };
  const auto says = [](const std::string& text, const std::string& what) {
    EXPECT_NE(text.find(what), std::string::npos) << text;
  };
  says(refused(part("a.json", "2/2", {"--models=b"})),
       "a.json: was made with --models=b, " + first + " with --models=c");
  says(refused(part("b.json", "2/2", {"--models=c", "--radius=8 mm"})), "was made with --radius=8 mm, ");
  says(refused(part("c.json", "2/2", {})), "was made without --models, ");
  const Words resampled{"--models=c", "--bootstrap=20"}, on_one_thread{"--models=c", "--bootstrap=20", "--threads=1"};
  EXPECT_EQ(run_program({"merge", part("1.json", "1/2", resampled), part("2.json", "2/2", on_one_thread)}).exit_code,
            0);

  part("d.json", "2/2", {"--models=c"});
  nlohmann::json less = nlohmann::json::parse(content_of(folder_.path("d.json")));
  less["datasets"].erase(0);
  says(refused(folder_.write("less.json", less.dump())), "holds 1 of the 2 data sets of its share");
  less.erase("campaign");
  says(refused(folder_.write("old.json", less.dump())), "does not state the files and flags");

  std::swap(files_[0], files_[4]);
  says(refused(part("e.json", "2/2", {"--models=c"})), "is of another list of files than " + first + ": number 1 is '");
  files_.pop_back();
  says(refused(part("f.json", "2/2", {"--models=c"})), "is of a list of 4 files, " + first + " of one of 5");
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

}  // namespace command_merge_test
}  // namespace mixity::cli
