// Reports of many sets, whose figures lie in files beside the page, and of few, whose page holds them.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>

#include "base/files.h"
#include "dataset/temporary_folder.h"
#include "report/example_results.h"
#include "report/report.h"

namespace mixity {
namespace figures_beside_test {

/// A report of two data sets whose page may hold so many bytes of drawings.
class TwoSets {
 public:
  explicit TwoSets(std::size_t most_inside) {
    const std::vector<Analysis> results{shipped("mergel2018"), shipped("waters_guduru2010")};
    const std::vector<ReportedData> data{reported_data(results[0], "m"), reported_data(results[1], "w")};
    ReportSettings settings{"mixity report", {}};
    settings.most_inside = most_inside;
    write_report(results, data, folder_.path("out"), settings);
    page_ = read_file(path("report.html"));
  }
  const std::string& page() const { return page_; }
  std::string path(const std::string& name) const { return folder_.path("out/" + name); }

  /// What stands in quotes behind `before`, wherever that stands.
  std::vector<std::string> all(const std::string& before) const {
    std::vector<std::string> found;
    const std::regex pattern(before + "\"([^\"]*)\"");
    for (std::sregex_iterator at(page_.begin(), page_.end(), pattern), end; at != end; ++at) found.push_back((*at)[1]);
    return found;
  }
  std::size_t count(const std::string& text) const {
    std::size_t n = 0;
    for (std::size_t at = 0; (at = page_.find(text, at)) != std::string::npos; at += text.size()) ++n;
    return n;
  }

 private:
  TemporaryFolder folder_;
  std::string page_;
};

/// One report of either kind for all tests.
const TwoSets& few() {
  static const TwoSets report(ReportSettings{}.most_inside);
  return report;
}
const TwoSets& many() {
  static const TwoSets report(100'000);
  return report;
}

TEST(ReportOfManySets, KeepsItsFiguresBesideThePage) {
  EXPECT_EQ(many().count("<svg"), 0u);
  EXPECT_LT(many().page().size(), few().page().size() / 5);
  EXPECT_EQ(many().count("<figure"), few().count("<figure"));
  EXPECT_NE(many().page().find("figures lie in the folder figures beside this page"), std::string::npos);
}

TEST(ReportOfManySets, HasEveryFigureThatThePageShows) {
  const std::vector<std::string> shown = many().all("<img [^>]*src=");
  EXPECT_GE(shown.size(), many().count("<figure"));
  for (const std::string& file : shown) {
    ASSERT_TRUE(std::filesystem::exists(many().path(file))) << file;
    EXPECT_TRUE(read_file(many().path(file)).starts_with("<svg")) << file;
  }
  for (const std::string& file : many().all("<a href="))
    EXPECT_TRUE(file.starts_with('#') || std::filesystem::exists(many().path(file))) << file;
}

TEST(ReportOfManySets, ShowsWideFiguresAsTheyAreDrawnForPhonesToo) {
  std::size_t narrow = 0;
  for (const std::string& file : many().all("<img [^>]*src=")) narrow += file.ends_with("_narrow.svg");
  // one for each that a small report draws for phones, and the one beside the result
  EXPECT_EQ(narrow, few().count("class=\"plot narrow\"") + 1);
}

TEST(ReportOfManySets, LoadsFiguresOnlyOfSetsThatAreOpened) {
  EXPECT_EQ(many().count("<details class=\"set\"><summary>"), 2u);
  EXPECT_EQ(many().count("<img loading=\"lazy\""), many().count("<img"));
  EXPECT_GT(many().page().find("<img"), many().page().find("<details class=\"set\""));
}

TEST(ReportOfManySets, LetsNothingBeLoadedButDrawings) {
  EXPECT_NE(many().page().find("default-src 'none'; img-src 'self' file:; style-src 'unsafe-inline'; base-uri"),
            std::string::npos);
}

TEST(ReportOfManySets, NamesEverySetAndItsResultWhereItIsOpened) {
  for (const char* line : {"<h2>mergel2018</h2> <span>λ = 0.002306 ± 0.000011,</span> <span>model c</span></summary>",
                           "<h2>waters_guduru2010</h2>"})
    EXPECT_NE(many().page().find(line), std::string::npos) << line;
  for (const char* stem : {"m", "w"}) EXPECT_EQ(many().count("<div id=\"" + std::string(stem) + "\">"), 1u);
  EXPECT_NE(many().page().find("<h1>2 data sets</h1>"), std::string::npos);
}

TEST(ReportOfManySets, NamesEveryFigureForThoseWhoCannotSeeIt) {
  const std::vector<std::string> names = many().all("<img [^>]*alt=");
  EXPECT_EQ(names.size(), many().count("<img"));
  for (const std::string& name : names) EXPECT_GT(name.size(), 5u);
}

TEST(ReportOfSeveralSets, BeginsWithATableThatComparesThemAndLinksToEach) {
  for (const TwoSets* report : {&few(), &many()}) {
    const std::string header = report->page().substr(0, report->page().find("</header>"));
    for (const char* cell :
         {"<a href=\"#m\">mergel2018</a>", "<a href=\"#w\">waters_guduru2010</a>",
          "<div>λ = 0.002306 ± 0.000011 (0.002285 .. 0.002328)</div>", "<div>provenance: reconstructed</div>"})
      EXPECT_NE(header.find(cell), std::string::npos) << cell;
    for (const char* stem : {"m", "w"}) EXPECT_EQ(report->count(" id=\"" + std::string(stem) + '"'), 1u);
  }
}

TEST(ReportOfFewSets, HoldsItsFiguresAndNeedsNoOtherFile) {
  EXPECT_EQ(few().count("<img"), 0u);
  EXPECT_GE(few().count("<svg"), few().count("<figure"));
  EXPECT_EQ(few().count("img-src"), 0u);
  EXPECT_EQ(few().count("class=\"set\""), 0u);
  for (const auto& entry : std::filesystem::directory_iterator(few().path("figures")))
    EXPECT_EQ(entry.path().string().find("_narrow"), std::string::npos) << entry.path();
}

}  // namespace figures_beside_test
}  // namespace mixity
