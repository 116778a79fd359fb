#include "dataset/table/spreadsheet.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>

#include "dataset/dataset.h"
#include "dataset/logs/recording.h"
#include "dataset/table/archive.h"
#include "dataset/table/column_names.h"
#include "dataset/table/csv_file.h"
#include "dataset/table/workbook.h"
#include "dataset/table/workbook_files.h"

namespace mixity {
namespace spreadsheet_test {

const std::string kHead = rows_xml({{"P [mN]", "T [mN]", "A [mm^2]"}});

std::string text_of(const Parts& parts, const SheetChoice& choice = {}) {
  return read_workbook("a.xlsx", zipped(parts), choice).text;
}

/// The text of a workbook with one sheet.
std::string sheet_text(const std::string& rows, const std::vector<std::string>& strings = {},
                       const std::vector<std::string>& styles = {}, const std::string& settings = "") {
  return text_of(workbook_parts({{"Data", rows}}, strings, styles, settings));
}

std::string refusal(const Parts& parts, const SheetChoice& choice = {}) {
  return input_error([&] { text_of(parts, choice); });
}

std::uint64_t bits(double value) {
  std::uint64_t same = 0;
  std::memcpy(&same, &value, sizeof same);
  return same;
}

}  // namespace spreadsheet_test
using namespace spreadsheet_test;

TEST(Spreadsheet, GivesTheSameBitsAsCsv) {
  const std::vector<std::vector<std::string>> rows{{"P [mN]", "T [mN]", "A [mm^2]"},
                                                   {"7.731", "0.1", "0.457831"},
                                                   {"7.731", "5.6729500000000002", "0.45660200000000001"},
                                                   {"1234", "11.265", "0.30000000000000004"}};
  std::string csv;
  for (const auto& row : rows) csv += row[0] + "," + row[1] + "," + row[2] + "\n";
  const TemporaryFolder folder;
  const Overrides constants{{"radius", "9.42 mm"}, {"modulus", "2.133 MPa"}, {"toughness", "27 mJ/m^2"}};
  const Dataset from_csv = load_dataset(folder.write("a.csv", csv), constants);
  for (const char* decimal : {"", ".", ","}) {
    Overrides stated = constants;
    if (*decimal) stated.emplace_back("decimal", decimal);  // what Excel shows depends on the language
    const Dataset from_sheet =
        load_dataset(folder.write("a.xlsx", zipped(workbook_parts({{"Run 1", rows_xml(rows)}}))), stated);
    ASSERT_EQ(from_sheet.points.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(from_sheet.points[i].line, i + 2);
      EXPECT_EQ(bits(from_sheet.points[i].shear()), bits(from_csv.points[i].shear())) << decimal << i;
      EXPECT_EQ(bits(from_sheet.points[i].A), bits(from_csv.points[i].A)) << decimal << i;
    }
    EXPECT_EQ(from_sheet.curve_loads, from_csv.curve_loads);
    EXPECT_EQ(from_sheet.reading, *decimal == ',' ? "sheet 'Run 1', decimal commas" : "sheet 'Run 1'");
  }
}

TEST(Spreadsheet, WritersDifferInTheirXml) {
  const std::string wanted = "P [mN]\tT [mN]\tA [mm^2]\n7.731\t\t1\n";
  // Excel
  EXPECT_EQ(sheet_text("<row r=\"1\" spans=\"1:3\"><c r=\"A1\" t=\"s\"><v>1</v></c><c r=\"B1\" t=\"s\"><v>0</v></c>"
                       "<c r=\"C1\" s=\"1\" t=\"s\"><v>2</v></c></row>"
                       "<row r=\"2\"><c r=\"A2\"><v>7.7309999999999999</v></c><c r=\"C2\"><v>1</v></c></row>",
                       {"T [mN]", "P [mN]",
                        "<si><r><t>A</t></r><r><t xml:space=\"preserve\"> </t></r><r><rPr><vertAlign "
                        "val=\"superscript\"/></rPr><t>[mm^2]</t></r><rPh><t>reading</t></rPh></si>"}),
            "P [mN]\tT [mN]\tA [mm^2]\n7.7309999999999999\t\t1");
  // ClosedXML: a prefix before all names; rows and cells without places; no XML declaration or dimension
  Parts parts = workbook_parts({{"Data", ""}});
  parts["xl/worksheets/sheet1.xml"] =
      "<x:worksheet xmlns:x=\"m\"><x:sheetData><x:row><x:c t=\"str\"><x:v>P [mN]</x:v></x:c><x:c t=\"inlineStr\"><x:is>"
      "<x:t>T [mN]</x:t></x:is></x:c><x:c t=\"inlineStr\"><x:is><x:t>A [mm^2]</x:t></x:is></x:c></x:row><x:row/>"
      "<x:row r=\"5\"><x:c><x:v>7</x:v></x:c></x:row></x:sheetData></x:worksheet>";
  EXPECT_EQ(text_of(parts), "P [mN]\tT [mN]\tA [mm^2]\n\n\n\n7\t\t");
}

TEST(Spreadsheet, EachLineIsARowOfTheSheet) {
  EXPECT_EQ(
      sheet_text("<row r=\"3\"><c r=\"B3\" t=\"inlineStr\"><is><t>T\r\n[mN]</t></is></c>"
                 "<c r=\"AB3\"><v>2</v></c></row><row r=\"6\"><c r=\"A6\" s=\"0\"/><c r=\"B6\"><v>1</v></c></row>"),
      "\n\n\tT [mN]" + std::string(26, '\t') + "2\n\n\n\t1" + std::string(26, '\t'));
}

TEST(Spreadsheet, TextsKeepTheirSigns) {
  EXPECT_EQ(sheet_text(rows_xml({{"a, b", "say \"x\"", "x;y", "_x000D_z", "&lt;5 µm"}, {"1", "2", "3", "4", "5"}})),
            "\"a, b\"\t\"say \"\"x\"\"\"\t\"x;y\"\t z\t<5 µm\n1\t2\t3\t4\t5");
}

TEST(Spreadsheet, KindsOfCells) {
  const auto cell = [](const std::string& xml) {
    return sheet_text("<row><c r=\"B1\"><v>0</v></c>" + xml + "</row>").substr(3);
  };
  EXPECT_EQ(cell("<c t=\"b\"><v>1</v></c>"), "1");
  EXPECT_EQ(cell("<c><f>B1*2</f><v>2.5</v></c>"), "2.5");
  EXPECT_EQ(cell("<c t=\"str\"><f>\"\"</f><v></v></c><c><v>1</v></c>"), "\t1");
  EXPECT_EQ(cell("<c t=\"e\"><f>1/0</f><v>#DIV/0!</v></c>"), "\"#DIV/0!\"");
  EXPECT_EQ(cell("<c t=\"d\"><v>2026-05-01T10:05:00</v></c>"), "2026-05-01T10:05:00");
  EXPECT_EQ(cell("<c><v>1.234E-5</v></c>"), "1.2340E-5");
}

TEST(Spreadsheet, AnErrorLeavesItsRowOut) {
  const TemporaryFolder folder;
  const std::string rows =
      kHead + rows_xml({{"5", "1", "2"}}) + "<row><c t=\"e\"><v>#N/A</v></c><c><v>1</v></c><c><v>2</v></c></row>";
  const Dataset data = load_dataset(folder.write("a.xlsx", zipped(workbook_parts({{"Data", rows}}))),
                                    {{"radius", "9.42 mm"}, {"modulus", "2.133 MPa"}, {"toughness", "27 mJ/m^2"}});
  ASSERT_EQ(data.excluded.size(), 1u);
  EXPECT_EQ(data.excluded[0].line, 3u);
}

TEST(Spreadsheet, FormulasNeedTheirValues) {
  const std::string without = "<row><c><v>1</v></c><c><f>A1*2</f><v/></c></row>",
                    zero = "<row><c><v>1</v></c><c><f>A1*2</f><v>0</v></c></row>",
                    computed_later = "<calcPr fullCalcOnLoad=\"1\"/>";
  EXPECT_EQ(
      refusal(workbook_parts({{"Data", without}})),
      "a.xlsx:1: sheet 'Data', column 2 holds a formula without its value: open the file in a spreadsheet program "
      "and save it");
  EXPECT_EQ(sheet_text(zero), "1\t0");
  EXPECT_NE(refusal(workbook_parts({{"Data", zero}}, {}, {}, computed_later)), "");  // as XlsxWriter writes it
}

TEST(Spreadsheet, DatesAndTimesAreThoseShown) {
  const std::vector<std::string> styles{"yyyy\\-mm\\-dd\\ hh:mm:ss.000", "[h]:mm:ss.00", "dd/mm/yy", "0.00%"};
  const auto cell = [&](const std::string& style, const std::string& value, const std::string& settings = "") {
    return sheet_text("<row><c s=\"" + style + "\"><v>" + value + "</v></c><c><v>0</v></c></row>", {}, styles,
                      settings);
  };
  EXPECT_EQ(cell("1", "46143.420138888891"), "2026-05-01T10:05:00\t0");
  EXPECT_EQ(cell("1", "46143.4201417824"), "2026-05-01T10:05:00.25\t0");     // 15 digits, as LibreOffice writes
  EXPECT_EQ(cell("1", "46143.99965280671"), "2026-05-01T23:59:30.0025\t0");  // 16, as Python writes
  EXPECT_EQ(cell("1", "44681.420138888891", "<workbookPr date1904=\"1\"/>"), "2026-05-01T10:05:00\t0");
  EXPECT_EQ(cell("2", "0.42014178240740741"), "10:05:00.25\t0");
  EXPECT_EQ(cell("2", "0.999999999999"), "00:00:00\t0");
  EXPECT_EQ(cell("1", "46142.999999999999"), "2026-05-01T00:00:00\t0");
  EXPECT_EQ(cell("3", "46143"), "2026-05-01\t0");
  EXPECT_EQ(cell("5", "0.5"), "12:00:00\t0");  // a format of the standard, by number
  EXPECT_EQ(cell("4", "0.05"), "0.05\t0");
  // times that reach a second day, in a column of their own
  EXPECT_EQ(
      sheet_text(
          "<row><c s=\"2\"><v>0.5</v></c><c><v>1</v></c></row><row><c s=\"2\"><v>1.5</v></c><c><v>1</v></c></row>", {},
          styles),
      "1899-12-30T12:00:00\t1\n1899-12-31T12:00:00\t1");
  // a heading in percent
  EXPECT_EQ(
      sheet_text(rows_xml({{"T_err [%]", "A"}}) + "<row><c s=\"4\"><v>0.05</v></c><c><v>1</v></c></row>", {}, styles),
      "T_err [%]\tA\n5\t1");
}

TEST(Spreadsheet, FormatsOfTimes) {
  for (const char* code : {"h:mm AM/PM", "[$-409]h:mm:ss;@", "mm:ss.0", "[ss]", "d.m.yyyy hh:mm"})
    EXPECT_EQ(format_of(code), CellFormat::time) << code;
  for (const char* code : {"yyyy", "[$-F800]dddd\\,\\ mmmm\\ dd\\,\\ yyyy", "d/m"})
    EXPECT_EQ(format_of(code), CellFormat::date) << code;
  for (const char* code : {"General", "0.00E+00", "0.0 \"mm\"", "0\\ \\m\\m", "#,##0.00 [$€-407];[Red]-#,##0.00",
                           "_-* #,##0_-", "@", "0.00_s", "# ?/?"})
    EXPECT_EQ(format_of(code), CellFormat::number) << code;
  EXPECT_EQ(format_of("0.0 %"), CellFormat::percent);
}

TEST(Spreadsheet, TimesOfALogCountFromItsFirstRow) {
  const TemporaryFolder folder;
  std::string rows = rows_xml({{"Time", "P [mN]", "T [mN]"}});
  for (const char* time : {"46143.420138888891", "46143.4201394676", "46143.42014004629", "46143.420140625"})
    rows += "<row><c s=\"1\"><v>" + std::string(time) + "</v></c><c><v>5</v></c><c><v>1</v></c></row>";
  const std::string path =
      folder.write("log.xlsx", zipped(workbook_parts({{"Log", rows}}, {}, {"dd.mm.yyyy hh:mm:ss"})));
  const Recording log = read_recordings(path, Metadata{}).front();
  ASSERT_EQ(log.time.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(log.time[i], 0.05 * static_cast<double>(i), 1e-9);  // of sums
  EXPECT_EQ(log.reading, "sheet 'Log'");
}

TEST(Spreadsheet, ADateAmongForcesIsRefused) {  // Excel makes dates of "1.5"
  const TemporaryFolder folder;
  const std::string rows =
      kHead + rows_xml({{"5", "1", "2"}}) + "<row><c><v>5</v></c><c s=\"1\"><v>45413</v></c><c><v>2</v></c></row>";
  const std::string path = folder.write("a.xlsx", zipped(workbook_parts({{"Data", rows}}, {}, {"d/m"})));
  const std::string error = input_error([&] {
    load_dataset(path, {{"radius", "9.42 mm"}, {"modulus", "2.133 MPa"}, {"toughness", "27 mJ/m^2"}});
  });
  EXPECT_NE(error.find("a.xlsx:3:2: "), std::string::npos) << error;  // row and column of the sheet
  EXPECT_NE(error.find("'2024-05-01' is not a number"), std::string::npos) << error;
}

TEST(Spreadsheet, MayHaveOtherNumbersBesideItsTable) {
  const TemporaryFolder folder;
  const std::string rows = rows_xml({{"P [mN]", "T [mN]", "A [mm^2]", "", "Lens"},
                                     {"7.731", "0.1", "0.457", "", "radius", "9.42", "mm"},
                                     {"7.731", "5.7", "0.456"}});
  const Dataset data = load_dataset(folder.write("a.xlsx", zipped(workbook_parts({{"Run 1", rows}}))),
                                    {{"radius", "9.42 mm"}, {"modulus", "2.133 MPa"}, {"toughness", "27 mJ/m^2"}});
  EXPECT_EQ(data.points.size(), 2u);
}

TEST(Spreadsheet, MergedCellsStateTheirValueForAllTheirRows) {
  const std::string rows =
      "<?xml version=\"1.0\"?><worksheet><sheetData>"
      "<row r=\"1\"><c t=\"inlineStr\"><is><t>run</t></is></c><c t=\"inlineStr\"><is><t>P [mN]</t></is></c></row>"
      "<row r=\"2\"><c r=\"A2\" s=\"1\"/><c r=\"B2\" t=\"inlineStr\"><is><t>units</t></is></c></row>"
      "<row r=\"3\"><c t=\"inlineStr\"><is><t>one</t></is></c><c><v>5</v></c><c><v>1</v></c></row>"
      "<row r=\"4\"><c r=\"C4\"><v>2</v></c></row><row r=\"5\"><c r=\"C5\"><v>3</v></c></row></sheetData>"
      "<mergeCells count=\"3\"><mergeCell ref=\"A1:A2\"/><mergeCell ref=\"A3:A4\"/><mergeCell ref=\"B3:B5\"/>"
      "<mergeCell ref=\"D1:F1\"/></mergeCells></worksheet>";
  EXPECT_EQ(sheet_text(rows), "run\tP [mN]\n\tunits\none\t5\t1\none\t5\t2\n\t5\t3");
}

TEST(Spreadsheet, HiddenRowsAreReadWithANote) {
  const Sheet sheet = read_workbook(
      "a.xlsx", zipped(workbook_parts({{"Data", kHead + "<row hidden=\"1\"><c><v>1</v></c></row>"}})), {});
  EXPECT_EQ(sheet.text, "P [mN]\tT [mN]\tA [mm^2]\n1\t\t");
  EXPECT_EQ(texts_of(sheet.notes), std::vector<std::string>{"sheet 'Data' has 1 hidden row, read like the others"});
}

TEST(Spreadsheet, HiddenColumnsAreReadWithANote) {
  const std::string begin =
                        "<?xml version=\"1.0\"?><worksheet><cols><col min=\"2\" max=\"2\" hidden=\"1\"/><col min=\"4\" "
                        "max=\"16384\" hidden=\"1\"/></cols><sheetData>",
                    row = "<row><c><v>1</v></c><c><v>2</v></c><c><v>3</v></c>", end = "</row></sheetData></worksheet>";
  const auto notes = [&](const std::string& cells) {
    return texts_of(
        read_workbook("a.xlsx", zipped(workbook_parts({{"Data", begin + kHead + row + cells + end}})), {}).notes);
  };
  const std::string note = "sheet 'Data' has numbers in hidden columns, read like the others: B";
  EXPECT_EQ(notes(""), std::vector<std::string>{note});  // columns without numbers do not count
  EXPECT_EQ(notes("<c r=\"AB2\"><v>4</v></c>"), std::vector<std::string>{note + ", AB"});
}

TEST(Spreadsheet, NumbersStoredAsTextMayHaveDecimalCommas) {
  EXPECT_EQ(sheet_text(rows_xml({{"P [mN]", "T [mN]"}, {"0.5", "0,52"}})), "P [mN]\tT [mN]\n\"0,5\"\t\"0,52\"");
  EXPECT_EQ(sheet_text(rows_xml({{"P [mN]", "T [mN]"}, {"0.5", "1,234"}})),
            "P [mN]\tT [mN]\n0.5\t\"1,234\"");  // not known
}

TEST(Spreadsheet, ACsvPastedIntoOneColumnIsRead) {
  EXPECT_EQ(sheet_text(rows_xml({{"P [mN];T [mN];A [mm^2]"}, {"5;1,5;2"}})), "P [mN];T [mN];A [mm^2]\n5;1,5;2");
}

TEST(Spreadsheet, TheFirstSheetWhoseHeadingsAreKnownIsRead) {
  const std::string table = kHead + rows_xml({{"5", "1", "2"}, {"5", "2", "2"}});
  const std::vector<SheetXml> sheets{{"About", rows_xml({{"Made by", "us"}})},
                                     {"Chart data", rows_xml({{"bin", "count"}, {"1", "2"}, {"2", "3"}})},
                                     {"Run 1", table},
                                     {"Run 2", table},
                                     {"Empty", ""}};
  const auto read = [&](const SheetChoice& choice) {
    return read_workbook("a.xlsx", zipped(workbook_parts(sheets)), choice);
  };
  const Sheet first = read({});
  EXPECT_EQ(first.name, "Run 1");
  EXPECT_EQ(texts_of(first.notes),
            std::vector<std::string>{"sheet 'Run 1' is read; to read another ('Run 2'): --sheet=\"Run 2\""});
  EXPECT_EQ(read({"Run 2"}).name, "Run 2");
  EXPECT_TRUE(read({"Run 2"}).notes.empty());
  EXPECT_EQ(read({"2"}).name, "Chart data");
  EXPECT_EQ(refusal(workbook_parts(sheets), {"Run 3"}),
            "a.xlsx: has no sheet 'Run 3'; it has 'About', 'Chart data', 'Run 1', 'Run 2', 'Empty'");
  EXPECT_EQ(refusal(workbook_parts(sheets), {"Empty"}), "a.xlsx: sheet 'Empty' is empty");
  // a mapping names headings that no one knows
  const ColumnRules rules{{{"T", "bin"}, {"A", "count"}}, nullptr, true, {}};
  EXPECT_EQ(read({"", 0, &rules}).name, "Chart data");
}

TEST(Spreadsheet, ANameThatAShellWouldChangeIsRecommendedByItsNumber) {
  const std::string table = kHead + rows_xml({{"5", "1", "2"}});
  const auto notes =
      read_workbook("a.xlsx", zipped(workbook_parts({{"A", table}, {"5 &quot;kPa&quot;", table}})), {}).notes;
  EXPECT_EQ(texts_of(notes), std::vector<std::string>{"sheet 'A' is read; to read another ('5 \"kPa\"'): --sheet=2"});
}

TEST(Spreadsheet, HiddenSheetsComeLast) {
  const std::string table = kHead + rows_xml({{"5", "1", "2"}});
  Parts parts = workbook_parts({{"Old", table}, {"New", table}});
  std::string& list = parts["xl/workbook.xml"];
  list.insert(list.find("name=\"Old\""), "state=\"hidden\" ");
  const Sheet sheet = read_workbook("a.xlsx", zipped(parts), {});
  EXPECT_EQ(sheet.name, "New");
  EXPECT_TRUE(sheet.notes.empty());
}

TEST(Spreadsheet, OtherWorkbooksAreRefusedWithWhatToDo) {
  const auto error = [](const std::string& bytes) { return input_error([&] { read_workbook("a", bytes, {}); }); };
  const std::string how = ": save its sheet as .xlsx or as CSV (Excel: Save As, CSV UTF-8)", ole = "\xD0\xCF\x11\xE0";
  std::string protected_by_a_password = ole + std::string(600, 'x');
  for (const char c : std::string("EncryptedPackage")) protected_by_a_password += std::string{c, '\0'};
  EXPECT_EQ(error(ole + "..."), "a: is a workbook of Excel 97 (.xls)" + how);
  EXPECT_EQ(error(protected_by_a_password),
            "a: is a workbook with a password: remove it in Excel (File, Info), or save the sheet as CSV");
  EXPECT_EQ(error(zipped({{"mimetype", "application/vnd.oasis.opendocument.spreadsheet"}, {"content.xml", "<a/>"}})),
            "a: is a workbook of OpenDocument (.ods)" + how);
  EXPECT_EQ(error(zipped({{"xl/workbook.bin", "x"}})), "a: is a binary workbook (.xlsb)" + how);
  EXPECT_EQ(error(zipped({{"run.csv", "P,T,A"}})),
            "a: is an archive without a workbook: unpack it, and read the files in it");
  EXPECT_EQ(error(zipped(workbook_parts({{"Data", kHead}}), "secret")),
            "a: is protected by a password; save the sheet that holds the data as CSV");
}

TEST(Spreadsheet, DamageIsNamed) {
  const Parts whole = workbook_parts({{"Data", kHead + rows_xml({{"5", "1", "2"}})}}, {"a"});
  const std::string bytes = zipped(whole);
  for (std::size_t length = 4; length < bytes.size(); length += 7) {
    const std::string error = input_error([&] { read_workbook("a.xlsx", bytes.substr(0, length), {}); });
    EXPECT_TRUE(error.starts_with("a.xlsx: is a workbook or an archive that is damaged")) << length << error;
  }
  for (std::size_t at = 4; at < bytes.size(); at += 3) {  // any flipped byte is refused in one sentence, or harmless
    std::string flipped = bytes;
    flipped[at] = static_cast<char>(flipped[at] ^ 0x55);
    const std::string error = input_error([&] { read_workbook("a.xlsx", flipped, {}); });
    EXPECT_TRUE(error.empty() || error.starts_with("a.xlsx: ")) << at << error;
  }
  for (const char* missing : {"xl/worksheets/sheet1.xml", "xl/_rels/workbook.xml.rels"}) {
    Parts parts = whole;
    parts.erase(missing);
    EXPECT_EQ(refusal(parts), "a.xlsx: is damaged: its part '" + std::string(missing) + "' is missing; save it again");
  }
  const auto rows = [](const std::string& xml) { return refusal(workbook_parts({{"Data", xml}}, {"a"})); };
  EXPECT_EQ(rows("<row r=\"2\"/><row r=\"1\"/>"), "a.xlsx: is damaged: sheet 'Data', row 1");
  EXPECT_EQ(rows("<row r=\"4000000000\"/>"), "a.xlsx: is damaged: sheet 'Data', row 4000000000");
  EXPECT_EQ(rows("<row><c r=\"ZZZ1\"/></row>"), "a.xlsx: is damaged: sheet 'Data', cell ZZZ1");
  EXPECT_EQ(rows("<row><c r=\"B1\"/><c r=\"A1\"/></row>"), "a.xlsx: is damaged: sheet 'Data', cell A1");
  EXPECT_EQ(rows("<row><c t=\"s\"><v>7</v></c></row>"), "a.xlsx: is damaged: sheet 'Data', row 1");
  EXPECT_EQ(rows("<row><c><v>7</c></row>"),
            "a.xlsx: is damaged: its part 'xl/worksheets/sheet1.xml' is not whole; save it again");
  EXPECT_EQ(rows("<row><c><v>7"),
            "a.xlsx: is damaged: its part 'xl/worksheets/sheet1.xml' is not whole; save it again");
}

TEST(Spreadsheet, PartsThatUnpackToFarMoreThanTheirSizeAreRefused) {
  const std::string blanks(std::size_t{80} << 20, ' '), bytes = zipped({{"a", blanks}, {"b", "text"}});
  const Archive archive("a.xlsx", bytes);
  EXPECT_EQ(
      input_error([&] { archive.read("a"); }),
      "a.xlsx: unpacks to more than 500 times its size, as no measurement does; save the sheet that holds the data "
      "as CSV");
  EXPECT_EQ(archive.read("b"), "text");
  const Archive small("a.xlsx", bytes, std::size_t{1} << 20);
  EXPECT_EQ(input_error([&] { small.read("a"); }),
            "a.xlsx: unpacks to more than 1 MB; save the sheet that holds the data as CSV");
}

TEST(Spreadsheet, IsReadOnceAndHashedAsItIsOnDisk) {
  const TemporaryFolder folder;
  const std::string bytes = zipped(workbook_parts({{"Data", kHead + rows_xml({{"5", "1", "2"}})}}));
  const std::string path = folder.write("a.xlsx", bytes);
  Inputs inputs;
  CsvFile file(path, inputs);
  EXPECT_EQ(file.start(), "P [mN]\tT [mN]\tA [mm^2]\n5\t1\t2");
  ASSERT_EQ(inputs.files().size(), 1u);
  EXPECT_EQ(inputs.files()[0].bytes, bytes.size());
  EXPECT_EQ(*inputs.files()[0].content, bytes);
}

}  // namespace mixity
