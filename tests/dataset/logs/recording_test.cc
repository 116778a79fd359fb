// Logs as instruments write them.
#include "dataset/logs/recording.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>

#include "base/input_error.h"
#include "dataset/logs/read_log.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace recording_test {

using read_log::error_of, read_log::read;

TEST(Recordings, MayHaveTimesOfAClock) {
  const std::string header = "time,P [mN],T [mN],A [mm^2]\n", rest = ",1,2,0.3\n";
  EXPECT_EQ(read(header + "23:59:59.000" + rest + "23:59:59.500" + rest + "00:00:00.250" + rest).time,
            (std::vector<double>{0, 0.5, 1.25}));
  EXPECT_EQ(
      read(header + "2026-05-01T23:59:59Z" + rest + "2026-05-02T00:00:01Z" + rest + "2026-05-02T00:00:02.5Z" + rest)
          .time,
      (std::vector<double>{0, 2, 3.5}));
  EXPECT_EQ(read("Zeit;P [mN];T [mN];A [mm^2]\n10:05:00,000;0,8;1,5;0,25\n10:05:00,500;0,8;1,5;0,25\n"
                 "10:05:01,000;0,8;1,5;0,25\n")
                .T[0],
            1.5e-3);
}

/// ln(a/b) of the axes along and across the shear, as in tables of points.
TEST(Recordings, KeepTheAxesOfEllipticContacts) {
  const auto last = [](const std::string& header, const std::string& sizes) {
    std::string text = "time [s],P [mN],T [mN]," + header + '\n';
    for (const char* time : {"0", "1", "2"}) text += std::string(time) + ",1,2," + sizes + '\n';
    const Recording log = read(text);
    EXPECT_EQ(log.A.size(), 3u);
    return log.q.empty() ? NAN : log.q.back();
  };
  EXPECT_NEAR(last("a_par [mm],a_perp [mm]", "0.2,0.25"), std::log(0.8), 1e-15);
  EXPECT_NEAR(last("A [mm^2],d_par [mm],d_perp [mm]", "0.157,0.4,0.5"), std::log(0.8), 1e-15);
  EXPECT_NEAR(last("Major [mm],Minor [mm]", "0.5,0.4"), std::log(0.8), 1e-15);  // without an angle across the shear
  EXPECT_NEAR(last("Major [mm],Minor [mm],Angle", "0.5,0.4,90"), std::log(0.8), 1e-15);
  EXPECT_NEAR(last("Major [mm],Minor [mm],Angle", "0.5,0.4,0"), std::log(1.25), 1e-15);
  EXPECT_TRUE(std::isnan(last("A [mm^2]", "0.157")));
}

TEST(Recordings, WhoseAreaIsNotThatOfItsAxesSaySo) {
  const auto reading = [](const std::string& area) {
    std::string text = "time [s],P [mN],T [mN],A [mm^2],a_par [mm],a_perp [mm]\n0,0,0,0,0,0\n";
    for (const char* time : {"1", "2", "3"}) text += std::string(time) + ",1,2," + area + ",0.2,0.25\n";
    return read(text).reading;
  };
  EXPECT_NE(reading("0.1728").find("; A is 1.1 times pi a b of the axes (median), and is used"), std::string::npos);
  EXPECT_EQ(reading("0.16").find("pi a b"), std::string::npos);
}

TEST(Recordings, MayHaveTimesWithAUnitInEachField) {
  EXPECT_EQ(read("Time,P [mN],T [mN],A [mm^2]\n0 sec,1,2,0.3\n0.5 sec,1,2,0.3\n1.25 sec,1,2,0.3\n").time,
            (std::vector<double>{0, 0.5, 1.25}));
}

TEST(Recordings, OfAClockInItsHeadingHaveTimesOfAClock) {
  const std::string header = "Messzeit [hh:mm:ss];P [mN];T [mN];A [mm²]\n", rest = ";1;2;0,3\n";
  EXPECT_EQ(read(header + "00:00:59,50" + rest + "00:01:00,00" + rest + "00:01:00,50" + rest).time,
            (std::vector<double>{0, 0.5, 1}));
  EXPECT_NE(error_of(header + "0,00001" + rest + "0,00002" + rest + "0,00003" + rest)
                .find("'0,00001' is a number, not a time hh:mm:ss"),
            std::string::npos);
}

