// Laws that are typed as a flag or in a definition are models by their keys; what is wrong with one is said with its
// place.
#include "analysis/laws.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/fit_definition.h"
#include "analysis/request.h"
#include "base/input_error.h"
#include "dataset/temporary_folder.h"
#include "mechanics/laws/known_laws.h"

namespace mixity {
namespace laws_test {

std::string refusal_of(const std::string& text) {
  try {
    define_law_text("--law", text);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(LawText, HoldsKeyExpressionRangesAndStart) {
  const DefinedLaw defined = define_law_text("--law", "second: 2 + 2*p*t^n; p=0..1 start 0.3, n=2..4; normalised");
  const LawDefinition& law = defined.law->definition();
  EXPECT_EQ(law.key, "second");
  EXPECT_EQ(law.text, "2 + 2*p*t^n");
  ASSERT_EQ(law.parameters.size(), 2u);
  EXPECT_EQ(law.parameters[0].start, 0.3);
  EXPECT_EQ(law.parameters[1].start, 3);
  EXPECT_TRUE(law.normalised);
  EXPECT_NEAR(defined.law->toughness(0.7, std::vector{0.3, 2.0}), 1 + 0.3 * std::pow(std::tan(0.7), 2), 1e-15);
}

TEST(LawText, WithoutAKeyIsTheSameLawAgain) {
  const std::string one = define_law_text("--law", "1 + q*t^2; q=0..1").law->definition().key,
                    other = define_law_text("--law", "1 + q*t^2; q=0..0.9").law->definition().key;
  EXPECT_EQ(define_law_text("--law", "1 + q*t^2; q=0..1").law->definition().key, one);
  EXPECT_NE(other, one);
}

TEST(LawText, IsWrittenAsItIsRead) {
  for (const std::string text : {"1 + p*t^n; p=0..1; n=0.5..4 start 2", "2 + 2*q*B; q=-0.5..1e+20; normalised",
                                 "K_I^2 + l*K_II^2 = 1; l=1e-05..1"})
    EXPECT_EQ(law_text(read_law_text("--law", text)), text);
}

TEST(LawText, HasItsKeyFreeAgainWhereLawsAreForgotten) {
  const DefinedLaw former = define_law_text("--law", "again: 1 + q*t^2; q=0..1");
  EXPECT_FALSE(refusal_of("again: 1 + q*B; q=0..1").empty());
  forget_laws();
  EXPECT_FALSE(is_model("again"));
  EXPECT_EQ(refusal_of("again: 1 + q*B; q=0..1"), "");
  EXPECT_EQ(former.law->toughness(0, std::vector{0.5}), 1);
}

TEST(LawText, MayHaveAnEqualsSignWhereADefinitionHasOne) {
  const DefinedLaw defined = define_law_text("--law", "equals: 2 + p*t^2; p=0..1 start=0.3; normalised = true");
  EXPECT_TRUE(defined.law->definition().normalised);
  EXPECT_EQ(defined.law->definition().parameters[0].start, 0.3);
}

TEST(LawText, IsRefusedWithItsColumn) {
  EXPECT_EQ(refusal_of("1 + p*t^2"),
            "--law:1:1: a law has 1 to 3 parameters, each stated with its range; this one has 0");
  EXPECT_EQ(refusal_of(": 1 + p*t^2; p=0..1"), "--law:1:1: there is no key before the colon");
  EXPECT_EQ(refusal_of("k: 1 + p*t^; p=0..1"), "--law:1:12: something is missing at the end");
  EXPECT_TRUE(refusal_of("k: 1 + q*t^2; p=0..1").starts_with("--law:1:8: 'q' is not known; there are "));
  EXPECT_EQ(refusal_of("k: 1 + p*t^2; p=0.."), "--law:1:14: the range of 'p' must be two numbers: least..greatest");
  EXPECT_EQ(refusal_of("k: 1 + p*t^2; p"),
            "--law:1:14: 'p' is not a parameter; write name=least..greatest, optionally followed by start VALUE");
  EXPECT_EQ(refusal_of("c: 1 + p*t^2; p=0..1"), "--law:1:1: 'c' is one of the published models: choose another key");
  EXPECT_EQ(refusal_of("k: 2 + p*t^2; p=0..1"),
            "--law:1:4: f at psi = 0 is 2 with p = 0, not 1; normalised = true divides f by it");
  EXPECT_EQ(refusal_of("k: 1 + p*t^2; p=0...1"), "--law:1:14: the range of 'p' must be two numbers: least..greatest");
  EXPECT_EQ(refusal_of("k: 1 + p*t^2; p=0..1 start x"),
            "--law:1:14: the start of 'p' must be a number: least..greatest start VALUE");
  EXPECT_EQ(refusal_of("k: 1 + cosh*t^2; cosh=0..1"),
            "--law:1:1: 'cosh' cannot be the name of a parameter: that is a letter, then letters, digits and _, and no "
            "function or word of expressions");
  EXPECT_EQ(refusal_of("k: log(p) + p*t^2; p=-2..-1"),
            "--law:1:4: f at psi = 0 is not a number with p = -2; it must be 1");
  EXPECT_EQ(refusal_of("k k: 1 + p*t^2; p=0..1"),
            "--law:1:1: 'k k' cannot be the key of a law: a letter, then letters, digits and _");
}

class Definitions : public ::testing::Test {
 protected:
  std::string write(const std::string& text) const { return folder_.write("law_definition.toml", text); }
  std::string refusal(const std::string& text) const {
    const std::string path = write(text);
    try {
      read_fit_definition(path);
    } catch (const InputError& error) {
      return std::string(error.what()).substr(path.size());
    }
    return {};
  }

 private:
  const TemporaryFolder folder_;
};

TEST_F(Definitions, StateLawsThatAreModels) {
  const FitRequest request = read_fit_definition(
      write("data = \"x.csv\"\nmodels = [\"c\", \"mine\"]\nhold = \"n=2\"\n[laws.mine]\nf = \"1 + p*tan(psi)^n\"\n"
            "p = [0, 1]\nn = { range = [0.5, 4], start = 2 }\n"));
  EXPECT_EQ(request.models, (std::vector<std::string>{"c", "mine"}));
  const std::shared_ptr<const UserLaw> law = find_law("mine");
  ASSERT_TRUE(law);
  ASSERT_EQ(law->definition().parameters.size(), 2u);
  EXPECT_EQ(law->definition().parameters[0].name, "p");  // as they are written
  EXPECT_EQ(law->definition().parameters[1].start, 2);
  EXPECT_EQ(request.law_notes.size(), 1u);  // n < 2: several T have the same area
}

TEST_F(Definitions, FitTheirLawsWhereTheyNameNoModels) {
  const FitRequest request =
      read_fit_definition(write("data = \"x.csv\"\n[laws.extra]\nf = \"1 + p*t^2\"\np = [0, 1]\n"));
  EXPECT_EQ(request.models, (std::vector<std::string>{"a", "b", "c", "extra"}));
}

TEST_F(Definitions, SayWhereALawIsWrong) {
  EXPECT_TRUE(
      refusal("data = \"x.csv\"\n[laws.bad]\nf = \"1 + p*u^2\"\np = [0, 1]\n").starts_with(":3:12: 'u' is not known"));
  EXPECT_EQ(refusal("data = \"x.csv\"\n[laws.bad]\nf = \"1 + p*t^2\"\np = [0]\n"),
            ":4:1: parameter p must be [least, greatest] or {range = [least, greatest], start = ...}");
  EXPECT_EQ(refusal("data = \"x.csv\"\n[laws.bad]\np = [0, 1]\n"), ":2:1: law bad states no f");
  EXPECT_EQ(refusal("data = \"x.csv\"\nlaws = 3\n"), ":2:8: laws must be tables, each written [laws.KEY]");
}

TEST(ShippedLaws, AreDefinedWhenTheyAreAskedFor) {
  for (const auto& [law, source] : shipped_laws()) {
    provide_law(law.key);
    ASSERT_TRUE(find_law(law.key)) << law.key;
    EXPECT_TRUE(is_shipped(*find_law(law.key)));
    EXPECT_FALSE(source.empty()) << law.key;
  }
}

double f_of(const std::string& key, double psi, const std::vector<double>& p) {
  provide_law(key);
  return find_law(key)->toughness(psi, p);
}

// The limits that the sources print.
TEST(ShippedLaws, HaveTheirPublishedLimits) {
  const double right = std::acos(0.0);
  for (const double r : {0.5, 2.0, 30.0}) {
    // pure modes; at equal shares of the linear law 1/f = (1 + 1/r)/2
    EXPECT_NEAR(f_of("power", right, {r, 1.3, 0.7}), r, 1e-12 * r);
    EXPECT_NEAR(f_of("power", right / 2, {r, 1, 1}), 2 / (1 + 1 / r), 1e-14);
    EXPECT_NEAR(f_of("linear", right, {r}), r, 1e-12 * r);
    EXPECT_NEAR(f_of("linear", right / 2, {r}), f_of("power", right / 2, {r, 1, 1}), 1e-14);
    EXPECT_NEAR(f_of("quadratic", 0.6, {r}), f_of("power", 0.6, {r, 2, 2}), 1e-13);
  }
  // lambda = 1: mode-independent; lambda = 0: mode I alone, 1 + tan^2 psi; without a shift it is model b with twice
  // lambda
  EXPECT_NEAR(f_of("hutchinson_suo", 1.1, {1, 0}), 1, 1e-15);
  EXPECT_NEAR(f_of("hutchinson_suo", 1.1, {0, 0}), 1 + std::pow(std::tan(1.1), 2), 1e-13);
  EXPECT_NEAR(f_of("hutchinson_suo", 1.1, {0.2, 0.1}),
              (1 + std::pow(std::tan(0.8 * 1.0), 2)) / (1 + std::pow(std::tan(0.8 * 0.1), 2)), 1e-14);
}

}  // namespace laws_test
}  // namespace mixity
