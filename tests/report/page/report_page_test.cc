// What stands on the page, read back from its HTML.
#include <gtest/gtest.h>

#include <pugixml.hpp>
#include <regex>
#include <set>
#include <utility>

#include "report/example_results.h"
#include "report/fit_table.h"
#include "report/page/sentence.h"
#include "report/report.h"

namespace mixity {
namespace report_page_test {

/// The page as XML: HTML but for the line that says so and meta, which nothing closes.
class Parsed {
 public:
  explicit Parsed(std::string page) {
    EXPECT_TRUE(page.starts_with("<!DOCTYPE html>\n"));
    page.erase(0, page.find('\n') + 1);
    for (std::size_t at; (at = page.find("<meta")) != std::string::npos;) page.erase(at, page.find('>', at) + 1 - at);
    const pugi::xml_parse_result parsed = document_.load_string(page.c_str());
    EXPECT_TRUE(parsed) << parsed.description() << " near " << page.substr(static_cast<std::size_t>(parsed.offset), 80);
  }
  pugi::xpath_node_set all(const char* path) const { return document_.select_nodes(path); }
  pugi::xml_node first(const char* path) const { return document_.select_node(path).node(); }

 private:
  pugi::xml_document document_;
};

/// All text below a node, with blanks between its parts.
std::string text_of(const pugi::xml_node& node) {
  std::string text;
  for (const pugi::xpath_node& part : node.select_nodes(".//text()"))
    text += (text.empty() ? "" : " ") + std::string(part.node().value());
  return text;
}

/// A sentence as a page shows it, without markup.
std::string shown(const std::string& text) {
  std::string words = std::regex_replace(sentence(text), std::regex("</?sub>"), " ");
  for (const auto& [entity, sign] : {std::pair("&lt;", "<"), std::pair("&gt;", ">"), std::pair("&amp;", "&")})
    words = std::regex_replace(words, std::regex(entity), sign);
  return words;
}

ReportContent content_of(const ReportedData& data) { return {{"mixity report x.toml", {}}, {{&data, &data, {}}}, {}}; }

TEST(ReportPage, SaysFirstWhereTheDataComeFrom) {
  const ReportedData data = without_figures(shipped("mergel2018"), "mergel2018");
  const Parsed page(report_page(content_of(data)));
  const pugi::xml_node banner = page.first("//section/*[1]");
  EXPECT_STREQ(banner.attribute("class").value(), "banner");
  const std::string text = text_of(banner);
  EXPECT_TRUE(text.starts_with("Provenance: reconstructed.")) << text;
  EXPECT_NE(text.find(" Generated from a model, not measured."), std::string::npos) << text;
}

TEST(ReportPage, IsCalledByTheTitleOfTheData) {
  Analysis result = example(FitStatus::ok);
  const auto heading = [&] {
    return text_of(Parsed(report_page(content_of(without_figures(result, "x")))).first("//h1"));
  };
  EXPECT_EQ(heading(), "example");  // the file's name
  result.data.metadata.title = "Glass on silicone, second day";
  EXPECT_EQ(heading(), "Glass on silicone, second day");
}

TEST(ReportPage, NamesTheOnlyDataSetOnce) {
  const Analysis result = example(FitStatus::ok);
  const ReportedData data = without_figures(result, "x");
  for (const bool inside : {true, false}) {
    ReportContent content = content_of(data);
    content.figures_inside = inside;
    const std::string page = report_page(content);
    EXPECT_EQ(page.find("<h2>example"), std::string::npos) << page;
    EXPECT_NE(page.find("<section id=\"x\">"), std::string::npos) << page;
  }
}

TEST(ReportPage, LeadsWithTheResultOfTheBestModelAndItsJumps) {
  const Analysis result = shipped("mergel2018");
  const ReportedData data = without_figures(result, "mergel2018");
  const Parsed page(report_page(content_of(data)));
  EXPECT_EQ(text_of(page.first("//p[@class='result']")), "λ = 0.002306 ± 0.000011");
  const auto rows = page.all("//table[@class='jumps']/tbody/tr");
  ASSERT_EQ(rows.size(), 8u);
  EXPECT_EQ(text_of(rows[0].node()), "7.732 136.26 ± 0.32 0.3268 137");
  EXPECT_EQ(page.all("//details[@open]").size(), 0u);
}

TEST(ReportPage, HoldsTheFitTable) {
  const ReportedData data = without_figures(shipped("mergel2018"), "mergel2018");
  const Parsed page(report_page(content_of(data)));
  const FitTable table = fit_table(shipped("mergel2018"));
  const auto cells = page.all("//table[@class='fits']/tbody/tr/*");
  ASSERT_EQ(cells.size(), table.rows.size() * table.headings.size());
  std::size_t i = 0;
  for (const auto& row : table.rows)
    for (const FitTable::Cell& cell : row) {
      std::string text;
      for (const std::string& line : cell.lines) text += (text.empty() ? "" : " ") + shown(line);
      EXPECT_EQ(text_of(cells[i++].node()), text);
    }
}

TEST(ReportPage, MarksEveryStatusThatIsNotOk) {
  for (const FitStatus status : {FitStatus::ok, FitStatus::at_bound, FitStatus::not_identifiable, FitStatus::multimodal,
                                 FitStatus::not_converged}) {
    const Analysis result = example(status);
    const ReportedData data = without_figures(result, "example");
    const Parsed page(report_page(content_of(data)));
    EXPECT_EQ(page.all("//td[@class='alert']").size(), status == FitStatus::ok                 ? 0u
                                                       : status == FitStatus::not_identifiable ? 2u  // not published's
                                                       : status == FitStatus::at_bound         ? 2u
                                                                                               : 1u)
        << to_string(status);
    if (status == FitStatus::ok) continue;
    EXPECT_NE(text_of(page.first("//section")).find(shown(result.fits[0].message.text())), std::string::npos)
        << to_string(status);
  }
}

TEST(ReportPage, ListsEveryExcludedPointWithItsReason) {
  Analysis result = example(FitStatus::ok);
  for (std::size_t line = 10; line < 40; ++line) result.data.excluded.push_back({line, "T < 0"});
  result.fits[0].excluded = {{30, "infinite toughness"}};
  const ReportedData data = without_figures(result, "example");
  const Parsed page(report_page(content_of(data)));
  const pugi::xml_node points = page.first("//details[summary='Points left out']");
  EXPECT_EQ(points.select_nodes(".//li").size(), 33u);
  EXPECT_NE(text_of(points).find("line 30, model c only: infinite toughness"), std::string::npos);
}

TEST(ReportPage, ForeignTextIsNotMarkup) {
  Analysis result = example(FitStatus::ok);
  result.data.name = "<script>alert(1)</script> & \"x\"";
  result.data.metadata.source = "a < b && c > d";
  const ReportedData data = without_figures(result, "example");
  const std::string html = report_page(content_of(data));
  EXPECT_EQ(html.find("<script"), std::string::npos);
  EXPECT_EQ(text_of(Parsed(html).first("//h1")), result.data.name);
}

TEST(ReportPage, ShowsEveryFigureOnceWithLinksToItsFiles) {
  const ReportedData data = reported_data(shipped("waters_guduru2010"), "w");
  ReportContent content = content_of(data);
  content.entries[0].figures = data_figures(data);
  std::set<std::string> names;
  for (const FigureGroup& group : content.entries[0].figures.groups)
    for (const Figure& figure : group.figures) {
      names.insert(figure.name);
      content.drawn.endings[figure.name] = {".svg", ".pdf", ".png", ".dat", ".gp"};
    }
  const Parsed page(report_page(content));
  EXPECT_EQ(page.all("//figure").size(), names.size());
  for (const pugi::xpath_node& node : page.all("//figure")) {
    EXPECT_TRUE(node.node().select_node(".//*[local-name()='svg']"));
    const std::string link = node.node().select_node(".//a").node().attribute("href").value(),
                      name = link.substr(8, link.size() - 12);  // figures/NAME.svg
    EXPECT_TRUE(names.erase(name)) << name;
    for (const char* ending : {".svg", ".pdf", ".png", ".dat", ".gp"})
      EXPECT_TRUE(node.node().select_node((".//a[@href='figures/" + name + ending + "']").c_str())) << name << ending;
  }
  EXPECT_NE(text_of(page.first("//main")).find("regime map: the data are (ψ, G c )"), std::string::npos);
}

TEST(ReportPage, PrintsProfilesOfTheBestModelOnly) {
  const ReportedData data = reported_data(shipped("waters_guduru2010"), "w");
  ASSERT_EQ(data.result.fits.size(), 3u);
  ReportContent content = content_of(data);
  content.entries[0].figures = data_figures(data);
  for (const FigureGroup& group : content.entries[0].figures.groups)
    for (const Figure& figure : group.figures) content.drawn.endings[figure.name] = {".svg"};
  const Parsed page(report_page(content));
  for (const FitResult& fit : data.result.fits) {
    const std::string link = "//figure[.//a/@href='figures/w_profile_" + fit.model + ".svg']";
    const std::string classes = page.first(link.c_str()).attribute("class").value();
    EXPECT_EQ(classes.find("screen") != std::string::npos, fit.model != data.answer.fit->model) << fit.model;
  }
  const std::string common = page.first("//figure[.//a/@href='figures/w_toughness.svg']").attribute("class").value();
  EXPECT_EQ(common.find("screen"), std::string::npos);
}

TEST(ReportPage, SaysWhatIsMissingAndLinksWhatIsThere) {
  const ReportedData data = reported_data(shipped("as4_peek_mmb"), "w");
  ReportContent content = content_of(data);
  content.entries[0].figures = data_figures(data);
  content.drawn.missing = "gnuplot is not installed";
  for (const FigureGroup& group : content.entries[0].figures.groups)
    for (const Figure& figure : group.figures) content.drawn.endings[figure.name] = {".svg", ".gp"};
  const Parsed page(report_page(content));
  EXPECT_EQ(text_of(page.first("//header/p[@class='banner']")), "gnuplot is not installed");
  EXPECT_TRUE(page.first("//a[@href='figures/w_toughness.gp']"));
  EXPECT_TRUE(page.first("//a[@href='figures/w_toughness.svg']"));
  EXPECT_FALSE(page.first("//a[@href='figures/w_toughness.pdf']"));
}

TEST(ReportPage, SaysHowToMakeItAgain) {
  const ReportedData data = without_figures(shipped("mergel2018"), "mergel2018");
  const Parsed page(report_page(content_of(data)));
  const std::string footer = text_of(page.first("//footer"));
  for (const char* part : {"mixity report x.toml", "Ceres", "2.1.0"})
    EXPECT_NE(footer.find(part), std::string::npos) << part;
}

}  // namespace report_page_test
}  // namespace mixity