/// As programs write TDMS files as text.
TEST(Recordings, HaveSettingsOfTheirChannelsBelowTheHeadings) {
  const Recording log = read(
      "Channel\tTime\tNormal force\tShear force\tContact area\nUnit\ts\tmN\tmN\tmm²\nDatatype\tDT_DOUBLE\tDT_DOUBLE\t"
      "DT_DOUBLE\tDT_DOUBLE\nLength\t3\t3\t3\t3\n\t0\t1\t2\t0.3\n\t0.5\t1\t3\t0.3\n\t1\t1\t4\t0.2\n");
  EXPECT_EQ(log.time, (std::vector<double>{0, 0.5, 1}));
  EXPECT_NE(log.reading.find("line 4 passed over"), std::string::npos) << log.reading;
}

TEST(Recordings, WithOtherTimesAreRefusedByTheNameOfTheirColumn) {
  const std::string header = "time,P [mN],T [mN],A [mm^2]\n", rest = ",1,2,0.3\n";
  EXPECT_EQ(error_of(header + "10:05" + rest + "10:06" + rest + "10:07" + rest),
            "log.csv:2:1: column 'time': '10:05' is neither a number nor a time such as 10:05:00.25 or "
            "2026-05-01T10:05:00.25");
  EXPECT_EQ(error_of(header + "10:05:00" + rest + "2026-05-01T10:05:01" + rest),
            "log.csv:3:1: column 'time': '2026-05-01T10:05:01' is of another kind than the times above");
  EXPECT_EQ(error_of(header + "0,1,2,0.3\n1,x,2,0.3\n2,1,2,0.3\n"), "log.csv:3:3: column 'P': 'x' is not a number");
}

TEST(Recordings, MayHaveOtherWordsInTheNameOfTheirTimes) {
  const std::string rows = "\tP\tT\tA\n%\tmN\tmN\tmm^2\n0\t1\t2\t0.3\n0.5\t1\t3\t0.3\n1\t1\t4\t0.2\n";
  for (const auto& [name, unit] : {std::pair("Zeit  1 - Standardmessrate", "s"), std::pair("Time 1 - default", "Sec"),
                                   std::pair("Log time, corrected", "s")}) {
    std::string text = name + rows;
    text.replace(text.find('%'), 1, unit);
    EXPECT_EQ(read(text).time, (std::vector<double>{0, 0.5, 1})) << name;
  }
  // one of two is not chosen
  EXPECT_NE(error_of("Zeit 1 [s],Zeit 2 [s],P [mN],T [mN],A [mm^2]\n0,0,1,2,0.3\n1,2,1,2,0.3\n2,4,1,2,0.3\n")
                .find("which column it is: --columns=\"time=HEADING (s)\""),
            std::string::npos);
}

TEST(Recordings, WithoutAQuantityNameTheColumnThatMayHoldIt) {
  const std::string rows = "\n0,1,2,0.3\n1,1,2,0.3\n2,1,2,0.3\n";
  EXPECT_EQ(error_of("Dauer A [s],P [mN],T [mN],A [mm^2]" + rows),
            "log.csv:1:1: column 'time' is missing; state the rate of the rows, such as --rate=\"400 Hz\", or which "
            "column it is: --columns=\"time=Dauer A [s]\"");
  EXPECT_EQ(error_of("time [s],Kraft 1 [mN],Kraft 2 [mN],Patch [mm^2]" + rows),
            "log.csv:1:1: neither T nor A is there; not understood: 'Kraft 1 [mN]', 'Kraft 2 [mN]', 'Patch [mm^2]'. To "
            "say which columns are P, T and A: --columns=\"P=HEADING (UNIT),T=HEADING (UNIT),A=Patch [mm^2]\"");
  EXPECT_EQ(error_of("time [s],Kraft 1 [mN],T [mN],A [mm^2]" + rows),
            "log.csv:1:1: column 'P' is missing, and no load is stated; not understood: 'Kraft 1 [mN]'. To say which "
            "column is P: --columns=\"P=Kraft 1 [mN]\"");
}

