// Files with several tables, as instruments write intervals, steps and blocks.
#include <gtest/gtest.h>

#include "base/text.h"
#include "dataset/load_text.h"

namespace mixity {
namespace several_tables_test {

const std::string kConstants = "radius = \"9.42 mm\"\nmodulus = \"2.133 MPa\"\ntoughness = \"27 mJ/m^2\"\n";

Dataset load(const std::string& csv, const std::string& toml = "") { return load_text(csv, kConstants + toml); }

/// "NAME: T in mN of each point", a line for each run.
std::string runs_of(const Dataset& data) {
  std::string text;
  const auto runs = points_by_curve(data);
  for (std::size_t k = 0; k < runs.size(); ++k) {
    text += data.curves[k] + ":";
    for (const std::size_t i : runs[k])
      text += " " + std::to_string(std::lround(1e3 * data.points[i].T * data.contact->force_unit()));
    text += "\n";
  }
  return text;
}
std::string notes_of(const Dataset& data) {
  std::string text;
  for (const Message& note : data.notes) text += note.text() + "\n";
  return text;
}

const std::string kHeadings = "Normal Force [N],Friction Force [N],Contact Area [mm^2]\n",
                  kOne = "0.008,0.00,0.460\n0.008,0.02,0.452\n0.008,0.04,0.441\n",
                  kTwo = "0.004,0.00,0.350\n0.004,0.02,0.341\n0.004,0.03,0.329\n";

TEST(SeveralTables, WithTheSameHeadingsAreARunEach) {
  for (const std::string& text :
       {"Interval 1\n" + kHeadings + kOne + "\nInterval 2\n" + kHeadings + kTwo,
        "Instrument,x\nDate,1.5.2026\n\nInterval 1\n" + kHeadings + kOne + "Interval 2\n" + kHeadings + kTwo + "END\n",
        "Interval 1\n" + kHeadings + kOne + "Interval 2\n" + kTwo,  // without headings of its own
        kHeadings + "Interval 1,,\n" + kOne + "Interval 2,,\n" + kTwo,
        "Interval,1,,\n" + kHeadings + kOne + "Interval,2,3,\n" + kHeadings + kTwo + ",,\n"}) {
    const Dataset data = load(text);
    EXPECT_EQ(data.points.size(), 6u) << text;
    EXPECT_EQ(runs_of(data), data.curves[0] + ": 0 20 40\n" + data.curves[1] + ": 0 20 30\n") << text;
    EXPECT_EQ(data.curves[1].substr(0, 9), "Interval ") << text;
    EXPECT_NE(data.reading.find("2 tables, each a run"), std::string::npos) << data.reading;
  }
  EXPECT_EQ(runs_of(load(kHeadings + kOne + kHeadings + kTwo)), "table 1: 0 20 40\ntable 2: 0 20 30\n");
  // an equal load makes no run of two tables, nor a step of the load two of one
  EXPECT_EQ(load(kHeadings + kOne + kHeadings + kOne).curves.size(), 2u);
  EXPECT_EQ(load(kHeadings + kOne + kTwo + kHeadings + kOne).curves.size(), 2u);
}

TEST(SeveralTables, OfRheometersHaveIntervals) {
  const auto interval = [](int number, const std::string& rows) {
    return "Interval and data points:\t" + std::to_string(number) +
           "\t3\t\t\t\nInterval data:\tPoint No.\tTime\tNormal Force\tFriction Force\tContact Area\n\t\t\t\t\t\n\t\t[s]"
           "\t[N]\t[N]\t[mm²]\n" +
           rows + "\n";
  };
  const std::string text =
      "Project:\tPDMS\nTest:\tFriction 1\n\nResult:\tFriction 1 1\n" +
      interval(1, "\t1\t0.1\t0.008\t0.00\t0.46\n\t2\t0.2\t0.008\t0.02\t0.452\n\t3\t0.3\t0.008\t0.04\t0.441\n") +
      interval(2, "\t1\t0.1\t0.004\t0.00\t0.35\n\t2\t0.2\t0.004\t0.02\t0.341\n\t3\t0.3\t0.004\t0.03\t0.329\n") +
      interval(3, "\t1\t0.1\t0.002\t0.00\t0.25\n\t2\t0.2\t0.002\t0.02\t0.241\n\t3\t0.3\t0.002\t0.03\t0.229\n");
  EXPECT_EQ(runs_of(load(text)),
            "Interval and data points: 1 3: 0 20 40\nInterval and data points: 2 3: 0 20 30\nInterval and data points: "
            "3 3: 0 20 30\n");
}

TEST(SeveralTables, OfTestingMachinesHaveBlocksOfWords) {
  const auto block = [](const std::string& time, const std::string& rows) {
    return "Data Header:\tTime:\t" + time + "\tSec\t5/1/2026 10:00:00 AM\nData Acquisition:\tTimed Data\n" +
           "Axial Force\tShear Force\tContact Area\nN\tN\tmm^2\n" + rows;
  };
  const std::string text = "MTS793|MPT|ENU|1|0|.|,|:|1|0|0|A\n\n" +
                           block("12.5", "0.008\t0.00\t0.46\n0.008\t0.02\t0.452\n0.008\t0.04\t0.441\n") + "\n" +
                           block("40.25", "0.004\t0.00\t0.35\n0.004\t0.02\t0.341\n0.004\t0.03\t0.329\n") +
                           "Total\t2 blocks\n";
  const Dataset data = load(text);
  EXPECT_EQ(runs_of(data), "table 1: 0 20 40\ntable 2: 0 20 30\n");
}

/// As testing machines export specimens, and as people keep runs in a sheet.
TEST(SeveralTables, SideBySideAreARunEach) {
  const std::string head = "Normalkraft;Scherkraft;Kontaktfläche", units = "mN;mN;mm²\n",
                    two = head + ";" + head + "\n" + "mN;mN;mm²;" + units,
                    rows = "8;0;0,46;3,5;0;0,35\n8;20;0,452;3,5;20;0,341\n8;40;0,441;3,5;30;0,329\n";
  EXPECT_EQ(runs_of(load("Probe 1;;;Probe 2;;\n" + two + rows)), "Probe 1: 0 20 40\nProbe 2: 0 20 30\n");
  EXPECT_EQ(runs_of(load(two + rows)), "run 1: 0 20 40\nrun 2: 0 20 30\n");
  // one is longer, and a column stays empty between them
  EXPECT_EQ(
      runs_of(load("P [mN],T [mN],A [mm^2],,P [mN],T [mN],A [mm^2]\n8,0,0.46,,3.5,0,0.35\n8,20,0.45,,3.5,20,0.34\n"
                   "8,40,0.44\n8,45,0.43,,,,\n")),
      "run 1: 0 20 40 45\nrun 2: 0 20\n");
  const Dataset by_names =
      load("P = 8 mN,,P = 3.5 mN,\nT [mN],A [mm^2],T [mN],A [mm^2]\n0,0.46,0,0.35\n20,0.45,20,0.34\n40,0.44,30,0.33\n");
  EXPECT_EQ(runs_of(by_names), "P = 8 mN: 0 20 40\nP = 3.5 mN: 0 20 30\n");
  EXPECT_DOUBLE_EQ(by_names.curve_loads[1] * by_names.contact->force_unit(), 3.5e-3);
  // what cannot be read is named where it stands
  EXPECT_EQ(load_error("P [mN],T [mN],A [mm^2],P [mN],T [mN],A [mm^2]\n8,0,0.46,3.5,x,0.35\n", kConstants),
            "a.csv:2:14: column 'T': 'x' is not a number");
  // other units, or a column that only one has, are not the same
  EXPECT_NE(load_error(head + ";" + head + "\nmN;mN;mm²;N;mN;mm²\n" + rows, kConstants).find("may both be P"),
            std::string::npos);
}

TEST(SeveralTables, WhoseTitlesStateTheirLoads) {
  const std::string headings = "T [mN],A [mm^2]\n", one = "0,0.46\n20,0.452\n40,0.441\n",
                    two = "0,0.35\n20,0.341\n30,0.329\n";
  const auto expect = [](const std::string& text) {
    const Dataset data = load(text);
    ASSERT_EQ(data.curve_loads.size(), 2u) << text;
    EXPECT_DOUBLE_EQ(data.curve_loads[0] * data.contact->force_unit(), 8e-3) << text;
    EXPECT_DOUBLE_EQ(data.curve_loads[1] * data.contact->force_unit(), 3.5e-3) << text;
    EXPECT_EQ(runs_of(data), data.curves[0] + ": 0 20 40\n" + data.curves[1] + ": 0 20 30\n") << text;
  };
  expect("Normal load = 8 mN\n" + headings + one + "Normal load = 3.5 mN\n" + headings + two);
  expect("P: 8 mN\n" + headings + one + "\nP: 3.5 mN\n" + headings + two);
  expect("# T [mN], A [mm^2]\n# P = 8 mN\n" + one + "\n# run 2, P = 3.5 mN\n" + two);
  expect("# P = 8 mN\n" + headings + one + "# P = 3.5 mN\n" + headings + two);
  EXPECT_EQ(load("# P = 8 mN\n" + headings + one + "# P = 3.5 mN\n" + two).curves[0], "P=8 mN");
  // one load above all rows may be that of a setting
  EXPECT_NE(load_error("Load: 8 mN\n" + headings + one, kConstants).find("column 'P' is missing"), std::string::npos);
  EXPECT_NE(
      load_error("P = 8 mN\n" + headings + one + "P = 3.5 mN\n" + headings + two + "Dry\n" + headings + two, kConstants)
          .find("the title 'Dry' states no load"),
      std::string::npos);
}

TEST(SeveralTables, WithDecimalCommasAndAColumnOfRunsHaveTheRunsOfTheColumn) {
  const std::string headings = "Normalkraft [N];Reibkraft [N];Kontaktfläche [mm²];Versuch\n";
  const Dataset data = load("Schritt 1\n" + headings + "0,008;0,00;0,460;a\n0,008;0,02;0,452;a\n0,008;0,04;0,441;b\n" +
                            "Schritt 2\n" + headings + "0,008;0,05;0,42;b\n0,008;0,06;0,41;b\nSumme\n");
  EXPECT_EQ(runs_of(data), "a: 0 20\nb: 40 50 60\n");
}

TEST(SeveralTables, WithOtherHeadingsLeaveTheOneThatHasWhatIsNeeded) {
  const std::string speeds = "Speed (mm/s),Distance (mm),Cycles\n0.1,2,3\n0.2,4,3\n0.3,6,3\n0.4,6,3\n0.5,1,1\n";
  for (const std::string& text : {speeds + "\n" + kHeadings + kOne, kHeadings + kOne + "\nSettings\n" + speeds,
                                  kHeadings + kOne + speeds + "Interval 2\n" + kHeadings + kTwo + "\n" + speeds,
                                  speeds + kHeadings + kOne + kHeadings + kTwo}) {
    const Dataset data = load(text);
    EXPECT_EQ(runs_of(data).substr(runs_of(data).find(':'), 9), ": 0 20 40") << text;
    EXPECT_TRUE(data.points.size() == 3 || data.points.size() == 6) << text;
    EXPECT_NE(notes_of(data).find("is not read: Speed [mm/s], Distance [mm], Cycles"), std::string::npos) << text;
    EXPECT_TRUE(data.excluded.empty()) << text;
  }
}

TEST(SeveralTables, ThatCouldAllBeMeantAreListedAndOneIsChosen) {
  const std::string toughness = "psi [deg],Gc [mJ/m^2],note\n10,28,a\n30,33,b\n50,48,c\n",
                    text = kHeadings + kOne + "\nAs energies\n" + toughness + kHeadings + kTwo;
  EXPECT_EQ(load_error(text, kConstants),
            "a.csv:7:1: the file has tables with different headings: 1, from line 1: Normal Force [N], Friction Force "
            "[N], Contact Area [mm^2]; 2, from line 7: psi [deg], Gc [mJ/m^2], note; say which to read: --table=1, "
            "or the key table, or --table=2");
  EXPECT_EQ(runs_of(load(text, "table = \"1\"\n")), "table 1: 0 20 40\ntable 2: 0 20 30\n");
  EXPECT_EQ(load(text, "table = 2\n").converted.size(), 3u);
  EXPECT_EQ(load_error(text, kConstants + "table = \"3\"\n").substr(0, 28), "a.csv: has no table 3; there");
  // the second one in other units
  EXPECT_NE(
      load_error(kHeadings + kOne + "Interval 2\nNormal Force [mN],Friction Force [mN],Contact Area [mm^2]\n" + kTwo,
                 kConstants)
          .find("tables with different headings"),
      std::string::npos);
}

TEST(SeveralTables, DoNotExcuseARowThatIsNotUnderstood) {
  EXPECT_EQ(
      load_error(kHeadings + "0.008,0.00,0.46\n0.008,0.02x,0.452\n0.008,0.04,0.441\n" + kHeadings + kTwo, kConstants),
      "a.csv:3:7: column 'T': '0.02x' is not a number");
  EXPECT_EQ(load_error(kHeadings + kOne + kHeadings + "0.004,0.00,0.35\n0.004,x,0.341\n0.004,0.03,0.329\n", kConstants),
            "a.csv:7:7: column 'T': 'x' is not a number");
  EXPECT_EQ(load_error(kHeadings + kOne + "a remark\n" + kTwo + kHeadings + kTwo, kConstants),
            "a.csv:5:9: the row has 1 fields, the header 3");
  EXPECT_EQ(load_error(kHeadings + kOne + "1.2,1.3\n" + kHeadings + kTwo, kConstants),
            "a.csv:5:8: the row has 2 fields, the header 3");
  // no headings of the rows below
  EXPECT_EQ(load_error(kHeadings + kOne + "bad,bad,bad\n" + kTwo, kConstants),
            "a.csv:5:1: column 'P': 'bad' is not a number");
}

TEST(SeveralTables, OfAnyLengthAreRead) {
  std::string text = "# long\n";
  for (int k = 1; k <= 40; ++k) {
    text += "Block " + std::to_string(k) + "\n" + kHeadings;
    for (int i = 0; i < 1000; ++i) text += "0.008," + std::to_string(1e-5 * i) + ",0.46\n";
  }
  const Dataset data = load(text);
  EXPECT_EQ(data.points.size(), 40000u);
  ASSERT_EQ(data.curves.size(), 40u);
  EXPECT_EQ(data.curves[39], "Block 40");
  EXPECT_TRUE(data.excluded.empty());
}

TEST(SeveralTables, BehindTheFirstLinesAreChosenByTheirNumber) {
  std::string text = kHeadings;
  for (int i = 0; i < 10000; ++i) text += "0.008," + std::to_string(1e-5 * i) + ",0.46\n";
  EXPECT_EQ(load_error(text, kConstants + "table = 2\n").substr(0, 34), "a.csv: has no table 2; there is 1,");
  text += "psi [deg],Gc [mJ/m^2]\n10,28\n30,33\n50,48\n";
  EXPECT_EQ(load(text, "table = 2\n").converted.size(), 3u);
  EXPECT_EQ(load(text, "table = 1\n").points.size(), 10000u);
}

/// The error about a table of eight rows with this text after the fifth; empty if it is read.
std::string error_with(const std::string& between, const std::string& toml = "") {
  const std::string rows = "0.008,0.00,0.460\n0.008,0.02,0.452\n0.008,0.04,0.441\n";
  return load_error(kHeadings + rows + between + rows, kConstants + toml);
}

TEST(SeveralTables, DoNotBeginAtARemarkBetweenRows) {
  for (const std::string remark : {"hold,start,now", "hold,start", "begin,of,the sliding"}) {
    const std::string error = error_with(remark + "\n");
    EXPECT_NE(error.find(":5:1: the words '"), std::string::npos) << error;
    EXPECT_NE(error.find("if they are a remark, put '#' before them"), std::string::npos) << error;
    EXPECT_EQ(load(kHeadings + kOne + "#" + remark + "\n" + kTwo).points.size(), 6u) << remark;
  }
  // the other reading
  const Dataset first = load(kHeadings + kOne + "hold,start,now\n" + kTwo, "table = \"1\"\n");
  EXPECT_EQ(first.points.size(), 3u);
  EXPECT_NE(notes_of(first).find("the table in line 5 is not read: hold, start, now"), std::string::npos);
  // a second remark, behind a table with the same headings
  EXPECT_NE(load_error(kHeadings + kOne + kHeadings + kTwo + "hold,start,now\n" + kTwo, kConstants)
                .find(":9:1: the words 'hold, start, now' stand between rows of one form"),
            std::string::npos);
  // known names, units, and rows of another form make another table
  for (const std::string other : {"Time,Displacement,Normal Force\n1,2,3\n", "u,v,w\ns,mm,N\n1,2,3\n",
                                  "u [s],v [mm],w\n1,2,3\n", "left,right\n1,2\n3,4\n"})
    EXPECT_NE(notes_of(load(kHeadings + kOne + other)).find("the table in line 5 is not read"), std::string::npos)
        << other;
}

TEST(SeveralTables, ListARowAboveHeadingsThatIsNotUnderstood) {
  for (const char* row : {"Mean,0.02,0.45", "O.008,0.05,0.431"}) {
    const Dataset data = load(kHeadings + kOne + row + "\n" + kHeadings + kTwo);
    EXPECT_EQ(data.points.size(), 6u) << row;
    ASSERT_EQ(data.excluded.size(), 1u) << row;
    EXPECT_EQ(data.excluded[0].line, 5u);
    EXPECT_EQ(data.excluded[0].reason, "words where the rows above have numbers");
  }
  // in the second table, too
  const Dataset third = load(kHeadings + kOne + kHeadings + kTwo + "Mean,0.02,0.45\n" + kHeadings + kOne);
  ASSERT_EQ(third.excluded.size(), 1u);
  EXPECT_EQ(third.excluded[0].line, 9u);
  // with a number in front it is a row with a fault
  EXPECT_NE(error_with("0.008,O.05,O.431\n" + kHeadings).find(":5:7: column 'T': 'O.05' is not a number"),
            std::string::npos)
      << error_with("0.008,O.05,O.431\n" + kHeadings);
  // titles are none
  EXPECT_TRUE(load("Interval,1,,\n" + kHeadings + kOne + "Interval,2,3\n" + kHeadings + kTwo).excluded.empty());
}

}  // namespace several_tables_test
}  // namespace mixity
