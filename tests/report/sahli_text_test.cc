#include "report/sahli_text.h"

#include <gtest/gtest.h>

#include "dataset/load_text.h"

namespace mixity {
namespace sahli_text_test {

TEST(SahliText, NamesTheRowsLeftOutAndTheRunsWithoutAParabola) {
  const Dataset data =
      load_text("curve,P,T,A\nx,1,0,18\nx,1,1,nan\nx,1,2,17.8\nx,1,3,-1\nx,1,4,17\ny,1,2,18\ny,1,2,18.1\n");
  const std::string text = sahli_text(data, fit_sahli(data, 1, "", {}), "");
  EXPECT_NE(text.find("[[Excluded]]\n    line 3: A is not finite\n    line 5: A <= 0\n[[A = A0 - alpha T^2]]"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("\n    y: all T used are equal, no parabola\n"), std::string::npos) << text;
}

TEST(SahliText, AsCsvIsInTheUnitsOfTheFile) {
  const Dataset data = load_text("P [mN],T [mN],A [mm^2]\n1,0,0.25\n1,0.2,0.248\n1,0.4,0.242\n",
                                 "radius = \"9.42 mm\"\nmodulus = \"2.133 MPa\"\ntoughness = \"27 mJ/m^2\"\n");
  const std::string csv = sahli_csv(data, fit_sahli(data, 1, "", {}));
  EXPECT_TRUE(
      csv.starts_with("provenance,curve,P [mN],points,A0 [mm^2],A0_stderr [mm^2],alpha [mm^2/mN^2],"
                      "alpha_stderr [mm^2/mN^2],alpha_predicted [mm^2/mN^2]\nunstated,P=1 mN,"))
      << csv;
  // three points on a parabola: alpha = (0.25 - 0.242)/0.4^2
  const std::size_t at = csv.find(",3,") + 3, alpha = csv.find(',', csv.find(',', at) + 1) + 1;
  EXPECT_NEAR(std::stod(csv.substr(at)), 0.25, 1e-14);  // roundings of the units and of the normal equations
  EXPECT_NEAR(std::stod(csv.substr(alpha)), 0.05, 1e-13);
}

}  // namespace sahli_text_test
}  // namespace mixity
