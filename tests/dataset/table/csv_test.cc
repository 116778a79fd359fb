#include <gtest/gtest.h>

#include <filesystem>

#include "base/files.h"
#include "dataset/table/csv_file.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace csv_test {

using Fields = std::vector<std::string>;

struct Row {
  std::size_t line;
  Fields fields;
  std::vector<std::size_t> lines, columns;  // one more than fields: where the next field would start
};

std::vector<Row> rows_of(std::string_view text) {
  const TemporaryFolder folder;
  std::vector<Row> rows;
  read_csv(folder.write("a.csv", text), [&](const CsvRow& row) {
    rows.push_back({row.line(), {}, {}, {}});
    for (std::size_t i = 0; i < row.size(); ++i) rows.back().fields.emplace_back(row[i]);
    for (std::size_t i = 0; i <= row.size(); ++i) {
      rows.back().lines.push_back(row.place(i).line);
      rows.back().columns.push_back(row.place(i).column);
    }
  });
  return rows;
}

std::string error_of(std::string_view text) {
  return file_error("a.csv", text, [](const std::string& path) { read_csv(path, [](const CsvRow&) {}); });
}

TEST(Csv, OneTableIsReadInEverySpelling) {
  for (const std::string_view text : {
           "P,T\n1,2.5\n",
           "P,T\n1,2.5",                    // no final line end
           "P,T\r\n1,2.5\r\n",              // CRLF
           "\xEF\xBB\xBFP,T\r\n1,2.5\r\n",  // byte order mark
           "P,T\r1,2.5\r",                  // line ends of the old Macintosh
           "P;T\n1;2.5\n",
           "P\tT\n1\t2.5\n",
           "\"P\",\"T\"\n\"1\",\"2.5\"\n",
           " P , T \n 1 ,2.5 \n",
           "# comment, with a quote \"\nP,T\n# more\n1,2.5\n#",
           "\n\nP,T\n\n1,2.5\n  \n\n",
           "sep=;\nP;T\n1;2.5\n",  // what tells Excel the delimiter
           "sep=\t\r\nP\tT\r\n1\t2.5\r\n",
           "sep=, \nP,T\n1,2.5\n",
       }) {
    const auto rows = rows_of(text);
    ASSERT_EQ(rows.size(), 2) << text;
    EXPECT_EQ(rows[0].fields, (Fields{"P", "T"})) << text;
    EXPECT_EQ(rows[1].fields, (Fields{"1", "2.5"})) << text;
  }
}

TEST(Csv, LinesAreThoseOfTheFile) {
  const auto rows = rows_of("# one\n\na,b\n# four\n\"x\ny\nz\",1\n2,3\n");
  ASSERT_EQ(rows.size(), 3);
  EXPECT_EQ(rows[0].line, 3);
  EXPECT_EQ(rows[1].line, 5);  // a row of three lines counts as its first
  EXPECT_EQ(rows[1].fields[0], "x\ny\nz");
  EXPECT_EQ(rows[2].line, 8);
}

TEST(Csv, ColumnsCountCharactersNotBytes) {
  const auto rows = rows_of("µ,\"a,\"\"b\",°C,d\n");
  ASSERT_EQ(rows.size(), 1);
  EXPECT_EQ(rows[0].fields, (Fields{"µ", "a,\"b", "°C", "d"}));
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(rows[0].columns[i], (std::vector<std::size_t>{1, 3, 11, 14})[i]) << i;
}

TEST(Csv, AMissingFieldIsPlacedJustBehindTheLastCharacter) {
  for (const std::string_view text : {"1,0", "1,0\n", "1,0\r\n", "1,0\n2,3\n"})
    EXPECT_EQ(rows_of(text).at(0).columns.at(2), 4) << text;
}

TEST(Csv, AFieldBehindAQuotedLineEndIsPlacedOnItsOwnLine) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const auto rows = rows_of("a,b,c" + end + "1,\"x" + end + "#" + end + end + "y\",22,3" + end);
    ASSERT_EQ(rows.size(), 2);
    EXPECT_EQ(rows[1].line, 2);
    EXPECT_EQ(rows[1].lines, (std::vector<std::size_t>{2, 2, 5, 5, 5}));
    EXPECT_EQ(rows[1].columns, (std::vector<std::size_t>{1, 3, 4, 7, 8}));
  }
}

