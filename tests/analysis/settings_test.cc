#include "analysis/settings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "analysis/fit_definition.h"
#include "analysis/request.h"
#include "base/files.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace settings_test {

/// A text that each option takes, none of them its default.
const std::map<std::string_view, std::string_view> kTexts{{"models", "bk,c-ellipse"},
                                                          {"objective", "toughness"},
                                                          {"scale", "linear"},
                                                          {"weighted", "true"},
                                                          {"sigma_T", "0.5%"},
                                                          {"sigma_A", "0.002 mm^2"},
                                                          {"loss", "huber"},
                                                          {"loss_scale", "1.5"},
                                                          {"hold", "r,eta=2"},
                                                          {"free", "load_offset"},
                                                          {"exclude", "4,7-9"},
                                                          {"leave_out", "P=3"},
                                                          {"interval", "none"},
                                                          {"confidence", "0.9"},
                                                          {"checks", "false"},
                                                          {"lambda_prior", "log_uniform"},
                                                          {"bootstrap", "20"},
                                                          {"resample", "curves"},
                                                          {"seed", "7"},
                                                          {"threads", "2"},
                                                          {"influence", "true"},
                                                          {"compare", "false"},
                                                          {"per", "curve"},
                                                          {"formats", "pdf,png"},
                                                          {"fitted_errors", "false"},
                                                          {"by_run", "toughness,lambda"},
                                                          {"drift", "modulus"},
                                                          {"unsheared", "own"},
                                                          {"tie", "lambda_III=0"},
                                                          {"sigma_factor", "free"},
                                                          {"lambda_prior_from", "0.001"}};

FitRequest with_all() {
  FitRequest request;
  request.data_path = "data.csv";
  for (const Setting& one : settings()) EXPECT_EQ(set_option(request, one.name, kTexts.at(one.name)), "") << one.name;
  return request;
}

TEST(Settings, EachTakesItsTextAndSaysWhatIsWrongWithAnother) {
  const FitRequest request = with_all();
  EXPECT_EQ(request.stated.size(), settings().size());
  for (const Setting& one : settings()) {
    FitRequest other;
    EXPECT_NE(set_option(other, one.name, "a wrong text,,"), "") << one.name;
    EXPECT_TRUE(other.stated.empty()) << one.name;
  }
  FitRequest other;
  EXPECT_THROW(set_option(other, "colour", "red"), std::invalid_argument);
}

TEST(Settings, WriteWhatTheyRead) {
  const FitRequest request = with_all(), initial;
  for (const Setting& one : settings()) {
    EXPECT_EQ(one.write(request), kTexts.at(one.name)) << one.name;
    EXPECT_NE(one.initial(), kTexts.at(one.name)) << one.name;
    FitRequest other = request;
    if (one.initial().empty()) continue;
    EXPECT_EQ(one.read(one.initial(), other), "") << one.name;
    EXPECT_EQ(one.write(other), one.initial()) << one.name;
  }
  EXPECT_EQ(stated_options(request).size(), settings().size());
  EXPECT_TRUE(stated_options(initial).empty());
}

