// Rows that come as numbers, several at a time, are those that come one by one.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <random>

#include "base/number_text.h"
#include "base/units.h"
#include "dataset/table/csv.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace {

using Lines = std::vector<std::string>;

/// A row as text, with the bits of its numbers.
std::string shown(std::size_t line, double first, std::string_view text, double last) {
  return std::to_string(line) + ": " + std::to_string(std::bit_cast<std::uint64_t>(first)) + ' ' + std::string(text) +
         ' ' + std::to_string(std::bit_cast<std::uint64_t>(last));
}

/// Fields 0 and 3 as numbers and 2 as text, read by the reference; or what else there is in the row.
std::string shown(const CsvRow& row) {
  double first = 0, last = 0;
  if (row.size() == 4 && parse_number(row[0], first) && parse_number(row[3], last))
    return shown(row.line(), first, row[2], last);
  std::string text = std::to_string(row.line()) + " as it stands, " + std::to_string(row.place(row.size()).column);
  for (std::size_t i = 0; i < row.size(); ++i) text += '|' + std::string(row[i]);
  return text;
}

struct Read {
  Lines one_by_one, several;
  std::size_t as_numbers = 0;
};

/// Reads the text, in blocks of such a size, in both ways.
Read read(const std::string& text, std::size_t block_bytes) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a.csv", text);
  Read read;
  CsvFile file(path, block_bytes);
  for (CsvBlock block; file.next(block);) {
    block.rows([&](const CsvRow& row) { read.one_by_one.push_back(shown(row)); });
    block.rows(
        {{0, 3}, {2}, 4},
        [&](const CsvNumbers& rows) {
          for (std::size_t i = 0; i < rows.size(); ++i) {
            ++read.as_numbers;
            read.several.push_back(shown(rows.line(i), rows.numbers(0)[i], rows.text(0, i), rows.numbers(1)[i]));
            EXPECT_EQ(shown(rows.row(i)), read.several.back());
          }
        },
        [&](const CsvRow& row) { read.several.push_back(shown(row)); });
  }
  return read;
}

TEST(CsvNumbers, AreTheNearestDoublesInEverySpelling) {
  std::mt19937_64 random(1);
  const auto spelling = [&]() -> std::string {
    char text[64];
    const double value = std::bit_cast<double>(random()), usual = std::ldexp(static_cast<double>(random()), -50);
    switch (random() % 6) {
      case 0:
        return std::isfinite(value) ? shortest(value) : "0";
      case 1:
        std::snprintf(text, sizeof text, "%.*f", static_cast<int>(random() % 20), usual);
        return text;
      case 2:
        std::snprintf(text, sizeof text, "%.*g", static_cast<int>(1 + random() % 25), -usual);
        return text;
      case 3:
        return std::to_string(random() >> random() % 64);  // up to 2^64
      case 4:
        std::snprintf(text, sizeof text, "%05d.%06d", static_cast<int>(random() % 99999),
                      static_cast<int>(random() % 1000000));
        return text;
      default:
        return std::array{"0",
                          "-0",
                          ".5",
                          "5.",
                          "-0.0",
                          "1e3",
                          "9007199254740993",
                          "9007199254740992",
                          "1e-320",
                          "0.00000000000000000001",
                          "123456789012345678901234567890",
                          "1E5"}[random() % 12];
    }
  };
  std::string text;
  for (int i = 0; i < 50000; ++i) text += spelling() + ",,x," + spelling() + '\n';
  const Read both = read(text, 1 << 16);
  EXPECT_EQ(both.several, both.one_by_one);
  EXPECT_EQ(both.as_numbers, 50000);
}

TEST(CsvNumbers, ComeInEverySpellingOfATable) {
  for (const std::string text : {"1,a,b,2\n3,c,d,4\n", "1;a;b;2\n3;c;d;4\n", "1\ta\tb\t2\n3\tc\td\t4\n",
                                 "1,a,b,2\r\n3,c,d,4\r\n", "1,a,b,2\r3,c,d,4\r", " 1 ,a , b , 2 \n3, c, d, 4\n"}) {
    const Read both = read(text, 1 << 16);
    EXPECT_EQ(both.several, (Lines{shown(1, 1, "b", 2), shown(2, 3, "d", 4)})) << text;
    EXPECT_EQ(both.as_numbers, 2) << text;
  }
}

TEST(CsvNumbers, LeaveEveryOtherRowToItsReader) {
  std::mt19937 random(2);
  const Lines pieces{"1,2,3,4\n",
                     "1,2,3,4\n",
                     "-1.5e3,x,run 1,2\r\n",
                     "1,2,3\n",
                     "1,2,3,4,5\n",
                     ",,,\n",
                     "\n",
                     "# 1,2,3,4\n",
                     "1,a\"b\"\n",
                     "\"1\",2,\"3\n4\",5\n",
                     "+1,2,3,4\n",
                     "1,2,3,inf\n",
                     "1 2,,,3\n",
                     "1,2\r3,4\n",
                     " \t\n",
                     "1e999,2,3,4\n",
                     "x,y,z,w\n",
                     "1,2,3,4e\n",
                     "1.2.3,,,4\n"};
  std::size_t rows = 0, as_numbers = 0, failed = 0;
  for (int i = 0; i < 400; ++i) {
    std::string text = "first,row,of,four\n";
    for (std::size_t k = random() % 30; k > 0; --k) text += pieces[random() % (i % 3 ? pieces.size() : 7)];
    if (i % 5 == 0) text.pop_back();
    for (const std::size_t block_bytes : {20, 100, 10000}) {
      try {
        const Read both = read(text, block_bytes);
        ASSERT_EQ(both.several, both.one_by_one) << text;
        rows += both.several.size();
        as_numbers += both.as_numbers;
      } catch (const std::exception&) {
        ++failed;  // quotes or carriage returns that no reader understands
      }
    }
  }
  EXPECT_GT(as_numbers, rows / 5);
  EXPECT_GT(failed, 100);
}

}  // namespace
}  // namespace mixity