TEST(Recordings, WithoutForcesNameTheColumnsThatMayHoldThem) {
  EXPECT_NE(read("time [s],Kraft 1 [mN],Kraft 2 [mN],A [mm^2]\n0,1,2,0.3\n1,1,2,0.3\n2,1,2,0.3\n")
                .advice.text()
                .find("P=HEADING (UNIT),T=HEADING (UNIT)"),
            std::string::npos);
}

TEST(Recordings, WithoutUnitsAreRefusedWithOneMappingForAllOfThem) {
  const std::string rows = "\n0,1,2,0.3\n1,1,2,0.3\n2,1,2,0.3\n";
  EXPECT_EQ(error_of("time [s],Fn,Ft,A [mm^2]" + rows),
            "log.csv:1:10: column 'Fn' needs a unit: a log is not dimensionless; say it: "
            "--columns=\"P=Fn (UNIT),T=Ft (UNIT)\"");
}

TEST(Recordings, OfLabVIEWHaveALabelBeforeTheirUnits) {
  const std::string lvm =
      "LabVIEW Measurement\t\n***End_of_Header***\t\nChannels\t3\t\t\nSamples\t3\t3\t3\n"
      "Y_Unit_Label\tmN\tmN\tmm^2\nX_Dimension\tTime\tTime\tTime\n***End_of_Header***\t\t\t\n"
      "X_Value\tNormal force\tShear force\tContact area\tComment\n0\t1\t2\t0.3\n0.5\t1\t3\t0.3\n1\t1\t4\t0.2\n";
  for (const char* columns : {"", "time=X_Value (s)"}) {
    const Recording log = read(lvm, columns);
    EXPECT_EQ(log.time, (std::vector<double>{0, 0.5, 1})) << columns;
    EXPECT_EQ(log.T[2], 4e-3) << columns;
  }
}

/// As universal testers and rheometers write steps.
TEST(Recordings, OfSeveralTablesAreOneLog) {
  const std::string head = "Time (s),Fz (N),Fx (N),Area (mm^2)\n",
                    zero = "0,0,0,0\n0.5,0.004,0,0.3\n1,0.004,0.01,0.3\n",
                    on = "1.5,0.004,0.02,0.2\n2,0.004,0.03,0.2\n", anew = "0,0.004,0.02,0.2\n0.5,0.004,0.03,0.2\n";
  for (const std::string& text :
       {"Step 1\n" + head + zero + "\nStep 2\n" + head + on + "END\n",
        "Step 1\n" + head + zero + "Step 2\n" + head + anew + "END OF DATA,,,\n",
        "Step,1,20\n" + head + zero + "Step,2,20\n" + head + anew, "Step 1\n" + head + zero + "Step 2\n" + on}) {
    const Recording log = read(text);
    EXPECT_EQ(log.time, (std::vector<double>{0, 0.5, 1, 1.5, 2})) << text;
    EXPECT_EQ(log.T[4], 0.03) << text;
    EXPECT_NE(log.reading.find("2 tables"), std::string::npos) << log.reading;
  }
  const std::string other = "Speed (mm/s),Stroke (mm),Cycles\n1,2,3\n1,2,4\n1,2,5\n";
  EXPECT_EQ(read(other + head + zero + other).time.size(), 3u);
  EXPECT_EQ(error_of(head + zero + anew), "log.csv:5: holds fewer than three rows of a log");
}

Recording read_with(const std::string& text, const Overrides& stated) {
  const TemporaryFolder folder;
  Metadata metadata;
  apply_overrides(stated, metadata);
  return read_recordings(folder.write("log.csv", text), metadata).front();
}
std::string error_with(const std::string& text, const Overrides& stated) {
  return input_error([&] { read_with(text, stated); });
}

