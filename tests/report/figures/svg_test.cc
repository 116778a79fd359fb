#include "report/figures/svg.h"

#include <gtest/gtest.h>

#include "report/output_file.h"

namespace mixity {
namespace {

constexpr const char* kDrawn =
    "<?xml version=\"1.0\"?><svg viewBox=\"0 0 4 3\" xmlns:xlink=\"http://www.w3.org/1999/xlink\"><g id=\"canvas\">"
    "<rect width=\"4\" height=\"3\" fill=\"#ffffff\"/><path id=\"mark\" stroke=\"rgb(213,  94,   0)\"/>"
    "<use xlink:href=\"#mark\" color=\"black\"/><path stroke=\"#123456\"/><g></g></g></svg>";

TEST(Svg, OfAPageTakesItsColoursFromThePagesStyle) {
  const std::string page = inline_svg(kDrawn);
  EXPECT_NE(page.find("stroke=\"var(--color-1)\""), std::string::npos) << page;
  EXPECT_NE(page.find("color=\"var(--ink)\""), std::string::npos) << page;
  EXPECT_NE(page.find("stroke=\"#123456\""), std::string::npos) << page;  // none of ours: left as it is
  EXPECT_EQ(page.find("<rect"), std::string::npos) << page;               // the background
  EXPECT_EQ(page.find("<?xml"), std::string::npos) << page;
}

TEST(Svg, LosesGroupsThatDrawNothing) {
  EXPECT_EQ(readable_svg(kDrawn, {"f", "title", {}, {}, {}}).find("<g/>"), std::string::npos);
}

TEST(Svg, ThatIsNoneIsRefused) {
  EXPECT_THROW(readable_svg("", {"f", "title", {}, {}, {}}), OutputError);
  EXPECT_THROW(readable_svg("<html/>", {"f", "title", {}, {}, {}}), OutputError);
}

}  // namespace
}  // namespace mixity
