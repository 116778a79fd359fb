// Files read in blocks of any size give the rows that a parser of whole texts finds, character by character.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>

#include "base/text.h"
#include "dataset/table/csv_file.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace csv_blocks_test {

using Rows = std::vector<std::vector<std::string>>;

/// RFC 4180 as a state machine over the characters of a text. Null if quotes do not match. A carriage return ends a row
/// with or without a line feed behind it. Blanks around fields are dropped, rows without anything in them left out.
std::optional<Rows> by_character(const std::string& text, char delimiter) {
  enum { kBegin, kPlain, kQuoted, kQuote, kReturn } state = kBegin;  // kQuote: behind a quote in quotes
  Rows rows(1);
  std::string field;
  const auto end_field = [&] {
    rows.back().emplace_back(trim(field));
    field.clear();
    state = kBegin;
  };
  const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
  bool blanks_behind = false;
  for (const char c : text + '\n') {
    if (state == kReturn && c != '\n') {
      if (c != delimiter && (is_blank(c) || c == '\r')) continue;
      rows.emplace_back();
      state = kBegin;
    }
    if (state == kQuoted) {
      if (c == '"')
        state = kQuote;
      else
        field += c;
      blanks_behind = false;
    } else if (state == kQuote && c == '"' && !blanks_behind) {
      field += c;
      state = kQuoted;
    } else if (state == kReturn) {  // and its line feed
      rows.emplace_back();
      state = kBegin;
    } else if (c == delimiter) {
      end_field();
    } else if (c == '\r' && state == kBegin && rows.back().empty()) {  // what the line end before it left over
      continue;
    } else if (c == '\r') {
      end_field();
      state = kReturn;
    } else if (c == '\n') {
      end_field();
      rows.emplace_back();
    } else if (is_blank(c)) {
      if (state == kPlain) field += c;
      blanks_behind = true;
    } else if (state == kQuote) {
      return {};
    } else if (c == '"' && state != kPlain) {
      state = kQuoted;
    } else {
      field += c;
      state = kPlain;
    }
  }
  if (state == kQuoted) return {};
  std::erase_if(rows, [](const auto& row) { return row.empty() || (row.size() == 1 && row[0].empty()); });
  return rows;
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

/// The rows of a text, or nothing for an error; both parsers must agree.
std::optional<Rows> compared(const std::string& text, char delimiter) {
  std::optional<Rows> rows(Rows{});
  try {
    read_csv_text(text, "text", false, [&](const CsvRow& row) { add(*rows, row); });
  } catch (const InputError&) {
    rows.reset();
  }
  EXPECT_EQ(rows, by_character(text, delimiter)) << text;
  return rows;
}

TEST(CsvBlocks, LinesWithoutQuotesAreSplitAsByCharacter) {
  std::mt19937 random(1);
  for (int i = 0; i < 20000; ++i)
    ASSERT_TRUE(compared(
        random_text(random, {",", ",", " ", "\t", "\n", "\r\n", "1", "2.5", "x y", ";", "µ", "#", "\r\r\n", "\r \n"}),
        ','));
}

TEST(CsvBlocks, LinesWithQuotesAreSplitAsByCharacter) {
  std::mt19937 random(3);
  std::size_t errors = 0;
  for (int i = 0; i < 40000; ++i) {
    std::string text = random_text(
        random, {",", ",\"1\"", "\n\"x, y\"", "\r\n", "\n", "1", ",\"say \"\"hi\"\"\"", ",\"two\nlines\"", ",\"\"",
                 ", \" 2\t\" ", "\n\"\"\"\"", "\n\t\"\r\n\"", random() % 20 ? "," : "\"", random() % 40 ? " " : "\r"});
    const char delimiter = i % 3 == 0 ? ';' : i % 3 == 1 ? '\t' : ',';
    std::replace(text.begin(), text.end(), ',', delimiter);
    errors += !compared(text, delimiter);
  }
  EXPECT_GT(errors, 4000);
  EXPECT_LT(errors, 36000);
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
        Inputs inputs;
        CsvFile file(path, inputs, {}, block_bytes);
        for (CsvRow row; file.next(row);)
          if (!row.is_comment()) use(row);
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
  Inputs inputs;
  CsvFile file(folder.write("a.csv", text), inputs, {}, 512);
  std::size_t rows = 0, most = 0;
  double progress = 0;
  for (CsvRow row; file.next(row); ++rows) {
    most = std::max(most, file.held());
    EXPECT_GE(file.progress(), progress);
    progress = file.progress();
    EXPECT_EQ(row.line(), rows + 1);
  }
  EXPECT_LE(most, 2 * 512);
  EXPECT_EQ(rows, 5001);
  EXPECT_EQ(progress, 1);
}

}  // namespace csv_blocks_test
}  // namespace mixity