TEST(Recordings, WithoutTimesHaveThoseOfARate) {
  const std::vector<double> times{0, 0.0025, 0.005};
  const std::string rows = "0\t0\t0\n4\t0\t0.35\n4\t10\t0.349\n", head = "P [mN]\tT [mN]\tA [mm^2]\n";
  EXPECT_EQ(read("Sampling rate [Hz]:\t400\n" + head + rows).time, times);
  EXPECT_EQ(read("# Sample interval: 2.5 ms\n" + head + rows).reading,
            "tabs, headings in line 2, times by the rate in line 1, 400 Hz");
  for (const char* rate : {"400 Hz", "0.4 kHz", "2.5 ms", "0,0025 s"})
    EXPECT_EQ(read_with(head + rows, {{"rate", rate}}).time, times) << rate;
  EXPECT_EQ(read_with("Sampling rate [Hz]:\t100\n" + head + rows, {{"rate", "400 Hz"}}).time, times);
  // a column of times that is empty, as LabVIEW's without one
  EXPECT_EQ(read("Delta_X\t0.0025\t0.0025\t0.0025\nX_Value\tP [mN]\tT [mN]\tA [mm^2]\tComment\n"
                 "\t0\t0\t0\n\t4\t0\t0.35\tcontact\n\t4\t10\t0.349\n")
                .time,
            times);
  EXPECT_EQ(
      error_of(head + rows),
      "log.csv:1:1: column 'time' is missing; state the rate of the rows, such as --rate=\"400 Hz\", or which column "
      "it is: --columns=\"time=HEADING (s)\"");
  EXPECT_EQ(error_of("t [s]\t" + head + "\t0\t0\t0\n\t4\t0\t0.35\n\t4\t10\t0.349\n"),
            "log.csv:1:1: column 'time' is empty; state the rate of the rows, such as --rate=\"400 Hz\"");
  EXPECT_EQ(error_of("dt = 1\nt [s]\t" + head + "\t0\t0\t0\n1\t4\t0\t0.35\n\t4\t10\t0.349\n"),
            "log.csv:4:1: column 'time': the row has a time where rows above have none");
  EXPECT_EQ(read("Sample rate: 1 Hz\nt [s]\t" + head + "0\t0\t0\t0\n5\t4\t0\t0.35\n6\t4\t10\t0.349\n").time,
            (std::vector<double>{0, 5, 6}));  // the column has the word
}

TEST(Recordings, MayCountFrames) {
  const std::string rows = "1,0.35\n2,0.349\n5,0.347\n";
  for (const char* head :
       {"Slice,Area (mm^2)\n", "Frame,A [mm^2]\n", "Bild,Kontaktfläche (mm²)\n", "Index,A [mm^2]\n"}) {
    EXPECT_EQ(read_with(head + rows, {{"fps", "25"}}).time, (std::vector<double>{0.04, 0.08, 0.2})) << head;
    EXPECT_EQ(read(std::string("Frame rate: 25\n") + head + rows).time, (std::vector<double>{0.04, 0.08, 0.2})) << head;
  }
  // ImageJ: rows are numbered without a heading
  EXPECT_EQ(
      read_with(" ,Label,Area (mm^2),Slice\n1,a.tif:1,0.35,1\n2,a.tif:2,0.349,2\n3,a.tif:5,0.347,5\n", {{"fps", "25"}})
          .time[2],
      0.2);
  EXPECT_NE(
      error_with("Slice,Area (mm^2)\n" + rows, {})
          .find(":1:1: column 'time' is missing, and 'Slice' counts frames or rows: say how many a second: --fps=25, "
                "or which column it is"),
      std::string::npos);
  EXPECT_NE(error_with("Slice,Area (mm^2)\n1,0.3\n1,0.3\n2,0.3\n", {{"fps", "25"}})
                .find("column 'frame': frame 1 after frame 1: each row needs a frame of its own"),
            std::string::npos);
  // beside forces of another rate: frames are those of the areas
  const Overrides both{{"fps", "25"}, {"rate", "400 Hz"}};
  EXPECT_EQ(read_with("Slice,Area (mm^2)\n" + rows, both).time[0], 0.04);
  EXPECT_EQ(read_with("Index,P [mN],T [mN]\n0,1,2\n1,1,2\n2,1,2\n", both).time[1], 0.0025);
  EXPECT_EQ(read_with("Area (mm^2)\tmean\n0.3\t4\n0.3\t4\n0.3\t4\n", {{"fps", "25"}}).time[1], 0.04);
}

