#include <gtest/gtest.h>

#include "analysis/fit_definition.h"
#include "analysis/request.h"
#include "analysis/settings.h"
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

FitRequest with_all() {
  FitRequest request;
  request.data_path = "data.csv";
  for (const std::string_view name : kOptionNames) EXPECT_EQ(set_option(request, name, kTexts.at(name)), "") << name;
  return request;
}

TEST(Settings, EachTakesItsTextAndSaysWhatIsWrongWithAnother) {
  const FitRequest request = with_all();
  EXPECT_EQ(request.stated.size(), kOptionNames.size());
  for (const std::string_view name : kOptionNames) {
    FitRequest other;
    if (name == "leave_out") continue;  // a run may have any name
    EXPECT_NE(set_option(other, name, "a wrong text,,"), "") << name;
    EXPECT_TRUE(other.stated.empty()) << name;
  }
}

TEST(Settings, AreReadBackFromTheDefinitionOfARequest) {
  const TemporaryFolder folder;
  FitRequest request = with_all();
  request.constants = {{"modulus", "2.1 MPa +/- 5%"}, {"note", "with \"quotes\" and a \\"}};
  const std::string path = folder.path("fit.toml");
  const FitRequest again = read_fit_definition(folder.write("fit.toml", fit_definition_text(request, {}, path)));
  EXPECT_EQ(again.stated, request.stated);
  EXPECT_EQ(again.models, request.models);
  EXPECT_EQ(again.constants, request.constants);
  EXPECT_EQ(again.options.bootstrap.seed, 7U);
  EXPECT_EQ(again.options.free, request.options.free);
  ASSERT_EQ(again.exclusion.lines.size(), 2U);
  EXPECT_EQ(again.exclusion.lines[1].last, 9U);
  EXPECT_EQ(again.exclusion.runs, request.exclusion.runs);
}

TEST(Settings, ThatDoNotGoTogetherAreNamed) {
  const auto named = [](std::initializer_list<std::pair<std::string_view, std::string_view>> options) {
    FitRequest request;
    for (const auto& [name, text] : options) EXPECT_EQ(set_option(request, name, text), "");
    const auto wrong = contradiction(request);
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
