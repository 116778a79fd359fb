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

/// A drawing that is kept is XML that every reader takes.
TEST(KeptSvg, IsWellFormedWhateverItWasMadeOf) {
  const auto twice = kept_figure(drawing("<g fill=\"red\" fill=\"blue\"/>"), "log_1");
  EXPECT_NE(twice.figure->drawn.find("<g fill=\"red\"/>"), std::string::npos) << twice.figure->drawn;
  const auto texts = kept_figure(
      "<svg viewBox=\"0,0 4 3\"><title>a&#1;\xff\n&#xFFFE;b</title><text>\x02&#8;t<![CDATA[\x80]]></text></svg>",
      "log_1");
  ASSERT_TRUE(texts.figure) << texts.reason;
  EXPECT_EQ(texts.figure->title, "a?? ?b");
  EXPECT_NE(texts.figure->drawn.find("<text>??t?</text>"), std::string::npos) << texts.figure->drawn;
  const auto control = kept_figure(drawing("<path d=\"M0&#11;0\"/>"), "log_1");
  EXPECT_EQ(control.figure->drawn.find("d="), std::string::npos) << control.figure->drawn;
  const auto long_title =
      kept_figure("<svg viewBox=\"0 0 4 3\"><title>" + std::string(100000, 'A') + "</title></svg>", "log_1");
  EXPECT_LT(long_title.figure->drawn.size(), 10000u);
}

TEST(KeptSvg, NamesAFewOfManyDroppedParts) {
  std::string many;
  for (int i = 0; i < 1000; ++i) many += "<e" + std::to_string(i) + "/>";
  const auto dropped = kept_figure(drawing(many), "log_1").dropped;
  ASSERT_EQ(dropped.size(), 21u);
  EXPECT_EQ(dropped.back(), "980 others");
  EXPECT_TRUE(kept_figure(drawing("", " xmlns:xlink=\"http://www.w3.org/1999/xlink\""), "log_1").dropped.empty());
}

TEST(KeptSvg, IsRefusedWithAReason) {
  EXPECT_EQ(kept_figure("<html/>", "x").reason, "is no SVG");
  EXPECT_EQ(kept_figure("", "x").reason, "is no SVG");
  EXPECT_EQ(kept_figure("<svg/>", "x").reason, "has no viewBox");
  for (const char* box :
       {"", "0 0 1", "0 0 1 1000000", "0 0 9 1", "0 0 -4 3", "0 0 nan 1", "0 0 4 3 onload", "0 0 inf inf"})
    EXPECT_EQ(kept_figure("<svg viewBox=\"" + std::string(box) + "\"/>", "x").reason,
              "has a viewBox that is not that of a drawing")
        << box;
  EXPECT_EQ(kept_figure(drawing(std::string(5000000, ' ')), "x").reason, "is larger than a drawing, 4 MB");
  std::string deep;
  for (int i = 0; i < 30000; ++i) deep += "<g>";
  for (int i = 0; i < 30000; ++i) deep += "</g>";
  EXPECT_EQ(kept_figure(drawing(deep), "x").reason, "is nested more deeply than a drawing");
}

}  // namespace kept_svg_test
}  // namespace mixity
