#include "dataset/table/plot_import.h"

#include <gtest/gtest.h>

#include <array>
#include <utility>
#include <vector>

#include "dataset/dataset.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace plot_import_test {

// Two data sets as WebPlotDigitizer exports them: the shorter one is padded.
constexpr const char* kExport =
    "P = 1 mN,,\"second, \"\"P\"\" = 2\",\n"
    "X,Y,X,Y\n"
    "0.0123456789012345678,0.25,0,0.31\n"
    "0.5,0.240,0.4,0.3\n"
    ",,0.8,0.29\n";

PlotImport in_milli(const std::vector<double>& loads) {
  PlotImport options{"T [mN]", "A [mm^2]", {}};
  for (const double load : loads) options.loads.push_back({load, parse_unit("mN").value()});
  return options;
}

PlotImport bare(const std::string& x, const std::string& y, std::size_t loads) {
  return {x, y, std::vector<Quantity>(loads, Quantity{1, {}})};
}

std::string import(std::string_view text, const PlotImport& options) {
  const TemporaryFolder folder;
  return import_plot(folder.write("plot.csv", text), options);
}

std::string error_of(std::string_view text, const PlotImport& options) {
  return file_error("plot.csv", text, [&](const std::string& path) { import_plot(path, options); });
}

TEST(PlotImport, PairsOfColumnsBecomeRows) {
  EXPECT_EQ(import(kExport, in_milli({1, 2.5})),
            "curve,P [mN],T [mN],A [mm^2]\n"
            "P = 1 mN,1,0.0123456789012345678,0.25\n"
            "P = 1 mN,1,0.5,0.240\n"
            "\"second, \"\"P\"\" = 2\",2.5,0,0.31\n"
            "\"second, \"\"P\"\" = 2\",2.5,0.4,0.3\n"
            "\"second, \"\"P\"\" = 2\",2.5,0.8,0.29\n");
}

TEST(PlotImport, TheResultIsADataSet) {
  const TemporaryFolder folder;
  const Dataset data = load_dataset(folder.write("a.csv", import(kExport, in_milli({1, 2}))),
                                    {{"radius", "9.42 mm"}, {"modulus", "2.133 MPa"}, {"toughness", "27 mJ/m^2"}});
  EXPECT_EQ(data.points.size(), 5);
  EXPECT_EQ(data.curves, (std::vector<std::string>{"P = 1 mN", "second, \"P\" = 2"}));
  EXPECT_NEAR(data.curve_loads[1] * data.display.force_scale, 2, 1e-15);  // some roundings of 1.1e-16
  EXPECT_NEAR(data.points[1].A * data.display.area_scale, 0.24, 1e-15);
}

TEST(PlotImport, ConvertedPointsNeedNoLoads) {
  const PlotImport options{"psi [deg]", "Gc_over_GIc", {}};
  const std::string csv = import("Fig. 8,\nX,Y\n0,1\n30,1.2\n", options);
  EXPECT_EQ(csv, "curve,psi [deg],Gc_over_GIc\nFig. 8,0,1\nFig. 8,30,1.2\n");
  const TemporaryFolder folder;
  EXPECT_EQ(load_dataset(folder.write("a.csv", csv)).points.size(), 2);
}

TEST(PlotImport, SpellingsOfTheExportMakeNoDifference) {
  const std::string expected = "curve,P,T,A\na,1,0,2\nb,1,0,3\nb,1,1,2.5\n";
  for (const char* text : {
           "a,,b,\nX,Y,X,Y\n0,2,0,3\n,,1,2.5\n",
           "a,,b\nX,Y,X,Y\n0,2,0,3\n,,1,2.5\n",           // no comma behind the last name
           "a,,b,\r\nX,Y,X,Y\r\n0,2,0,3\r\n,,1,2.5\r\n",  // CRLF
           ("\xEF\xBB\xBF"
            "a,,b,\nX,Y,X,Y\n0,2,0,3\n,,1,2.5\n"),  // byte order mark
           "a;;b;\nX;Y;X;Y\n0;2;0;3\n;;1;2.5\n",
           "a\t\tb\t\nX\tY\tX\tY\n0\t2\t0\t3\n\t\t1\t2.5\n",
           "a,,b,\n0,2,0,3\n,,1,2.5\n",  // no labels
           "\"a\",,\"b\",\n\"X\",\"Y\",\"X\",\"Y\"\n0,2,0,3\n,,1,2.5\n\n",
       })
    EXPECT_EQ(import(text, bare("T", "A", 2)), expected) << text;
}