/// The forms that the writer of LabVIEW has.
TEST(Recordings, OfLabVIEWAreReadInEachForm) {
  const std::string first =
      "LabVIEW Measurement\t\nWriter_Version\t2\nReader_Version\t2\nSeparator\tTab\n"
      "Decimal_Separator\t.\nMulti_Headings\tYes\nX_Columns\tOne\nTime_Pref\tRelative\nOperator\t"
      "x\nDate\t2026/05/01\nTime\t10:00:00.5\n***End_of_Header***\t\n\t\n";
  const auto head = [](const std::string& x) {
    return "Channels\t3\t\t\t\nSamples\t3\t3\t3\t\nDate\t2026/05/01\t2026/05/01\t2026/05/01\t\n"
           "Time\t10:00:00.5\t10:00:00.5\t10:00:00.5\t\nY_Unit_Label\tNewtons\tNewtons\tmm^2\t\n"
           "X_Dimension\tTime\tTime\tTime\t\nX0\t" +
           x + "\t" + x + "\t" + x + "\t\nDelta_X\t0.5\t0.5\t0.5\t\n***End_of_Header***\t\t\t\t\n";
  };
  const std::string names = "X_Value\tNormal force\tShear force\tContact area\tComment\n";
  const auto expect = [](const Recording& log, std::size_t rows, const char* form) {
    ASSERT_EQ(log.time.size(), rows) << form;
    for (std::size_t i = 0; i < rows; ++i) EXPECT_NEAR(log.time[i], 0.5 * static_cast<double>(i), 1e-12) << form;
    EXPECT_EQ(log.P[1], 0.008) << form;
    EXPECT_EQ(log.T[2], 0.02) << form;
    EXPECT_NEAR(log.A[1], 0.3e-6, 1e-20) << form;
  };
  expect(
      read(first + head("0") + names + "0.0\t0\t0\t0\n0.5\t0.008\t0.01\t0.3\tstart of shear\n1.0\t0.008\t0.02\t0.3\n"),
      3, "One, a comment in one row");
  expect(read(first + head("0") + names + "\t0\t0\t0\n\t0.008\t0.01\t0.3\n\t0.008\t0.02\t0.3\n"), 3, "No");
  const std::string multi = std::regex_replace(
      head("0"), std::regex("\t(3|0|0.5|2026/05/01|10:00:00.5|Newtons|mm\\^2|Time)(?=\t)"), "\t$1\t");
  expect(read(first + multi +
              "X_Value\tNormal force\tX_Value\tShear force\tX_Value\tContact area\tComment\n"
              "0\t0\t0\t0\t0\t0\n0.5\t0.008\t0.5\t0.01\t0.5\t0.3\n1\t0.008\t1\t0.02\t1\t0.3\n"),
         3, "Multi");
  expect(read(first + head("0") + names + "0.0\t0\t0\t0\n0.5\t0.008\t0.01\t0.3\n1.0\t0.008\t0.02\t0.3\n\n" +
              head("1.5") + names + "1.5\t0.008\t0.03\t0.2\tlast\n2.0\t0.008\t0.04\t0.2\n2.5\t0.008\t0.05\t0.2\n"),
         6, "segments");
  std::string comma = first + head("0") + names +
                      "0.000\t0.000\t0.000\t0.000\n0.500\t0.008\t0.010\t0.300\n1.000\t0.008\t0.020\t0.300\n";
  std::replace(comma.begin() + static_cast<std::ptrdiff_t>(comma.find("Decimal")), comma.end(), '.', ',');
  expect(read(comma), 3, "decimal commas that could be groups of three");
}

