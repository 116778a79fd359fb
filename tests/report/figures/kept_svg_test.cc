#include <gtest/gtest.h>

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

TEST(KeptSvg, IsKeptWithoutWhatRunsOrIsLookedUpElsewhere) {
  const auto kept = kept_figure(
      "<svg xmlns:xlink=\"http://www.w3.org/1999/xlink\" onload=\"f()\"><title>T(t)</title><desc>Seen.</desc>"
      "<script>f()</script><style>p{}</style><g><image href=\"http://x/\"/><use xlink:href=\"#mark\"/>"
      "<path id=\"mark\" onclick=\"f()\" d=\"M0 0\" clip-path=\"url(#c)\"/></g></svg>",
      "log_1");
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->title, "T(t)");
  EXPECT_EQ(kept->caption, "Seen.");
  for (const char* text : {"script", "style", "image", "onload", "onclick", "http://x/"})
    EXPECT_EQ(kept->drawn.find(text), std::string::npos) << text;
  // ids are those of no other figure of the page
  for (const char* text : {"<use xlink:href=\"#log_1-mark\"", "id=\"log_1-mark\"", "clip-path=\"url(#log_1-c)\""})
    EXPECT_NE(kept->drawn.find(text), std::string::npos) << kept->drawn;
  EXPECT_NE(kept->drawn.find("role=\"img\" aria-label=\"T(t). Seen.\""), std::string::npos) << kept->drawn;
  EXPECT_FALSE(kept_figure("<html/>", "x"));
  EXPECT_FALSE(kept_figure("", "x"));
}

}  // namespace kept_svg_test
}  // namespace mixity