TEST(PlotImport, ShortRowsEndTheLaterDataSets) {
  EXPECT_EQ(import("a,,b,\nX,Y,X,Y\n0,2,0,3\n1,1.5\n", bare("T", "A", 2)),
            "curve,P,T,A\na,1,0,2\na,1,1,1.5\nb,1,0,3\n");
}

TEST(PlotImport, ANameThatLooksLikeACommentIsAName) {
  const std::string text = import("#1,,#2,\nX,Y,X,Y\n0,2,0,3\n", bare("T", "A", 2));
  EXPECT_EQ(text, "curve,P,T,A\n\"#1\",1,0,2\n\"#2\",1,0,3\n");
}

TEST(PlotImport, DataSetsWithoutANameAreNumbered) {
  EXPECT_EQ(import(",,b,\nX,Y,X,Y\n0,2,0,3\n", bare("T", "A", 2)), "curve,P,T,A\ndata set 1,1,0,2\nb,1,0,3\n");
  EXPECT_EQ(import(",,,\nX,Y,X,Y\n0,2,0,3\n", bare("T", "A", 2)), "curve,P,T,A\ndata set 1,1,0,2\ndata set 2,1,0,3\n");
}

TEST(PlotImport, WhatIsNoExportIsRefusedWithItsPlace) {
  const PlotImport two = bare("T", "A", 2);
  for (const auto& [text, error] : std::vector<std::pair<std::string, std::string>>{
           {"", "1:1: is empty: a row with the data sets' names is missing"},
           {"a,,b,\nX,Y,X,Y\n", "2:1: holds no points"},
           {",,,\n,,\n", "1:1: holds no points"},
           {"a,,b,\nO,9,0,12\n1,8,1,11\n", "2:1: 'O' is not a finite number"},  // not labels
           {"a,,a,\nX,Y,X,Y\n0,9,0,12\n", "1:4: a second data set is named 'a'"},
           {"data set 2,,,\nX,Y,X,Y\n0,9,0,12\n", "1:13: a second data set is named 'data set 2'"},
           {"a,,b,\nX,Y,X,Y\n0,abc,0,1\n", "3:3: 'abc' is not a finite number"},
           {"a,,b,\nX,Y,X,Y\n0,1,nan,1\n", "3:5: 'nan' is not a finite number"},
           {"a,,b,\nX,Y,X,Y\n0,1,,1\n", "3:5: data set 'b' has one coordinate of a point without the other"},
           {"a,,b,\nX,Y,X,Y\n0,,0,1\n", "3:3: data set 'a' has one coordinate of a point without the other"},
           {"a,,b,\nX,Y,X,Y\n0,1,0\n", "3:6: data set 'b' has one coordinate of a point without the other"},
           {"a,,b,\nX,Y,X,Y\n0,1,0,1,7\n", "3:9: a value stands beyond the last named data set"},
           {"a,,b,,c,\nX,Y,X,Y,X,Y\n0,1,0,1,0,1\n", "1:1: holds 3 data sets, but 2 loads were given"},
           {"a,\nX,Y\n0,1\n", "1:1: holds 1 data sets, but 2 loads were given"},
       })
    EXPECT_EQ(error_of(text, two), "plot.csv:" + error) << text;
}

TEST(PlotImport, HeadersThatWouldNotBeReadBackAreRefused) {
  for (const PlotImport& options : {
           bare("T [foo]", "A", 1),   // no unit
           bare("T [mm]", "A", 1),    // the wrong kind
           bare("T [mN", "A", 1),     // not closed
           bare("shear", "A", 1),     // T is missing
           bare("T", "T", 1),         // twice
           bare("P", "A", 1),         // P twice, T missing
           bare("T", "A, in mm", 1),  // would be two columns
           bare("T", "A [mm^2]", 1),  // mixed with loads without a unit
           bare("T", "A", 0),         // no loads
           bare("psi", "Gc", 1),      // loads where none belong
       })
    EXPECT_NE(error_of("a,\nX,Y\n0,1\n", options), "") << options.x_column << " " << options.y_column;
}

