// Files read in blocks, and lines split without libcsv, give the rows that libcsv gives of the whole text.
#include <csv.h>
#include <gtest/gtest.h>

#include <random>

#include "dataset/table/csv.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace {

using Rows = std::vector<std::vector<std::string>>;

/// Rows as libcsv finds them in the whole text at once, those without anything in them left out.
Rows by_library(const std::string& text) {
  struct Found {
    Rows rows{{}};
  } found;
  csv_parser parser;
  csv_init(&parser, CSV_STRICT | CSV_STRICT_FINI);
  const auto on_field = [](void* field, std::size_t size, void* all) {
    static_cast<Found*>(all)->rows.back().emplace_back(static_cast<const char*>(field), size);
  };
  const auto on_row = [](int, void* all) { static_cast<Found*>(all)->rows.emplace_back(); };
  EXPECT_EQ(csv_parse(&parser, text.data(), text.size(), on_field, on_row, &found), text.size());
  EXPECT_EQ(csv_fini(&parser, on_field, on_row, &found), 0);
  csv_free(&parser);
  std::erase_if(found.rows, [](const auto& row) { return row.empty() || (row.size() == 1 && row[0].empty()); });
  return found.rows;
}

void add(Rows& rows, const CsvRow& row) {
  rows.emplace_back();
  for (std::size_t i = 0; i < row.size(); ++i) rows.back().emplace_back(row[i]);
}

std::string random_text(std::mt19937& random, const std::vector<std::string>& pieces) {
  std::string text = "a,b\n";
  for (std::size_t i = random() % 60; i > 0; --i) text += pieces[random() % pieces.size()];
  return text;
}

TEST(CsvBlocks, LinesWithoutQuotesAreSplitAsLibcsvDoes) {
  std::mt19937 random(1);
  for (int i = 0; i < 20000; ++i) {
    const std::string text = random_text(random, {",", ",", " ", "\t", "\n", "\r\n", "1", "2.5", "x y", ";", "µ", "#"});
    Rows rows;
    read_csv_text(text, "text", false, [&](const CsvRow& row) { add(rows, row); });
    ASSERT_EQ(rows, by_library(text)) << text;
  }
}

/// Every row with its line, or the error that ends them.
template <class Read>
std::pair<Rows, std::string> outcome(const Read& read) {
  Rows rows;
  const auto use = [&](const CsvRow& row) {
    add(rows, row);
    rows.back().push_back("line " + std::to_string(row.line()) + " to " + std::to_string(row.place(row.size()).line) +
                          " " + std::to_string(row.place(row.size()).column));
  };
  std::string error;
  try {
    read(use);
  } catch (const std::exception& caught) {
    error = caught.what();
  }
  return {rows, error};
}

TEST(CsvBlocks, ABlockOfAnySizeChangesNothing) {
  const TemporaryFolder folder;
  std::mt19937 random(2);
  std::size_t errors = 0;
  for (int i = 0; i < 2000; ++i) {
    const bool old_macintosh = i % 20 == 0;
    std::string text = random_text(random, {",", "\n", "\n", "\r\n", "1", "\"two\nlines\"", "\"x\"\"y\"",
                                            "\n# it's \"\n", "\n\n", "\"", " ", "\r"});
    if (i % 7 == 0) text = "\xEF\xBB\xBF# first\n\n" + text;
    if (old_macintosh) std::replace(text.begin(), text.end(), '\n', '\r');
    const std::string path = folder.write("a.csv", text);
    const auto whole = outcome([&](const UseRow& use) { read_csv_text(text, path, true, use); });
    errors += !whole.second.empty();
    for (const std::size_t block_bytes : {1, 2, 3, 7, 16, 64, 1000}) {
      const auto in_blocks = outcome([&](const UseRow& use) {
        CsvFile file(path, block_bytes);
        for (CsvBlock block; file.next(block);) block.rows(use);
      });
      ASSERT_EQ(in_blocks, whole) << block_bytes << " bytes of\n" << text;
    }
  }
  EXPECT_GT(errors, 100);  // and as many without, or nothing would be shown
  EXPECT_LT(errors, 1900);
}

TEST(CsvBlocks, NoMoreOfAFileIsHeldThanABlock) {
  const TemporaryFolder folder;
  std::string text = "P,T\n";
  for (int i = 0; i < 5000; ++i) text += std::to_string(i) + ",1\n";
  CsvFile file(folder.write("a.csv", text), 512);
  std::size_t blocks = 0, bytes = 0, lines = 0;
  for (CsvBlock block; file.next(block);) {
    ++blocks;
    bytes += block.bytes();
    lines += block.lines();
    EXPECT_LE(block.bytes(), 512);
  }
  EXPECT_GT(blocks, 50);
  EXPECT_EQ(bytes, text.size());
  EXPECT_EQ(lines, 5001);
  EXPECT_EQ(file.bytes(), text.size());
}

}  // namespace
}  // namespace mixity
