// mixity predict as its users run it.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>
#include <string>

#include "cli/run_program.h"
#include "mechanics/contact.h"

namespace mixity::cli {
namespace command_predict_test {

Words predict(const std::string& model, const std::string& lambda, const std::string& load, const std::string& shear) {
  return {"predict", "--model=" + model, "--lambda=" + lambda, "--load=" + load, "--shear=" + shear};
}

TEST(Program, PredictPrintsTheStateOfTheContact) {
  const ProgramResult result = run_program(predict("c", "0.15", "3", "0,5,10"));
  EXPECT_EQ(result.exit_code, 0);
  const auto lines = lines_of(result.out);
  ASSERT_EQ(lines.size(), 4);
  EXPECT_EQ(lines[0], "P,T,y,a,A,u,psi,f,status");
  // 40-digit values of y = 3 pi + sqrt(S0^2 - lambda T^2) and what follows from it: P,T,y,a,A,u,psi,f
  const double expected[3][8] = {{3, 0, 21.481937965282072001, 2.6381674166806312105, 21.865256533115421488, 0, 0, 1},
                                 {3, 5, 21.325412707471780121, 2.6325330177151248652, 21.771959936421260852,
                                  1.4244835581415677977, 0.23030210374310519908, 1.0463444352260184483},
                                 {3, 10, 20.842969909340769267, 2.6150131152775343643, 21.483132915089906459,
                                  2.8680544492045564107, 0.44733959213407412308, 1.1891287063405536673}};
  for (std::size_t row = 0; row < 3; ++row) {
    const auto fields = fields_of(lines[row + 1]);
    ASSERT_EQ(fields.size(), 9);
    // 2e-15: 4e-15 is promised for the area near folds; far from one each number is within a few roundings
    for (std::size_t i = 0; i < 8; ++i)
      EXPECT_NEAR(std::strtod(fields[i].c_str(), nullptr), expected[row][i], 2e-15 * expected[row][i])
          << lines[row + 1];
    EXPECT_EQ(fields[8], "ok");
  }
}

TEST(Program, OneLoadHasEitherNameAndADecimalPointOrComma) {
  const auto predicted = [](const std::string& load, const std::string& radius = "9.42 mm") {
    return run_program({"predict", "--model=c", "--lambda=0.004", load, "--shear=1,2 mN", "--radius=" + radius,
                        "--modulus=2.133 MPa", "--toughness=27 mJ/m^2"});
  };
  const ProgramResult right = predicted("--load=3.5 mN");
  ASSERT_EQ(right.exit_code, 0) << right.err;
  EXPECT_EQ(predicted("--loads=3.5 mN").out, right.out);
  EXPECT_EQ(fields_of(lines_of(predicted("--load=1200 uN").out)[1])[0], "1.2");
  EXPECT_EQ(predicted("--load=3.5 mN", "9,42 mm").out, right.out);
  EXPECT_EQ(predicted("--load=2,133 mN").complaint(),
            "mixity: flag '--load' is '2,133 mN'; write \"2.133 mN\" or \"2133 mN\"");
  EXPECT_EQ(predicted("--load=3,5 mN").out, right.out);
  EXPECT_NE(predicted("--loads=3,5 mN")
                .complaint()
                .find("it must be one number: write \"3.5 mN\" if the comma is a decimal comma"),
            std::string::npos);  // or two loads
  EXPECT_EQ(predicted("--loads=1,2,3 mN").complaint(), "mixity: flag '--loads' is '1,2,3 mN'; it must be one number");
  EXPECT_EQ(predicted("--load=1 mN", "9.42 mm").exit_code, 0);
  for (const char* command : {"curve", "instability"})
    EXPECT_EQ(run_program({command, "--model=c", "--lambda=0.2", "--loads=2"}).out,
              run_program({command, "--model=c", "--lambda=0.2", "--load=2"}).out);
}

TEST(Program, PredictWithUnitsIsTheSameContact) {
  Words words = predict("c", "0.1", "1 mN", "1e-6 kN");
  for (const char* word : {"--radius=9.42 mm", "--modulus=2.133 MPa", "--toughness=27 mJ/m^2"}) words.push_back(word);
  const auto lines = lines_of(run_program(words).out);
  ASSERT_EQ(lines.size(), 2);
  EXPECT_EQ(lines[0], "P [mN],T [mN],y [mN],a [mm],A [mm^2],u [mm],psi [rad],f,status");
  const auto fields = fields_of(lines[1]);
  // From 40-digit arithmetic. 1e-14: as above, and some roundings of the units.
  const double expected[8] = {1,
                              1,
                              5.6282394660238226479,
                              0.28000975849390140791,
                              0.24631803237974844134,
                              0.0012557328077288897912,
                              0.17584043438146653771,
                              1.0283223006812439148};
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_NEAR(std::strtod(fields[i].c_str(), nullptr), expected[i], 1e-14 * expected[i]) << lines[1];
}

TEST(Program, BeyondTheLastEquilibriumAreEmptyFields) {
  // Model c at P = 3, lambda = 0.15 ends at T = sqrt(3 pi (3 pi + 6)/0.15) = 31.1314532666905; at P < -3 pi/2 = -4.712
  // there is no contact at all.
  const auto lines = lines_of(run_program(predict("c", "0.15", "3", "31.1314,31.1315,1e100")).out);
  ASSERT_EQ(lines.size(), 4);
  EXPECT_TRUE(lines[1].ends_with(",ok")) << lines[1];
  EXPECT_EQ(lines[2], "3,31.1315,,,,,,,no_equilibrium");
  EXPECT_EQ(lines[3], "3,1e+100,,,,,,,no_equilibrium");
  EXPECT_EQ(lines_of(run_program(predict("a", "0.5", "-4.713", "0")).out).at(1), "-4.713,0,,,,,,,no_equilibrium");
}

TEST(Program, PredictNeverPrintsNan) {
  for (const char* model : {"a", "b", "c"})
    for (const char* lambda : {"0", "1e-300", "1e-6", "0.5", "1"})
      for (const char* load : {"-4.71238898038469", "-4.7", "0", "1e4", "1e149"}) {
        const ProgramResult result = run_program(predict(model, lambda, load, "0,1e-300,1e-3,1,30,1e6,1e150"));
        const std::string what = joined({model, lambda, load}) + result.out + result.err;
        EXPECT_EQ(result.exit_code, 0) << what;
        EXPECT_EQ(lines_of(result.out).size(), 8) << what;
        EXPECT_EQ(result.out.find("nan"), std::string::npos) << what;
        EXPECT_EQ(result.out.find("inf"), std::string::npos) << what;
      }
}

/// Reference states as in HeldApproach.HasTheStatesOfAReferenceSolution.
TEST(Program, PredictsUnderAHeldApproach) {
  const Words words{"predict", "--model=c", "--lambda=0.15", "--approach=5", "--shear=20,1000"};
  const ProgramResult rigid = run_program(words);
  const auto lines = lines_of(rigid.out);
  ASSERT_EQ(lines.size(), 3) << rigid.err;
  EXPECT_NEAR(std::strtod(fields_of(lines[1])[0].c_str(), nullptr), 11.7692054217687455, 1e-10);
  EXPECT_NEAR(std::strtod(fields_of(lines[1])[3].c_str(), nullptr), 3.02824894168804244, 1e-12);
  EXPECT_EQ(lines[2], ",1000,,,,,,,no_equilibrium");
  EXPECT_NE(rigid.err.find("the contact jumps at T = "), std::string::npos) << rigid.err;
  // with dimensions: the same contact
  const double unit = Contact{9.42e-3, 2.133e6, 27e-3}.displacement_unit();
  const ProgramResult shown =
      run_program({"predict", "--model=c", "--lambda=0.15", "--approach=" + std::to_string(5e6 * unit) + " um",
                   "--normal_stiffness=1e9 kN/m", "--shear=1 mN", "--radius=9.42 mm", "--modulus=2.133 MPa",
                   "--toughness=27 mJ/m^2"});
  EXPECT_EQ(lines_of(shown.out).at(0).substr(0, 15), "P [mN],T [mN],y") << shown.err;
  for (const Words& wrong :
       {Words{"predict", "--model=c", "--lambda=0.15", "--approach=5", "--load=3", "--shear=2"},
        Words{"predict", "--model=c", "--lambda=0.15", "--approach=5 um", "--shear=2"},
        Words{"predict", "--model=c", "--lambda=0.15", "--load=5", "--normal_stiffness=3", "--shear=2"},
        Words{"predict", MIXITY_ROOT "/data/mergel2018.csv", "--approach=5 um", "--shear=2 mN"}})
    EXPECT_EQ(run_program(wrong).exit_code, 2) << joined(wrong);
}

Words predict_ellipse(const Words& more) {
  Words words{"predict", "--shape=ellipse", "--load=3"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// Reference axes as in Ellipses.HaveTheAxesOfAReferenceSolution.
TEST(Program, PredictsTheAxesOfAnEllipse) {
  const ProgramResult result = run_program(predict_ellipse(
      {"--model=c", "--lambda_II=0.008", "--lambda_III=0", "--poisson_ratio=0.5", "--shear=0,95.3202193183654,180"}));
  const auto lines = lines_of(result.out);
  ASSERT_EQ(lines.size(), 4) << result.err;
  EXPECT_EQ(lines[0], "P,T,a,b,A,u,psi_II,psi_III,status");
  const auto fields = fields_of(lines[2]);
  EXPECT_NEAR(std::strtod(fields[2].c_str(), nullptr), 2.54799398314334041, 1e-12);
  EXPECT_NEAR(std::strtod(fields[3].c_str(), nullptr), 2.60750787687640354, 1e-12);
  EXPECT_EQ(lines[3], "3,180,,,,,,,no_equilibrium");
  EXPECT_NE(result.err.find("the contact jumps at T = 175."), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("under displacement control at T = "), std::string::npos) << result.err;
  EXPECT_EQ(result.exit_code, 0);
}

TEST(Program, TheCurveOfAnEllipseIsRefused) {
  const ProgramResult result = run_program({"curve", "--model=c", "--lambda=0.1", "--load=3", "--shape=ellipse"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("mixity predict --shape=ellipse"), std::string::npos) << result.err;
}

TEST(Program, AnEllipseHasParametersOfBothModesAndPoissonsRatio) {
  const auto says = [](Words more, const char* text) {
    more.emplace_back("--shear=1");
    const ProgramResult result = run_program(predict_ellipse(more));
    EXPECT_NE(result.err.find(text), std::string::npos) << result.err;
    EXPECT_EQ(result.exit_code, 2);
  };
  says({"--model=c", "--lambda_II=0.1", "--poisson_ratio=0.5"}, "model c of an ellipse needs --lambda_III");
  says({"--model=c", "--lambda=0.1", "--poisson_ratio=0.5"}, "needs --lambda_II");
  says({"--model=c", "--lambda_II=0.1", "--lambda_III=0.1"}, "needs --poisson_ratio");
  says({"--model=bk", "--parameters=r_II=3,eta_II=2,r_III=2", "--poisson_ratio=0.5"}, "needs --parameters=eta_III=...");
  says({"--model=c", "--lambda_II=0.1", "--lambda_III=2", "--poisson_ratio=0.5"}, "lambda_III is '2'");
}

}  // namespace command_predict_test
}  // namespace mixity::cli