TEST(PlotImport, ASharedColumnOfXBelongsToEachCurve) {
  const PlotImport options{"psi [deg]", "Gc [mJ/m^2]", {}};
  const std::string expected = "curve,psi [deg],Gc [mJ/m^2]\ndry,0,21.5\ndry,15,22.9\nwet,0,20.1\nold,15,19.6\n";
  for (const char* text : {
           "x,dry,wet,old\n0,21.5,20.1,\n15,22.9,,19.6\n", "psi [deg];dry;wet;old\n0;21,5;20,1;\n15;22,9;;19,6\n",
           "phase angle\tdry\twet\told\n0\t21.5\t20.1\n15\t22.9\t\t19.6\n",
           ",dry,wet,old\n0,21.5,20.1,NA\n15,22.9,NA,19.6\n",
           "angle;dry;wet;old\ndeg;mJ/m^2;mJ/m^2;mJ/m^2\n0;21.5;20.1;\n15;22.9;;19.6\n",  // the gaps are of no pairs
       })
    EXPECT_EQ(import(text, options), expected) << text;
  EXPECT_EQ(import("x,Curve1\n0,1\n30,1.2\n", options), "curve,psi [deg],Gc [mJ/m^2]\nCurve1,0,1\nCurve1,30,1.2\n");
}

TEST(PlotImport, NamesThatRepeatInPairsAreOfPairs) {
  for (const auto& [row, one, other] : std::vector<std::array<std::string, 3>>{
           {"X,Y,X,Y", "data set 1", "data set 2"},
           {"x,dry,x,wet", "dry", "wet"},
           {",dry,,wet", "dry", "wet"},
           {"dry T,dry A,wet T,wet A", "dry T", "wet T"},
           {"T1,A1,T2,A2", "T1", "T2"},
           {"dry,dry,wet,wet", "dry", "wet"},
           {"dry,one,wet,two\nX,Y,X,Y", "dry", "wet"},
       })
    EXPECT_EQ(import(row + "\n0,2,0,3\n1,1.5,2,2.5\n", bare("T", "A", 2)),
              "curve,P,T,A\n" + one + ",1,0,2\n" + one + ",1,1,1.5\n" + other + ",1,0,3\n" + other + ",1,2,2.5\n")
        << row;
  // a gap in the first column is of no shared x
  EXPECT_EQ(import("dry,one,wet,two\n0,2,0,3\n,,2,2.5\n", bare("T", "A", 2)),
            "curve,P,T,A\ndry,1,0,2\nwet,1,0,3\nwet,1,2,2.5\n");
}

/// Engauge's "one curve on each line", and digitisers that write a title above each curve.
TEST(PlotImport, CurvesBelowOneAnotherAreSeveral) {
  const PlotImport options{"psi [deg]", "Gc [mJ/m^2]", {}};
  const std::string expected =
      "curve,psi [deg],Gc [mJ/m^2]\ndry,0,21.5\ndry,15,22.9\nwet,0,20.1\nold,15,19.6\nold,30,18\n";
  for (const char* text : {
           "x,dry\n0,21.5\n15,22.9\n\nx,wet\n0,20.1\n\nx,old\n15,19.6\n30,18\n",
           "x,dry\n0,21.5\n15,22.9\nx,wet\n0,20.1\nx,old\n15,19.6\n30,18",                          // no blank lines
           "# x\tdry\n0\t21.5\n15\t22.9\n\n\n# x\twet\n0\t20.1\n\n\n# x\told\n15\t19.6\n30\t18\n",  // for gnuplot
           "\"x\",\"dry\"\r\n0,21.5\r\n15,22.9\r\n\r\n\"x\",\"wet\"\r\n0,20.1\r\n\r\n\"x\",\"old\"\r\n15,19.6\r\n30,"
           "18\r\n",
           "x;dry\n0;21,5\n15;22,9\n\nx;wet\n0;20,1\n\nx;old\n15;19,6\n30;18\n",
           "x,dry\n0,21.5\n15,22.9\n30,\n\nx,wet\n0,20.1\n15,\n30,\n\nx,old\n0,\n15,19.6\n30,18\n",  // raw points
           "psi,dry\n0,21.5\n15,22.9\n\npsi,wet,old\n0,20.1,\n15,,19.6\n30,,18\n",
           "dry,\nX,Y\n0,21.5\n15,22.9\n\nwet,\nX,Y\n0,20.1\n\nold,\nX,Y\n15,19.6\n30,18\n",
           "dry\n0,21.5\n15,22.9\n\nwet\n0,20.1\n\nold\n15,19.6\n30,18\n",
           "dry,,wet,\nX,Y,X,Y\n0,21.5,0,20.1\n15,22.9,,\n\nold,\nX,Y\n15,19.6\n30,18\n",
       })
    EXPECT_EQ(import(text, options), expected) << text;
  // loads in their order, names that are numbers, a curve without points
  EXPECT_EQ(import("x,5\n0,2\n\nx,10\n0,3\n1,2.5\n", in_milli({5, 10})),
            "curve,P [mN],T [mN],A [mm^2]\n5,5,0,2\n10,10,0,3\n10,10,1,2.5\n");
  EXPECT_EQ(import("x,one\n\nx,two\n0,3\n1,2.5\n", in_milli({5, 10})),
            "curve,P [mN],T [mN],A [mm^2]\ntwo,10,0,3\ntwo,10,1,2.5\n");
  EXPECT_EQ(import("x;a, 5 mN\n0,5;2,25\n\nx;b, 10 mN\n0,5;3,25\n", in_milli({5, 10})),
            "curve,P [mN],T [mN],A [mm^2]\n\"a, 5 mN\",5,0.5,2.25\n\"b, 10 mN\",10,0.5,3.25\n");
}