TEST(Csv, QuotedFieldsMayHoldDelimitersQuotesAndLineEnds) {
  const auto rows = rows_of("name,note\n\"a,b\",\"say \"\"hi\"\"\"\n\"#1\",\"two\r\nlines\"\n");
  ASSERT_EQ(rows.size(), 3);
  EXPECT_EQ(rows[1].fields, (Fields{"a,b", "say \"hi\""}));
  EXPECT_EQ(rows[2].fields, (Fields{"#1", "two\r\nlines"}));
}

TEST(Csv, TheFirstRowChoosesTheDelimiter) {
  EXPECT_EQ(rows_of("a;b;c\n1,5;2,5;3\n")[1].fields, (Fields{"1,5", "2,5", "3"}));
  EXPECT_EQ(rows_of("a,b\n1;2,3\n")[1].fields, (Fields{"1;2", "3"}));
  EXPECT_EQ(rows_of("# x;y;z\na,b\n1,2\n")[1].fields, (Fields{"1", "2"}));  // a comment does not
}

TEST(Csv, WhatStandsInBracketsDoesNotChooseTheDelimiter) {
  EXPECT_EQ(rows_of("P\tnote (who, when, where)\n1\tx\n")[1].fields, (Fields{"1", "x"}));
  EXPECT_EQ(rows_of("P;T [a,b];A\n1;2;3\n")[1].fields, (Fields{"1", "2", "3"}));
}

TEST(Csv, EmptyFieldsAreFields) {
  EXPECT_EQ(rows_of("a,b,c\n,2,\n")[1].fields, (Fields{"", "2", ""}));
  EXPECT_EQ(rows_of("a\tb\tc\n\t2\t\n")[1].fields, (Fields{"", "2", ""}));
}

TEST(Csv, RaggedRowsAreHandedOverAsTheyAre) {
  const auto rows = rows_of("a,b\n1\n1,2,3\n");
  EXPECT_EQ(rows[1].fields.size(), 1);
  EXPECT_EQ(rows[2].fields.size(), 3);
}

TEST(Csv, BlanksAroundAFieldGoWithAndWithoutQuotes) {
  const auto rows = rows_of("a,b,c\n 1 ,\" 2\t\", \"x y\" \n");
  ASSERT_EQ(rows.size(), 2);
  EXPECT_EQ(rows[1].fields, (Fields{"1", "2", "x y"}));
}

TEST(Csv, WhatStandsInQuotesDoesNotChooseTheDelimiter) {
  const auto rows = rows_of("P,\"a;b;c\"\n1,2\n");
  ASSERT_EQ(rows.size(), 2);
  EXPECT_EQ(rows[0].fields, (std::vector<std::string>{"P", "a;b;c"}));
}

TEST(Csv, AFileWithoutRowsIsNoError) {
  for (const std::string_view text : {"", "\xEF\xBB\xBF", "\n", " \r\n\r\n", "# only a comment"})
    EXPECT_TRUE(rows_of(text).empty()) << text;
}

/// What programs for the Macintosh leave beside line feeds: a row ends at each, and lines are counted by both.
TEST(Csv, ACarriageReturnEndsARowWhateverFollowsIt) {
  for (const std::string_view text : {"a,b\n1,2\r3,4\n", "a,b\r1,2\n3,4\r", "# c\ra,b\r1,2\r\n3,4",
                                      "a,b\n# c\r1,2\r\r# d\r3,4\n", "a,b\r\r\n1,2\r\r3,4\n", "a,b\r1,2\r\"3\",4\n"}) {
    const auto rows = rows_of(text);
    ASSERT_EQ(rows.size(), 3) << text;
    EXPECT_EQ(rows[1].fields, (Fields{"1", "2"})) << text;
    EXPECT_EQ(rows[2].fields, (Fields{"3", "4"})) << text;
  }
  EXPECT_EQ(rows_of("a,b\n1,2\r\r3,4\r5,6\n")[3].line, 5);
}

