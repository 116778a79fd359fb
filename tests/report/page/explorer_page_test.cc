// What of a report's data the explorer is given.
#include <gtest/gtest.h>

#include <boost/archive/iterators/binary_from_base64.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <nlohmann/json.hpp>

#include "analysis/laws.h"
#include "analysis/run.h"
#include "analysis/settings.h"
#include "base/files.h"
#include "dataset/table/workbook_files.h"
#include "report/example_results.h"
#include "report/report.h"

namespace mixity {
namespace explorer_page_test {

constexpr char kShell[] = "<p>before</p><script type=\"application/json\" id=\"data\">null</script><p>behind</p>";

std::string from_base64(std::string text) {
  using namespace boost::archive::iterators;
  using Bytes = transform_width<binary_from_base64<std::string::const_iterator>, 8, 6>;
  while (text.ends_with('=')) text.pop_back();
  return {Bytes(text.begin()), Bytes(text.end())};
}

/// The JSON between the shell's own text.
nlohmann::json embedded(const Analysis& result) {
  const ReportedData data = reported_data(result, "x");
  const std::string page = explorer_page(kShell, {{}, {{&data, &data, {}}}, {}});
  const std::size_t begin = page.find("id=\"data\">") + 10, end = page.find("</script>");
  EXPECT_TRUE(page.starts_with("<p>before</p>")) << page.substr(0, 80);
  EXPECT_TRUE(page.ends_with("</script><p>behind</p>"));
  return nlohmann::json::parse(page.substr(begin, end - begin));
}

TEST(ExplorerPage, HoldsTheFileAndWhatStandsBesideItByteForByte) {
  const auto data = embedded(shipped("mergel2018"));
  ASSERT_EQ(data.size(), 1u);
  EXPECT_EQ(data[0]["name"], "mergel2018.csv");
  EXPECT_EQ(from_base64(data[0]["content"]), read_file(MIXITY_ROOT "/data/mergel2018.csv"));
  EXPECT_EQ(from_base64(data[0]["toml"]), read_file(MIXITY_ROOT "/data/mergel2018.toml"));
}

TEST(ExplorerPage, HoldsTheSheetOfAWorkbookAsText) {
  const TemporaryFolder folder;
  const auto rows = [](const std::string& first) {
    return rows_xml({{"P [mN]", "T [mN]", "A [mm^2]"}, {"5", first, "0.4"}, {"5", "2", "0.39"}, {"5", "4", "0.37"}});
  };
  FitRequest request;
  request.data_path = folder.write("a.xlsx", zipped(workbook_parts({{"One", rows("0")}, {"Two", rows("0.5")}})));
  request.models = {"c"};
  request.constants = {{"radius", "9 mm"}, {"modulus", "2 MPa"}, {"toughness", "27 mJ/m^2"}, {"sheet", "Two"}};
  const auto data = embedded(run(request));
  EXPECT_EQ(data[0]["name"], "a.xlsx");
  EXPECT_EQ(from_base64(data[0]["content"]), "P [mN]\tT [mN]\tA [mm^2]\n5\t0.5\t0.4\n5\t2\t0.39\n5\t4\t0.37");
}

TEST(ExplorerPage, HasTheRequestsOptionsAndConstantsAndCannotBeEndedByThem) {
  Analysis result = shipped("mergel2018");
  result.request.models = {"c"};
  result.request.stated.clear();
  for (const auto& [name, text] : {std::pair("exclude", "7"), std::pair("bootstrap", "500")})
    EXPECT_EQ(set_option(result.request, name, text), "");
  result.request.constants = {{"note", "</script><script>"}};
  const auto data = embedded(result);
  EXPECT_EQ(data[0]["models"], nlohmann::json({"c"}));
  EXPECT_EQ(data[0]["options"], nlohmann::json({{"exclude", "7"}}));  // not what takes long
  EXPECT_EQ(data[0]["constants"]["note"], "</script><script>");
}

TEST(ExplorerPage, HasTheLawsOfTheRequestAsTheyAreTyped) {
  Analysis result = shipped("mergel2018");
  define_law_text("--law", "own: 1 + p*t^2; p=0..1 start 0.2");
  result.request.models = {"c", "own"};
  EXPECT_EQ(embedded(result)[0]["laws"], nlohmann::json({{"own", "1 + p*t^2; p=0..1 start 0.2"}}));
}

TEST(ExplorerPage, IsNoneWithoutAPlaceForData) {
  const Analysis result = shipped("mergel2018");
  const ReportedData data = reported_data(result, "x");
  EXPECT_EQ(explorer_page("<p>something else</p>", {{}, {{&data, &data, {}}}, {}}), "");
}

}  // namespace explorer_page_test
}  // namespace mixity