/// LabVIEW's form Multi, and tables of other programs that have a column of times for each channel.
TEST(Recordings, WithAColumnOfTimesForEachChannelAreReadIfTheseAgree) {
  const std::vector<double> times{0, 0.5, 1};
  const auto rows = [](const std::string& x, const std::string& of_area) {  // "0 0.5 1"
    std::string text;
    std::istringstream xs(x), areas(of_area);
    for (std::string one, other; xs >> one && areas >> other;)
      text += one + "\t1\t" + one + "\t2\t" + other + "\t0.3\n";
    return text;
  };
  const std::string names = "X_Value\tP [mN]\tX_Value\tT [mN]\tX_Value\tA [mm^2]\n";
  const std::string numbered = "Time 1 (s)\tP [mN]\tTime 2 (s)\tT [mN]\tTime 3 (s)\tA [mm^2]\n";
  EXPECT_EQ(read(names + rows("0 0.5 1", "0 0.5 1")).time, times);
  EXPECT_EQ(read(names + rows("0 0.5 1", "1e-6 0.500001 1.000001")).time, times);  // rounded
  EXPECT_EQ(read(numbered + rows("0 0.5 1", "0 0.5 1"), "time=Time 1 (s)").time, times);
  EXPECT_EQ(read("Time (s)\tP [mN]\tTime (s)\tT [mN]\tTime (ms)\tA [mm^2]\n" + rows("0 0.5 1", "0 500 1000")).time,
            times);
  // other rate, other start, other start by the clock
  const std::string refusal =
      ": the channels have clocks of their own; resample them to one before the export, and export one column of times";
  const std::string as_two = ", or export forces and areas as two files";
  EXPECT_EQ(error_of(names + rows("0 0.5 1", "0 0.4 0.8")),
            "log.csv:3:13: the time of A is 0.4, but column 1 'X_Value' says 0.5" + refusal + as_two);
  EXPECT_EQ(error_of(names + rows("0 0.5 1", "0.02 0.52 1.02")),
            "log.csv:3:13: the time of A is 0.52, but column 1 'X_Value' says 0.5" + refusal + as_two);
  EXPECT_EQ(error_of(names + rows("10:00:00.0 10:00:00.5 10:00:01.0", "10:00:00.1 10:00:00.6 10:00:01.1")),
            "log.csv:2:27: the time of A is 10:00:00.1, but column 1 'X_Value' says 10:00:00.0" + refusal + as_two);
  EXPECT_EQ(error_of("X_Value\tP [mN]\tX_Value\tT [mN]\tA [mm^2]\n0\t1\t0\t2\t3\n1\t1\t1.5\t2\t3\n"),
            "log.csv:3:5: the time of T, A is 1.5, but column 1 'X_Value' says 1" + refusal);
  const TemporaryFolder folder;
  Metadata first;
  set_field(first, "columns", "time=Time 1 (s)");
  const std::string path = folder.write("log.csv", numbered + rows("0 0.5 1", "0 0.4 0.8"));
  EXPECT_NE(input_error([&] { read_recordings(path, first); }).find("the time of A is 0.4, but column 1 'Time 1'"),
            std::string::npos);
  // rates that the decimal comma hides, and a slower channel that ends
  std::string commas = names + rows("0 0.5 1", "0 0.4 0.8");
  std::replace(commas.begin(), commas.end(), '.', ',');
  EXPECT_NE(error_of(commas).find("the time of A is 0.4"), std::string::npos);
  EXPECT_EQ(read(names + rows("0 0.5 1", "0 0.5 1") + "1.5\t1\t1.5\t2\t\t\n").time.size(), 4u);
}

TEST(Recordings, TakeTheTimesOfTheChannelsThatAreRead) {
  // a thermometer at another rate, whose times come first; T in s, which is no force
  EXPECT_EQ(read("X_Value,Temp (°C),X_Value,P [mN],X_Value,T [mN],X_Value,A [mm^2]\n"
                 "0,20,0,1,0,2,0,0.3\n2,20,0.5,1,0.5,2,0.5,0.3\n4,20,1,1,1,2,1,0.3\n")
                .time,
            (std::vector<double>{0, 0.5, 1}));
  EXPECT_EQ(read("T (s),Fz (N),T (N),A (mm^2)\n0,1,7,0.3\n1,1,8,0.3\n2,1,9,0.3\n").time,
            (std::vector<double>{0, 1, 2}));
  // times behind their channels
  EXPECT_EQ(error_of("P [mN],Time (s),T [mN],Time (s),A [mm^2],Time (s)\n1,0,2,0,0.3,0\n1,1,2,1,0.3,2\n1,2,2,2,0.3,4\n")
                .substr(0, 70),
            "log.csv:3:13: the time of A is 2, but column 2 'Time' says 1: the chan");
}

