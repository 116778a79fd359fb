#include <gtest/gtest.h>

#include <algorithm>

#include "report/figures/svg.h"

namespace mixity {
namespace kept_svg_test {

constexpr const char* kDrawn =
    "<?xml version=\"1.0\"?><svg viewBox=\"0 0 4 3\" xmlns:xlink=\"http://www.w3.org/1999/xlink\"><g id=\"canvas\">"
    "<rect width=\"4\" height=\"3\" fill=\"#ffffff\"/><path id=\"mark\" stroke=\"rgb(213,  94,   0)\"/>"
    "<use xlink:href=\"#mark\" color=\"black\"/><path stroke=\"#123456\"/><g></g></g></svg>";

TEST(KeptSvg, OnAPageTakesItsColoursFromThePagesStyle) {
  const std::string page = themed_svg(kDrawn);
  EXPECT_NE(page.find("stroke=\"var(--color-1)\""), std::string::npos) << page;
  EXPECT_NE(page.find("color=\"var(--ink)\""), std::string::npos) << page;
  EXPECT_NE(page.find("stroke=\"#123456\""), std::string::npos) << page;  // none of ours: left as it is
  EXPECT_EQ(page.find("<rect"), std::string::npos) << page;               // the background
  EXPECT_EQ(page.find("<?xml"), std::string::npos) << page;
}

std::string drawing(const std::string& inside, const std::string& on_root = "") {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 4 3\"" + on_root +
         "><title>T(t)</title><desc>Seen.</desc>" + inside + "</svg>";
}

TEST(KeptSvg, IsRebuiltFromWhatOurDrawingsUse) {
  const std::string ours =
      "<g font-family=\"Helvetica,Arial\" font-size=\"13\"><path fill=\"#0072b2\" d=\"M0 0h1\"><title>a &lt; "
      "b</title></path>"
      "<text x=\"1\" y=\"2\" text-anchor=\"middle\" transform=\"translate(1 2)rotate(-90)\">T<tspan "
      "dy=\"3\">c</tspan></text></g>";
  const auto [figure, reason, dropped] = kept_figure(drawing(ours, " width=\"99999\""), "log_1");
  ASSERT_TRUE(figure) << reason;
  EXPECT_TRUE(dropped.empty());
  EXPECT_EQ(figure->title, "T(t)");
  EXPECT_EQ(figure->caption, "Seen.");
  EXPECT_EQ(figure->drawn,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 4 3\" role=\"img\" aria-label=\"T(t). Seen.\">"
            "<title>T(t)</title><desc>Seen.</desc>" +
                ours + "</svg>");
}

/// Each of these, in any case and with any prefix, is dropped, and said.
TEST(KeptSvg, KeepsNothingElse) {
  const std::vector<std::pair<std::string, std::string>> others{
      {"<script>mark()</script>", "'script'"},
      {"<SCRIPT>mark()</SCRIPT>", "'SCRIPT'"},
      {"<s:script xmlns:s=\"http://www.w3.org/2000/svg\">mark()</s:script>", "'s:script'"},
      {"<style>*{display:none}</style>", "'style'"},
      {"<foreignObject><p>mark</p></foreignObject>", "'foreignObject'"},
      {"<image href=\"mark.png\"/>", "'image'"},
      {"<use href=\"#mark\"/>", "'use'"},
      {"<a href=\"mark\"><text>mark</text></a>", "'a'"},
      {"<animate attributeName=\"x\" to=\"mark\"/>", "'animate'"},
      {"<set attributeName=\"x\" to=\"mark\"/>", "'set'"},
      {"<svg><g/></svg>", "'svg'"},
      {"<path onclick=\"mark()\"/>", "'onclick'"},
      {"<path ONCLICK=\"mark()\"/>", "'ONCLICK'"},
      {"<path style=\"mark:none\"/>", "'style'"},
      {"<path class=\"mark\" d=\"M0 0\"/>", "'class'"},
      {"<path id=\"mark\"/>", "'id'"},
      {"<path x:href=\"mark\" xmlns:x=\"http://www.w3.org/1999/xlink\"/>", "'x:href'"},
      {"<path fill=\"url(#mark)\"/>", "'fill'"},
      {"<path fill=\"URL(mark)\"/>", "'fill'"},
      {"<path d=\"mark:1\"/>", "'d'"},
  };
  for (const auto& [inside, name] : others) {
    const auto [figure, reason, dropped] = kept_figure(drawing(inside), "log_1");
    ASSERT_TRUE(figure) << inside;
    EXPECT_EQ(figure->drawn.find("mark"), std::string::npos) << figure->drawn;
    EXPECT_NE(std::find(dropped.begin(), dropped.end(), name), dropped.end()) << inside;
  }
  const auto outermost = kept_figure(drawing("", " onload=\"mark()\""), "log_1");
  EXPECT_EQ(outermost.dropped, std::vector<std::string>{"'onload'"});
}

TEST(KeptSvg, IsRefusedWithAReason) {
  EXPECT_EQ(kept_figure("<html/>", "x").reason, "is no SVG");
  EXPECT_EQ(kept_figure("", "x").reason, "is no SVG");
  EXPECT_EQ(kept_figure("<svg/>", "x").reason, "has no viewBox");
  std::string deep;
  for (int i = 0; i < 30000; ++i) deep += "<g>";
  for (int i = 0; i < 30000; ++i) deep += "</g>";
  EXPECT_EQ(kept_figure(drawing(deep), "x").reason, "is nested more deeply than a drawing");
}

}  // namespace kept_svg_test
}  // namespace mixity
