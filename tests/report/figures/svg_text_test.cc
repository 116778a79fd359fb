#include "report/figures/svg_text.h"

#include <gtest/gtest.h>

namespace mixity {
namespace svg_text_test {

TEST(SvgText, RoundsNumbersToHundredths) {
  SvgText text;
  text << 1.0 << " " << -0.251 << " " << 12.346 << " " << -0.001 << " " << 0.5 << " " << 100;
  EXPECT_EQ(text.text, "1 -0.25 12.35 0 0.5 100");
}

TEST(SvgText, SetsIndicesLowerAndPowersHigher) {
  EXPECT_EQ(label_markup("T < 1", 10), "T &lt; 1");
  EXPECT_EQ(label_markup("G_{Ic}", 10), "G<tspan dy=\"2\" font-size=\"7\">Ic</tspan>");
  EXPECT_EQ(label_markup("A_0 ξ^2/R", 10),
            "A<tspan dy=\"2\" font-size=\"7\">0</tspan><tspan dy=\"-2\"> ξ</tspan>"
            "<tspan dy=\"-4\" font-size=\"7\">2</tspan><tspan dy=\"4\">/R</tspan>");
  EXPECT_EQ(label_markup("run\\_1\\^\\{x\\}", 10), "run_1^{x}");
  EXPECT_EQ(label_markup("a_", 10), "a_");
}

TEST(SvgText, MeasuresWhatIsSetAndNotItsMarkup) {
  EXPECT_EQ(label_width("A_0", 10), label_width("A_{0}", 10));
  EXPECT_LT(label_width("A_0", 10), label_width("A0", 10));
  EXPECT_EQ(label_width("ψ", 10), label_width("n", 10));  // one letter of two bytes
  EXPECT_NEAR(label_width("n", 20), 2 * label_width("n", 10), 1e-12);
}

TEST(SvgText, HasCharactersOfXmlAlone) {
  EXPECT_EQ(xml_escaped("a\x01"
                        "b\n<\xEF\xBF\xBE\xEF\xBF\xBFz\xEF\xBF\xBD"),
            "a b &lt;  z\xEF\xBF\xBD");
}

}  // namespace svg_text_test
}  // namespace mixity