TEST(Recordings, OfTestersOfFrictionAreRead) {
  const std::vector<double> times{0, 0.5, 1};
  for (const char* head :
       {"T (s),Fz (N),Fx (N),A (mm^2)\n", "DAQ.T (s),DAQ.Fz (N),DAQ.Fx (N),Cam.Area (mm^2)\n",
        "Zeit / s,Kraft normal / N,Kraft tangential / N,Fläche Kontakt / mm²\n",
        "\"Time, s\",\"Normal Force, N\",\"Friction Force, N\",\"Contact area, mm^2\"\n", "T,Fz,Fx,A\ns,N,N,mm^2\n"}) {
    const Recording log = read(std::string(head) + "0,0,0,0\n0.5,0.008,0.01,0.3\n1,0.008,0.02,0.3\n");
    EXPECT_EQ(log.time, times) << head;
    EXPECT_EQ(log.T[2], 0.02) << head;
    EXPECT_EQ(log.P[2], 0.008) << head;
  }
  EXPECT_EQ(error_of("time (s),Load (g),Friction (g),A (mm^2)\n0,0,0,0\n0.5,0.8,1,0.3\n1,0.8,2,0.3\n"),
            "log.csv:1:10: 'Load (g)' may be P, but 'g' is not a force such as mN: it is a mass; if a weight is meant: "
            "--columns=\"P=Load (gf)\"");
  const Recording weighed = read("time (s),Load (g),Friction (mg),A (mm^2)\n0,0,0,0\n0.5,0.8,1,0.3\n1,0.8,2,0.3\n",
                                 "P=Load (gf),T=Friction (mgf)");
  EXPECT_NEAR(weighed.P[1], 0.8 * 9.80665e-3, 1e-15);
  EXPECT_NEAR(weighed.T[2], 2 * 9.80665e-6, 1e-15);
}

TEST(Recordings, SayThatAStatedRateIsNotUsedBesideTimes) {
  const TemporaryFolder folder;
  const std::string rows = "0,1,2,0.3\n0.1,1,2,0.3\n0.2,1,2,0.3\n0.3,1,2,0.3\n",
                    path = folder.write("log.csv", "time [s],P [mN],T [mN],A [mm^2]\n" + rows),
                    areas = folder.write("areas.csv", "time [s],A [mm^2]\n0,0.3\n1,0.3\n2,0.3\n");
  const auto with = [](const char* name, const char* text) {
    Metadata metadata;
    EXPECT_EQ(set_field(metadata, name, text), "");
    return metadata;
  };
  for (const char* rate : {"10 Hz", "10.05 Hz", "0.1 s"})
    EXPECT_NE(read_recordings(path, with("rate", rate))
                  .front()
                  .reading.find("the rate that is stated is not used: column 'time [s]' has 10 rows a second"),
              std::string::npos)
        << rate;
  EXPECT_NE(read_recordings(path, with("fps", "25")).front().reading.find("the fps that is stated is not used"),
            std::string::npos);
  EXPECT_EQ(folder.left_out_of(input_error([&] { read_recordings(path, with("rate", "400 Hz")); })),
            "log.csv:1:1: column 'time [s]' has 10 rows a second, and the rate that is stated is 400 Hz: leave out the "
            "one that is wrong");
  // the rate beside two files is that of the forces
  EXPECT_EQ(read_recordings(areas, with("rate", "10 Hz")).front().reading.find("not used"), std::string::npos);
  EXPECT_NE(error_of("Max. sampling rate: 10 kHz\nP [mN],T [mN],A [mm^2]\n1,2,0.3\n1,2,0.3\n1,2,0.3\n")
                .find("; line 1, 'Max. sampling rate: 10 kHz', is not taken for it"),
            std::string::npos);
}

TEST(Recordings, NameTheLinesThatAreLeftOut) {
  const std::string header = "time [s],P [mN],T [mN],A [mm^2]\n", rows = "0,1,2,0.3\n1,1,2,0.3\n2,1,2,0.3\n",
                    more = "3,1,2,0.3\n4,1,2,0.3\n5,1,2,0.3\n";
  const Recording log = read(header + rows + "Mean,1,2,0.3\n" + header + more + "end of test\n");
  EXPECT_EQ(log.time.size(), 6u);
  EXPECT_NE(log.reading.find("line 5 left out: words where the rows above have numbers"), std::string::npos)
      << log.reading;
  EXPECT_NE(error_of(header + rows + "hold,start,now,then\n" + more).find("log.csv:5:1: the words 'hold"),
            std::string::npos);
}

}  // namespace recording_test
}  // namespace mixity
