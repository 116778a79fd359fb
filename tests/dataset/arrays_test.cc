// Arrays in memory are the data set that a file of them is.
#include "dataset/arrays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "dataset/metadata.h"
#include "dataset/table/csv_file.h"
#include "dataset/table/heading.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace arrays_test {

struct Columns {
  std::vector<std::string> headings;
  std::vector<std::vector<double>> numbers;
  std::vector<std::vector<std::string>> texts;

  explicit Columns(const std::string& path) {
    read_csv(path, [&](const CsvRow& row) {
      if (headings.empty()) {
        for (std::size_t i = 0; i < row.size(); ++i) headings.emplace_back(row[i]);
        numbers.resize(headings.size());
        texts.resize(headings.size());
        return;
      }
      for (std::size_t i = 0; i < headings.size(); ++i) {
        double value = 0;
        const bool given = row.number(i, value);
        numbers[i].push_back(given ? value : std::nan(""));
        texts[i].emplace_back(row[i]);
      }
    });
  }
  std::vector<ArrayColumn> arrays() const {
    std::vector<ArrayColumn> columns;
    for (std::size_t i = 0; i < headings.size(); ++i) {
      columns.push_back({headings[i]});
      if (headings[i] == "curve")
        columns.back().texts = texts[i];
      else
        columns.back().numbers = numbers[i];
    }
    return columns;
  }
};

TEST(Arrays, AreTheDataSetOfAFileToTheLastBit) {
  std::size_t sets = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(MIXITY_ROOT) + "/data")) {
    const std::string path = entry.path().string();
    if (entry.path().extension() != ".csv") continue;
    Dataset file;
    try {
      file = load_dataset(path);
    } catch (const InputError&) {  // peaks and logs
      continue;
    }
    ++sets;
    const Columns columns(path);
    const Dataset made = make_dataset("arrays", columns.arrays(), read_metadata(metadata_path(path)));
    ASSERT_EQ(made.points.size(), file.points.size()) << path;
    for (std::size_t i = 0; i < made.points.size(); ++i) {
      EXPECT_EQ(made.points[i].curve, file.points[i].curve);
      EXPECT_EQ(made.points[i].P, file.points[i].P);
      EXPECT_EQ(made.points[i].T, file.points[i].T);
      EXPECT_EQ(made.points[i].A, file.points[i].A);
      if (!file.has_loads) {
        EXPECT_EQ(made.converted[i].ratio, file.converted[i].ratio);
      }
    }
    EXPECT_EQ(made.errors.size(), file.errors.size());
    EXPECT_EQ(made.curves, file.curves) << path;
    EXPECT_EQ(texts_of(made.notes), texts_of(file.notes)) << path;
    EXPECT_EQ(made.excluded.size(), file.excluded.size());
  }
  EXPECT_EQ(sets, 8u);
}

TEST(Arrays, AreExcludedAndRefusedAsRowsOfAFile) {
  const double nan = std::nan(""), huge = std::numeric_limits<double>::infinity();
  const std::vector<double> P{1, 1, 1, 1}, T{0, nan, 2, huge}, A{8, 7, -1, 7}, few{1};
  const std::vector<std::string> names{"x", "x", "x", "x"};
  const Dataset data = make_dataset("mine", {{"P", P}, {"T", T}, {"A", A}}, Overrides{});
  EXPECT_EQ(data.points.size(), 1u);
  ASSERT_EQ(data.excluded.size(), 3u);
  EXPECT_EQ(data.excluded[0].reason, "T is not finite");
  EXPECT_EQ(data.excluded[0].line, 3u);
  EXPECT_EQ(data.excluded[1].reason, "A <= 0");
  const auto error = [](const std::vector<ArrayColumn>& columns, const Overrides& constants = {}) {
    return input_error([&] { make_dataset("mine", columns, constants); });
  };
  EXPECT_EQ(error({{"P", P}, {"T", few}, {"A", A}}), "mine: column 'T' has 1 rows, 'P' has 4");
  EXPECT_EQ(error({}), "mine: has no columns");
  EXPECT_EQ(error({{"P", P}, {"T", {}, names}, {"A", A}}), "mine: column 'T' holds texts where numbers are wanted");
  EXPECT_EQ(error({{"P", P}, {"A", A}}), "mine:1:1: column 'T' is missing");
  EXPECT_NE(error({{"P [mN]", P}, {"T [mN]", A}, {"A [mm^2]", A}}).find("the constants radius"), std::string::npos);
  EXPECT_NE(error({{"P [mN]", P}, {"T [mN]", A}, {"A [kg]", A}}).find("is no unit"), std::string::npos);
}

TEST(Arrays, WithoutUnitsAndWithConstantsAreRefusedWithTheOptionOfUnits) {
  const std::vector<double> P{1, 1, 1, 1}, T{0, 1, 0, 1}, A{8, 7, 8, 7};
  const auto made = [&] { make_dataset("mine", {{"P", P}, {"T", T}, {"A", A}}, {{"radius", "9 mm"}}); };
  EXPECT_EQ(input_error(made),
            "mine:1:2: the columns have no units, but the data state radius; say the units, such as "
            "--units=\"P=mN,T=mN,A=mm^2\", or leave out what is stated if the columns are dimensionless");
}

TEST(Arrays, MayNameTheirRuns) {
  const std::vector<double> P{1, 1, 1, 1}, T{0, 1, 0, 1}, A{8, 7, 8, 7}, numbers{1, 1, 2, 2};
  const std::vector<std::string> names{"up", "up", "down", "down"};
  const std::vector<std::string> wanted{"up", "down"}, by_number{"1", "2"};
  EXPECT_EQ(make_dataset("mine", {{"P", P}, {"T", T}, {"A", A}, {"curve", {}, names}}, Overrides{}).curves, wanted);
  EXPECT_EQ(make_dataset("mine", {{"P", P}, {"T", T}, {"A", A}, {"curve", numbers}}, Overrides{}).curves, by_number);
}

}  // namespace arrays_test
}  // namespace mixity