TEST(Csv, WhatIsNoCsvIsRefusedWithItsPlace) {
  for (
      const auto& [text, error] : {
          std::pair<std::string_view, std::string_view>{
              "a,b\n\"1\"2,3\n", ":2:1: a quote (\") inside a field is not doubled or not closed"},
          {"a,b\n1,\"2\n3,4\n", ":2:1: a quote (\") is opened but not closed before the end of the file"},
          {"\"", ":1:1: a quote (\") is opened but not closed before the end of the file"},
          {"PK\x03\x04", ": is a workbook or an archive that is damaged or incomplete; save or copy it again"},
          {"TDSm\x0E",
           ": is a TDMS file of LabVIEW; in Python mixity.read(\"FILE.tdms\") reads it, or export it as text: open it "
           "in "
           "Excel (TDMS add-in) and save as CSV"},
          {"MATLAB 5.0 MAT-file, Platform: GLNXA64",
           ": is a .mat file of MATLAB; in Python mixity.read(\"FILE.mat\") reads it, or export its variables as text: "
           "writetable(table(P,T,A),\"FILE.csv\")"},
          {"\x89HDF\r\n\x1A\n",
           ": is an HDF5 file; in Python mixity.read(\"FILE.h5\") reads it, or export its data sets as CSV, such as by "
           "h5dump -y -w 0 -d DATASET -o FILE.csv"},
          {"\x1F\x8B\x08", ": is compressed; unpack it with gunzip"},
      })
    EXPECT_EQ(error_of(text), "a.csv" + std::string(error)) << text;
}

TEST(Csv, QuotesInsideAFieldAreLetters) {
  const auto rows = rows_of("a,b\n4\" wafer,say \"hi\", \"c,d\"\n");
  EXPECT_EQ(rows[1].fields, (Fields{"4\" wafer", "say \"hi\"", "c,d"}));
  EXPECT_EQ(rows[1].columns, (std::vector<std::size_t>{1, 10, 19, 25}));
}

TEST(Csv, FilesThatCannotBeReadAreNamed) {
  const TemporaryFolder folder;
  const auto error = [](const std::string& path) { return input_error([&] { read_csv(path, [](const CsvRow&) {}); }); };
  EXPECT_EQ(error(folder.path("none.csv")), folder.path("none.csv") + ": cannot be opened: No such file or directory");
  EXPECT_EQ(error(folder.path()), folder.path() + ": cannot be read: Is a directory");
}

/// A device that never ends, and what a crash leaves of a file that was given its size beforehand.
TEST(Csv, WhatNeverEndsARowIsRefused) {
  const auto error = [](const std::string& path) { return input_error([&] { read_csv(path, [](const CsvRow&) {}); }); };
  const std::string refusal = "a row of more than 256 MB, or a quote never closed";
  EXPECT_EQ(error("/dev/zero"), "/dev/zero:1:1: " + refusal);
  EXPECT_EQ(input_error([] { read_file("/dev/zero"); }), "/dev/zero: is larger than 256 MB");
  const TemporaryFolder folder;
  const std::string path = folder.write("cut.csv", "P,T,A\n1,0,19.6\n");
  std::filesystem::resize_file(path, std::uintmax_t{3} << 28);  // NULs, which take no room on the disk
  EXPECT_EQ(error(path), path + ":3:1: " + refusal);
}

TEST(Csv, AWrittenFieldIsReadBackAsOne) {
  for (const std::string text : {"plain", "a,b", "a;b", "tab\there", "say \"hi\"", "\"", "two\nlines", "#1", "µm²"}) {
    const auto rows = rows_of(csv_field(text) + ",next\n");
    ASSERT_EQ(rows.size(), 1) << text;
    EXPECT_EQ(rows[0].fields, (Fields{text, "next"}));
  }
}

TEST(SpreadsheetField, IsNoFormula) {
  EXPECT_EQ(spreadsheet_field("=1+1"), "'=1+1");
  EXPECT_EQ(spreadsheet_field("+run"), "'+run");
  EXPECT_EQ(spreadsheet_field("-run"), "'-run");
  EXPECT_EQ(spreadsheet_field("@run"), "'@run");
  EXPECT_EQ(spreadsheet_field("\trun"), "\"'\trun\"");
  EXPECT_EQ(spreadsheet_field("=a,b"), "\"'=a,b\"");
  for (const char* plain : {"-1.79", "+3e-2", "run 1", "a=b", ""}) EXPECT_EQ(spreadsheet_field(plain), plain);
}

}  // namespace csv_test
}  // namespace mixity