TEST(Settings, KeepUnitsFilesAndNumbersAsTheyAreTyped) {
  for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{{"sigma_T", "0.2 mN"},
                                                                                   {"sigma_A", "0.01"},
                                                                                   {"exclude", "run_3.csv:17,4-9"},
                                                                                   {"hold", "lambda=0.1"},
                                                                                   {"free", "modulus,lambda"},
                                                                                   {"confidence", "0.6827"},
                                                                                   {"seed", "9223372036854775807"}}) {
    FitRequest request;
    EXPECT_EQ(set_option(request, name, text), "");
    EXPECT_EQ(stated_options(request), (std::vector<std::pair<std::string, std::string>>{{name, text}}));
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

/// The page passes the names of its fields on.
TEST(Settings, AndConstantsHaveTheNamesOfTheExplorersFields) {
  const std::string page = read_file(MIXITY_ROOT "/src/explorer/page/index.html");
  const std::size_t begin = page.find("<form id=\"constants\""), end = page.find("</form>", begin);
  ASSERT_NE(end, std::string::npos);
  const std::string form = page.substr(begin, end - begin);
  std::size_t fields = 0;
  for (std::size_t at = 0; (at = form.find("<input name=\"", at)) != std::string::npos; ++fields) {
    at += 13;
    const std::string name = form.substr(at, form.find('"', at) - at);
    EXPECT_TRUE(std::ranges::any_of(metadata_fields(), [&](const auto& field) { return field.name == name; })) << name;
  }
  EXPECT_EQ(fields, 8u);  // with the stiffness and the zero of a held approach
}

TEST(Settings, FormatsOfFiguresAreAList) {
  FitRequest request;
  EXPECT_EQ(set_option(request, "formats", "pdf, gnuplot"), "");
  EXPECT_TRUE(request.formats.pdf && request.formats.gnuplot && !request.formats.png);
  EXPECT_EQ(set_option(request, "formats", "none"), "");
  EXPECT_FALSE(request.formats.pdf || request.formats.gnuplot || request.formats.png);
  EXPECT_EQ(set_option(request, "formats", "pdf,eps"),
            "names the unknown format 'eps' (known: pdf, png, gnuplot, none)");
  EXPECT_EQ(set_option(request, "formats", "pdf,pdf"), "names 'pdf' twice");
}

TEST(Settings, HaveDecimalCommasInListsToo) {
  FitRequest request;
  EXPECT_EQ(set_option(request, "hold", "lambda=0,01, modulus"), "");
  ASSERT_EQ(request.options.hold.size(), 2u);
  EXPECT_EQ(request.options.hold[0].value, 0.01);
  EXPECT_EQ(request.options.hold[1].name, "modulus");
  EXPECT_EQ(set_option(request, "hold", "eta=2,133"), "has 'eta=2,133'; write \"2.133\" or \"2133\"");
  EXPECT_EQ(set_option(request, "hold", "modulus,01"), "has '01', which is neither a parameter nor PARAMETER=NUMBER");
  EXPECT_EQ(set_option(request, "confidence", "0,9"), "");
  EXPECT_EQ(request.options.confidence, 0.9);
}

TEST(Settings, SuggestTheNameThatWasMeant) {
  const auto begin_of = [](std::string_view name, const char* text) {
    FitRequest request;
    const std::string problem = set_option(request, name, text);
    return problem.substr(0, problem.find(" (known:"));
  };
  EXPECT_EQ(begin_of("models", "Quadratc"), "names the unknown model 'Quadratc': did you mean quadratic?");
  EXPECT_EQ(begin_of("free", "areascale"), "names 'areascale', which cannot be fitted: did you mean area_scale?");
  EXPECT_EQ(begin_of("by_run", "Modulus"),
            "names 'Modulus', which cannot differ from run to run: did you mean modulus?");
  EXPECT_EQ(begin_of("drift", "thoughness"), "names 'thoughness', which has no drift: did you mean toughness?");
  EXPECT_EQ(begin_of("formats", "gnuplots"), "names the unknown format 'gnuplots': did you mean gnuplot?");
  try {
    begin_of("modles", "c");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_TRUE(std::string_view(error.what()).starts_with("there is no option 'modles': did you mean models? (known:"))
        << error.what();
  }
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
  EXPECT_EQ(named({{"loss_scale", "2"}, {"loss", "t"}}), "loss_scale");
  EXPECT_EQ(named({{"lambda_prior_from", "0.01"}}), "lambda_prior_from");
  EXPECT_EQ(named({{"lambda_prior_from", "0.01"}, {"lambda_prior", "log_uniform"}}), "");
  EXPECT_EQ(named({{"loss", "t"}, {"per", "curve"}}), "loss");
  EXPECT_EQ(named({{"seed", "2"}}), "seed");
  EXPECT_EQ(named({{"seed", "2"}, {"bootstrap", "10"}}), "");
  EXPECT_EQ(named({{"threads", "2"}}), "threads");
  EXPECT_EQ(named({{"hold", "r"}, {"models", "c"}}), "hold");
  EXPECT_EQ(named({{"hold", "r"}, {"models", "bk"}, {"free", "r"}}), "free");
  EXPECT_EQ(named({{"free", "eta"}, {"models", "c"}}), "free");
  EXPECT_EQ(named({{"confidence", "0.9"}, {"interval", "none"}}), "confidence");
}

}  // namespace settings_test
}  // namespace mixity
