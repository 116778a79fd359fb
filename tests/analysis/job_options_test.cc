#include "analysis/job_options.h"

#include <gtest/gtest.h>

#include "analysis/fit_definition.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace {

/// A text that each option takes, none of them its default.
const std::map<std::string_view, std::string_view> kTexts{
    {"models", "c,bk"},    {"objective", "toughness"}, {"scale", "linear"},  {"weighted", "true"},
    {"sigma_T", "0.5%"},   {"sigma_A", "0.002 mm^2"},  {"loss", "huber"},    {"loss_scale", "1.5"},
    {"hold", "r,eta=2"},   {"free", "load_offset"},    {"exclude", "4,7-9"}, {"leave_out", "P=3"},
    {"interval", "none"},  {"confidence", "0.9"},      {"checks", "false"},  {"lambda_prior", "log_uniform"},
    {"bootstrap", "20"},   {"resample", "curves"},     {"seed", "7"},        {"threads", "2"},
    {"influence", "true"}, {"compare", "false"},       {"per", "curve"}};

FitJob with_all() {
  FitJob job;
  job.data_path = "data.csv";
  for (const std::string_view name : kJobOptions) EXPECT_EQ(set_option(job, name, kTexts.at(name)), "") << name;
  return job;
}

TEST(JobOptions, EachTakesItsTextAndSaysWhatIsWrongWithAnother) {
  const FitJob job = with_all();
  EXPECT_EQ(job.stated.size(), kJobOptions.size());
  for (const std::string_view name : kJobOptions) {
    FitJob other;
    if (name == "leave_out") continue;  // a run may have any name
    EXPECT_NE(set_option(other, name, "a wrong text,,"), "") << name;
    EXPECT_TRUE(other.stated.empty()) << name;
  }
}

TEST(JobOptions, AreReadBackFromTheDefinitionOfAJob) {
  const TemporaryFolder folder;
  FitJob job = with_all();
  job.constants = {{"modulus", "2.1 MPa +/- 5%"}, {"note", "with \"quotes\" and a \\"}};
  const std::string path = folder.path("fit.toml");
  const FitJob again = read_fit_definition(folder.write("fit.toml", fit_definition_text(job, {}, path)));
  EXPECT_EQ(again.stated, job.stated);
  EXPECT_EQ(again.models, job.models);
  EXPECT_EQ(again.constants, job.constants);
  EXPECT_EQ(again.options.bootstrap.seed, 7U);
  EXPECT_EQ(again.options.free, job.options.free);
  ASSERT_EQ(again.exclusion.lines.size(), 2U);
  EXPECT_EQ(again.exclusion.lines[1].last, 9U);
  EXPECT_EQ(again.exclusion.runs, job.exclusion.runs);
}

TEST(JobOptions, ThatDoNotGoTogetherAreNamed) {
  const auto named = [](std::initializer_list<std::pair<std::string_view, std::string_view>> options) {
    FitJob job;
    for (const auto& [name, text] : options) EXPECT_EQ(set_option(job, name, text), "");
    const auto wrong = contradiction(job);
    return wrong ? wrong->option : "";
  };
  EXPECT_EQ(named({}), "");
  EXPECT_EQ(named({{"scale", "log"}, {"objective", "curve"}}), "scale");
  EXPECT_EQ(named({{"weighted", "true"}, {"objective", "curve"}}), "weighted");
  EXPECT_EQ(named({{"sigma_A", "1%"}, {"objective", "toughness"}}), "sigma_A");
  EXPECT_EQ(named({{"loss_scale", "2"}}), "loss_scale");
  EXPECT_EQ(named({{"seed", "2"}}), "seed");
  EXPECT_EQ(named({{"seed", "2"}, {"bootstrap", "10"}}), "");
  EXPECT_EQ(named({{"threads", "2"}}), "threads");
  EXPECT_EQ(named({{"hold", "r"}, {"models", "c"}}), "hold");
  EXPECT_EQ(named({{"hold", "r"}, {"models", "bk"}, {"free", "r"}}), "free");
  EXPECT_EQ(named({{"free", "eta"}, {"models", "c"}}), "free");
  EXPECT_EQ(named({{"confidence", "0.9"}, {"interval", "none"}}), "confidence");
}

}  // namespace
}  // namespace mixity