TEST(PlotImport, WhatIsNotUnderstoodBelowACurveIsNoOtherCurve) {
  const PlotImport options{"psi [deg]", "Gc [mJ/m^2]", {}};
  for (const auto& [text, error] : std::vector<std::pair<std::string, std::string>>{
           {"x,dry\n0,21.5\nO,22.9\n", "3:1: 'O' is not a finite number"},
           {"x,dry\n0,21.5\nO,\n30,1\n", "3:1: 'O' is not a finite number"},
           {"x,dry\n0,21.5\n\nx,dry\n30,1\n", "4:3: a second data set is named 'dry'"},
           {"x,dry\n0,21.5\n\nx,wet\n3O,1\n", "5:1: '3O' is not a finite number"},
       })
    EXPECT_EQ(error_of(text, options), "plot.csv:" + error) << text;
}

TEST(PlotImport, WhatFitsBothLayoutsIsRefusedUntilOneIsStated) {
  PlotImport options = bare("T", "A", 3);
  const std::string text = "angle,dry,wet,old\n0,2,0,3\n1,1.5,2,2.5\n";
  EXPECT_EQ(error_of(text, options),
            "plot.csv:1:1: the columns may be one x, 'angle', with the data sets 'dry', 'wet', 'old', or pairs x, y of "
            "the data sets 'angle', 'wet'; say which: --layout=shared or --layout=pairs");
  EXPECT_NE(error_of("x,dry,,old\n0,2,0,3\n", options), "");  // a name is missing in either
  options.layout = PlotLayout::shared;
  EXPECT_EQ(import(text, options),
            "curve,P,T,A\ndry,1,0,2\ndry,1,1,1.5\nwet,1,0,0\nwet,1,1,2\nold,1,0,3\nold,1,1,2.5\n");
  options = bare("T", "A", 2);
  options.layout = PlotLayout::pairs;
  EXPECT_EQ(import(text, options), "curve,P,T,A\nangle,1,0,2\nangle,1,1,1.5\nwet,1,0,3\nwet,1,2,2.5\n");
}

TEST(PlotImport, DecimalCommasAreReadAsInATable) {
  const std::string expected = "curve,P,T,A\na,1,0.0,0.457\na,1,5.6,1456\n";
  EXPECT_EQ(import("a;\nX;Y\n0,0;0,457\n5,6;1.456,0\n", bare("T", "A", 1)), expected);
  EXPECT_EQ(import("a,\nX,Y\n\"0,0\",\"0,457\"\n\"5,6\",\"1456\"\n", bare("T", "A", 1)), expected);
  EXPECT_EQ(import("P = 1,5 mN;\nX;Y\n0,0;0,457\n5,6;1456\n", bare("T", "A", 1)),
            "curve,P,T,A\n\"P = 1,5 mN\",1,0.0,0.457\n\"P = 1,5 mN\",1,5.6,1456\n");
  PlotImport options = bare("T", "A", 1);
  const std::string doubtful = "a\t\n1,234\t5,678\n1\t7,125\n";
  EXPECT_NE(error_of(doubtful, options).find("say which: --decimal"), std::string::npos) << error_of(doubtful, options);
  options.decimal = ',';
  EXPECT_EQ(import(doubtful, options), "curve,P,T,A\na,1,1.234,5.678\na,1,1,7.125\n");
}

TEST(PlotImport, AFileThatIsNotThereIsNamed) {
  const TemporaryFolder folder;
  const std::string path = folder.path("none.csv");
  EXPECT_EQ(input_error([&] { import_plot(path, bare("T", "A", 1)); }),
            path + ": cannot be opened: No such file or directory");
}

}  // namespace plot_import_test
}  // namespace mixity
