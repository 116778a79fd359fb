#include "report/data_text.h"

#include <gtest/gtest.h>

#include "dataset/dataset.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace data_text_test {

TEST(CheckText, ListsTenExcludedRowsOfEachReasonAndCountsTheOthers) {
  const TemporaryFolder folder;
  std::string text = "P,T,A\n10,0,30\n";
  for (int i = 0; i < 25; ++i) text += "10,,30\n";
  for (int i = 0; i < 3; ++i) text += "10,1,-1\n";
  const std::string shown = reading_text(load_dataset(folder.write("a.csv", text)));
  EXPECT_NE(shown.find("    line 12: T is empty\n    line 28: A <= 0\n"), std::string::npos) << shown;
  EXPECT_NE(shown.find("    and 15 more: T is empty\n"), std::string::npos) << shown;
  EXPECT_EQ(shown.find("more: A <= 0"), std::string::npos) << shown;
}

}  // namespace data_text_test
}  // namespace mixity
