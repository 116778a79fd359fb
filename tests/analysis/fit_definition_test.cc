// Definitions as they are read; what is refused stands with its message in tests/bad_input.
#include "analysis/fit_definition.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/input_error.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace fit_definition_test {

TEST(FitDefinition, StatesItsObjectiveOrLeavesItToTheData) {
  const TemporaryFolder folder;
  const auto objective = [&](const std::string& line) {
    return read_fit_definition(folder.write("fit.toml", "data = \"a.csv\"\n" + line)).options.objective;
  };
  EXPECT_EQ(objective("objective = \"toughness\"\n"), Objective::toughness);
  EXPECT_EQ(objective("objective = \"curve\"\n"), Objective::curve);
  EXPECT_EQ(objective(""), std::nullopt);
  EXPECT_THROW(objective("objective = \"area\"\n"), InputError);
}

TEST(FitDefinition, NamesNoModelThatDoesNotExist) {
  const TemporaryFolder folder;
  for (const char* line : {"models = [\"z\"]\n", "models = [\"c\", \"\"]\n", "models = [\"C\"]\n",
                           "[published.z]\nlambda = {value = 1, tolerance = 1}\n"})
    EXPECT_THROW(read_fit_definition(folder.write("fit.toml", std::string("data = \"a.csv\"\n") + line)), InputError)
        << line;
}

TEST(FitDefinition, StatesPublishedNumbersOfEllipticModelsToo) {
  const TemporaryFolder folder;
  const std::string number = ".lambda_II]\nvalue = 0.004\ntolerance = 0.001\n";
  for (const char* models : {"models = [\"c-ellipse\"]\n", "models = [\"c\"]\nconstants = {shape = \"ellipse\"}\n"}) {
    const FitRequest request = read_fit_definition(
        folder.write("fit.toml", "data = \"a.csv\"\n" + std::string(models) + "[published.c-ellipse" + number));
    ASSERT_EQ(request.published.count("c-ellipse"), 1U) << models;
    EXPECT_EQ(request.published.at("c-ellipse").at(0).name, "lambda_II");
  }
}

TEST(FitDefinition, StatesPublishedNumbersOfFittedConstantsAndChiSquared) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& free, const std::string& name) {
    return read_fit_definition(folder.write("fit.toml", "data = \"a.csv\"\nmodels = [\"c\"]\n" + free +
                                                            "[published.c]\n" + name +
                                                            " = {value = 2, tolerance = 0.5}\n"));
  };
  const std::string free = "free = [\"toughness\"]\n";
  for (const char* name : {"chi2", "toughness", "\"toughness(2)\""}) {
    const FitRequest request = read(free, name);
    const std::string text = fit_definition_text(request, {}, folder.path("saved.toml"));
    EXPECT_EQ(read_fit_definition(folder.write("saved.toml", text)).published.at("c").at(0).name,
              request.published.at("c").at(0).name)
        << text;
  }
  for (const char* name : {"modulus", "\"toughness(2\"", "\"lambda(2)\""})
    EXPECT_THROW(read(free, name), InputError) << name;
  EXPECT_THROW(read("", "toughness"), InputError);
}

TEST(FitDefinition, IsNamedWhereNoFileMatchesItsPattern) {
  const TemporaryFolder folder;
  const std::string path = folder.write("fit.toml", "\ndata = \"none_*.csv\"\n");
  try {
    read_fit_definition(path);
    FAIL();
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_TRUE(text.starts_with(path + ":2:8: data: ")) << text;
    EXPECT_TRUE(text.ends_with("none_*.csv: no file has such a name")) << text;
  }
}

/// The published values of these were found as the paper does it.
TEST(FitDefinition, EveryShippedOneStatesThePapersObjective) {
  for (const char* name : {"as4_peek_mmb", "mergel2018", "waters_guduru2010"}) {
    const FitRequest request = read_fit_definition(std::string(MIXITY_ROOT "/fits/") + name + ".toml");
    EXPECT_EQ(request.options.objective, Objective::toughness) << name;
    EXPECT_FALSE(request.published.empty()) << name;
  }
}

TEST(FitDefinition, NamesItsDataTheSameWhetherItsFolderIsThereOrNot) {
  const TemporaryFolder folder;
  FitRequest request;
  request.data_path = folder.path("data.csv");
  const std::string path = folder.path("new/fit.toml"), text = fit_definition_text(request, {}, path);
  EXPECT_NE(text.find("'../data.csv'"), std::string::npos) << text;
  std::filesystem::create_directory(folder.path("new"));
  EXPECT_EQ(fit_definition_text(request, {}, path), text);
}

}  // namespace fit_definition_test
}  // namespace mixity
