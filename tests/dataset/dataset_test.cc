// The points that a file becomes.
#include "dataset/dataset.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <cstddef>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "dataset/load_text.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace dataset_test {

const std::string kMergel = "radius = \"9.42 mm\"\nmodulus = \"2.133 MPa\"\ntoughness = \"27 mJ/m^2\"\n";

/// 1e-12 is what the same data in other units must agree to: some ten roundings of 1.1e-16, magnified by the
/// difference y = 4/3 a^3 - P, which loses less than two digits in these points.
void expect_same_points(const Dataset& one, const Dataset& other) {
  const auto near = [](double x, double y) { EXPECT_NEAR(x, y, 1e-12 * std::abs(x)); };
  ASSERT_EQ(one.points.size(), other.points.size());
  for (std::size_t i = 0; i < one.points.size(); ++i) {
    const Point &p = one.points[i], &q = other.points[i];
    near(p.P, q.P);
    near(p.T, q.T);
    near(p.A, q.A);
    near(one.toughness(i)->psi(), other.toughness(i)->psi());
    near(one.toughness(i)->ratio, other.toughness(i)->ratio);
    near(one.errors_of(i).T, other.errors_of(i).T);
    near(one.errors_of(i).A, other.errors_of(i).A);
    EXPECT_EQ(p.curve, q.curve);
  }
}

TEST(Dataset, APointIsWhatTheEquationsSay) {
  const Dataset data = load_text("P [mN],T [mN],A [mm^2]\n1,0.5,0.24\n", kMergel);
  ASSERT_EQ(data.points.size(), 1);
  const Point& point = data.points[0];
  // From 40-digit arithmetic. 1e-13: some ten roundings of 1.1e-16, doubled by y = 4/3 a^3 - P and its square.
  const auto near = [](double value, double expected) { EXPECT_NEAR(value, expected, 1e-13 * expected); };
  near(point.P, 3.9317449083903436345);
  near(point.T, 1.9658724541951718173);
  near(point.A, 22.210658372687063104);
  near(data.toughness(0)->psi(), 0.092758699414844447049);
  near(data.toughness(0)->ratio, 0.95343285609058218575);
  EXPECT_EQ(point.line, 2);
}

TEST(Dataset, UnitsMakeNoDifference) {
  const Dataset data = load_text(
      "P [mN],T [mN],A [mm^2],sigma_T [mN],sigma_A [mm^2]\n1,0,0.25,0.01,0.002\n1,0.5,0.24,0.02,0.003\n", kMergel);
  ASSERT_EQ(data.points.size(), 2);
  for (const char* csv : {
           "P [N],T [N],A [m^2],sigma_T [N],sigma_A [m^2]\n1e-3,0,0.25e-6,1e-5,2e-9\n1e-3,5e-4,2.4e-7,2e-5,3e-9\n",
           "A (um²);sigma_A (um²);P (kN);T (nN);sigma_T (µN)\n250000;2000;1e-6;0;10\n240000;3000;1e-6;500000;20\n",
           // as spreadsheets save it: the delimiter told, marks that are not seen, a remark in the heading, empty
           // columns
           "sep=;\r\n\xEF\xBB\xBF"
           "P (normal) [mN];T\xE2\x80\x8B [mN];A [mm^2];sigma_T [mN];sigma_A [mm^2];;\r\n"
           "1;0;0.25;0.01;0.002;;\r\n1;0.5;0.24;0.02;0.003;;\r\n",
           "T [mN],P [mN],sigma_A [%],A [cm^2],sigma_T [mN]\n0,1,0.8,0.0025,0.01\n0.5,1,1.25,0.0024,0.02\n",
       })
    expect_same_points(data, load_text(csv, kMergel));
}

TEST(Dataset, RowsBehindAHashAreCountedInANote) {
  const std::string rows = "P,T,A\n1,0,19.6\n#N/A,1,19.5\n# measured on Monday, in the morning, by hand\n#1,2,19.4\n";
  const Dataset data = load_text(rows);
  EXPECT_EQ(data.rows, 1u);
  EXPECT_EQ(texts_of(data.notes),
            std::vector<std::string>{"passed over as comments: 2 rows that begin with '#', the first in line 3"});
  EXPECT_TRUE(load_text("# 1,2,3\nP,T,A\n1,0,19.6\n# a remark\n").notes.empty());
}

TEST(Dataset, ConstantsMayBeStatedInAnyUnit) {
  const std::string csv = "P [mN],T [mN],A [mm^2]\n1,0.5,0.24\n";
  expect_same_points(load_text(csv, kMergel),
                     load_text(csv,
                               "radius = \"0.942 cm\"\nyoungs_modulus = \"1599.75 kPa\"\npoisson_ratio = 0.5\n"
                               "toughness = \"2.7e-5 N/mm\"\n"));
}

TEST(Dataset, FlagsStandInForTheToml) {
  const std::string csv = "P [mN],T [mN],A [mm^2]\n1,0.5,0.24\n";
  const Overrides constants{{"radius", "9.42 mm"}, {"modulus", "2.133 MPa"}, {"toughness", "27 mJ/m^2"}};
  expect_same_points(load_text(csv, kMergel), load_text(csv, "", constants));
  expect_same_points(load_text(csv, kMergel), load_text(csv, "radius = \"1 mm\"\n", constants));
  // One half of the modulus by flag, the other in the file: 1.59975/(1 - 0.5^2) = 2.133
  expect_same_points(
      load_text(csv, kMergel),
      load_text(csv, "radius = \"9.42 mm\"\nyoungs_modulus = \"1.59975 MPa\"\ntoughness = \"27 mJ/m^2\"\n",
                {{"poisson_ratio", "0.5"}}));
}

TEST(Dataset, ARadiusServesAsWellAsAnArea) {
  // a = sqrt(0.24/pi) = 0.27639531957706836 mm
  expect_same_points(load_text("P [mN],T [mN],A [mm^2]\n1,0.5,0.24\n", kMergel),
                     load_text("a [mm],P [mN],T [mN]\n0.27639531957706836,1,0.5\n", kMergel));
}

TEST(Dataset, ADiameterServesAsWellAsARadius) {
  expect_same_points(load_text("P [mN],T [mN],a [mm]\n1,0.5,0.28\n", kMergel),
                     load_text("P [mN],T [mN],diameter [mm]\n1,0.5,0.56\n", kMergel));
  expect_same_points(load_text("P [mN],T [mN],A [mm^2]\n1,0.5,0.24\n", kMergel),
                     load_text("P [mN],T [mN],A [mm^2],diameter\n1,0.5,0.24,7\n", kMergel));
}

TEST(Dataset, DimensionlessPointsNeedNoConstants) {
  const Dataset data = load_text("P,T,A\n1,0,19.614936466006520661\n");  // the JKR area at P = 1, from 40 digits
  EXPECT_FALSE(data.contact);
  EXPECT_EQ(data.points[0].A, 19.614936466006520661);
  EXPECT_EQ(data.toughness(0)->psi(), 0);
  EXPECT_NEAR(data.toughness(0)->ratio, 1, 1e-14);  // a JKR contact has G = G_Ic; a dozen roundings
}

TEST(Dataset, FileUnitsComeBackByTheDisplayScale) {
  const Dataset data = load_text("P [mN],T [N],A [mm^2]\n1,0.0005,0.24\n", kMergel);
  EXPECT_EQ(data.display.force, "N");
  EXPECT_EQ(data.display.area, "mm^2");
  EXPECT_NEAR(data.points[0].T * data.display.force_scale, 5e-4, 1e-18);  // some roundings of 1.1e-16
  EXPECT_NEAR(data.points[0].A * data.display.area_scale, 0.24, 1e-15);
}

TEST(Dataset, ConvertedPointsNeedNoRadius) {
  const Dataset data = load_text("psi [deg],Gc_over_GIc\n0,1\n30,1.25\n90,3\n");
  ASSERT_EQ(data.points.size(), 3);
  EXPECT_FALSE(data.has_loads);
  EXPECT_DOUBLE_EQ(data.toughness(1)->psi(),
                   0.52359877559829887308);  // pi/6; 4 ulp of a product, a sine and an arctangent
  EXPECT_EQ(data.toughness(1)->ratio, 1.25);
  EXPECT_EQ(data.toughness(2)->mixity.cos, 0);  // 90 degrees are pi/2, not the double next to it
  // sin^2(pi/6) = 1/4, so these are the same points; without unit an angle is in rad
  for (const char* csv :
       {"psi [rad],Gc_over_GIc\n0.52359877559829887308,1.25\n", "psi,Gc_over_GIc [%]\n0.52359877559829887,125\n",
        "mode_ratio,Gc\n0.25,1.25\n", "Gc,mode_ratio\n1.25,0.25\n"})
    EXPECT_DOUBLE_EQ(load_text(csv).toughness(0)->psi(), data.toughness(1)->psi()) << csv;
}

TEST(Dataset, AToughnessWithAUnitIsDividedByGIc) {
  const std::string csv = "mode_ratio,Gc [N/mm],sigma_Gc [J/m^2]\n0.5,1.131,5\n";
  const Dataset data = load_text(csv, "toughness = \"969 J/m^2\"\n");
  EXPECT_DOUBLE_EQ(data.toughness(0)->ratio, 1131.0 / 969);  // 4 ulp: one product and one quotient
  EXPECT_DOUBLE_EQ(data.errors_of(0).ratio, 5.0 / 969);
  EXPECT_EQ(load_error(csv),
            "a.csv: the constant toughness is missing: state it in a.toml or by a flag "
            "(--toughness=...)");
}

TEST(Dataset, EmptyFieldsBeyondTheHeaderAreHarmless) {
  EXPECT_EQ(load_text("P,T,A\n1,0,20,\n1,1,19,,,\n").points.size(), 2);
}

/// Of three runs: from first to last, the share of the run's largest shear squared, and which points are without shear.
TEST(Dataset, PlacesSayRunShareOfTheLargestShearAndNoShear) {
  const Dataset data = load_text("P,T,A\n1,0,19\n1,2,18\n1,-4,17\n2,0.04,20\n2,5,18\n3,0,21\n");
  const PointPlaces of(data);
  const std::vector<double> order{-0.5, -0.5, -0.5, 0, 0, 0.5}, share{0, 0.25, 1, 6.4e-5, 1, 0};
  const std::vector<bool> without{true, false, false, true, false, true};
  ASSERT_EQ(data.points.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_DOUBLE_EQ(of.at(i).order, order[i]) << i;
    EXPECT_NEAR(of.at(i).stretch, share[i], 1e-15) << i;
    EXPECT_EQ(of.at(i).unsheared, without[i]) << i;
  }
  EXPECT_DOUBLE_EQ(of.at(1, 4).stretch, 1);                                    // where the point lies without noise
  EXPECT_DOUBLE_EQ(PointPlaces(load_text("P,T,A\n1,1,19\n")).at(0).order, 0);  // one run alone
}

TEST(Dataset, CountsLinesUpToTheLastThatAPointHolds) {
  EXPECT_EQ(line_of_point("a.csv", 4294967295), 4294967295);
  EXPECT_EQ(input_error([] { line_of_point("a.csv", std::size_t{4294967295} + 1); }),
            "a.csv: has more than 4294967295 lines, with those of the files before it; split it");
}

TEST(Dataset, OnePointIsADataSet) { EXPECT_EQ(load_text("P,T,A\n1,1,19").points.size(), 1); }

TEST(Dataset, RunsAreThoseOfTheCurveColumnElseOnePerLoad) {
  const Dataset named = load_text("curve,P,T,A\nx,1,0,20\ny,1,0,20\nx,5,1,25\n");
  EXPECT_EQ(named.curves, (std::vector<std::string>{"x", "y"}));
  EXPECT_EQ(named.points[2].curve, 0);
  EXPECT_EQ(named.curve_loads, (std::vector<double>{3, 1}));
  const Dataset by_load = load_text("P,T,A\n5,0,25\n1,0,20\n5,1,24\n");
  EXPECT_EQ(by_load.curve_loads, (std::vector<double>{5, 1}));
  EXPECT_EQ(by_load.points[2].curve, 0);
}

/// As a spreadsheet with merged cells leaves them: they must not become one run of all loads.
TEST(Dataset, RowsWithAnEmptyCurveAreThoseOfTheirLoad) {
  const Dataset data = load_text("curve,P,T,A\nfirst,1,0,19\n,1,1,18.9\n,2,0,20\n,1,2,18.8\nfirst,1,3,18.7\n,2,1,19.9");
  EXPECT_EQ(data.curves, (std::vector<std::string>{"first", "P=1", "P=2"}));
  std::vector<std::size_t> runs;
  for (const Point& point : data.points) runs.push_back(point.curve);
  EXPECT_EQ(runs, (std::vector<std::size_t>{0, 1, 2, 1, 0, 2}));
}

TEST(Dataset, ARunThatIsNamedAsOneWithoutANameIsIsAnother) {
  const Dataset data = load_text("curve,P,T,A\nP=1,5,0,40\nP=1,5,4,39\n,1,0,19.6\n,1,4,19\nP=1,5,5,38\n");
  EXPECT_EQ(data.curves, (std::vector<std::string>{"P=1", "P=1 (not named)"}));
  EXPECT_EQ(data.curve_loads, (std::vector<double>{5, 1}));
}

TEST(Dataset, APipeIsReadOnce) {
  const TemporaryFolder folder;
  const std::string pipe = folder.path("pipe.csv");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(pipe) << "P,T,A,sigma_A\n1,0,19.6,0.1\n1,1,19.5,\n"; });
  const Dataset data = load_dataset(pipe);
  writer.join();
  // without a writer, to open it would not return
  EXPECT_EQ(folder.left_out_of(input_error([&] { refuse_value(data, data.points[1], "sigma_A", "is missing"); })),
            "pipe.csv:3:10: is missing");
}

TEST(Dataset, ALoadOfMinusZeroIsZero) {
  const Dataset data = load_text("P,T,A\n-0,0,14\n0,1,13.9\n-0.0,2,13.8\n");
  EXPECT_EQ(data.curves, std::vector<std::string>{"P=0"});
  EXPECT_FALSE(std::signbit(data.points[0].P));
}

/// "run_0.5" has no ending: the number after its point is part of its name.
TEST(Dataset, AnEndingBeginsWithALetter) {
  for (const auto& [path, name, toml] : {std::tuple("d/run.csv", "run", "d/run.toml"),
                                         {"d/run_0.5", "run_0.5", "d/run_0.5.toml"},
                                         {"d/run_0.5.csv", "run_0.5", "d/run_0.5.toml"},
                                         {"d.x/run", "run", "d.x/run.toml"},
                                         {"run.5mN", "run.5mN", "run.5mN.toml"},
                                         {"run.TXT", "run", "run.toml"}}) {
    EXPECT_EQ(data_name(path), name);
    EXPECT_EQ(metadata_path(path), toml);
  }
}

TEST(Dataset, NotesWhatWasStatedAndIsPassedOver) {
  const std::string constants = "radius = \"9.42 mm\"\nmodulus = \"2 MPa\"\ntoughness = \"27 mJ/m^2\"";
  for (const char* fine : {"P [mN],T [mN],A [mm^2]\n1,1,19", "psi,Gc_over_GIc\n0.1,1", "psi,Gc [J/m^2]\n0.1,1"})
    EXPECT_TRUE(load_text(fine, constants).notes.empty()) << fine;
  const Dataset known = load_text("P,T,A,Include,sigma A,a.u.,gc\n1,1,19,0,1,2,3");
  EXPECT_EQ(texts_of(known.notes), std::vector<std::string>{"standard errors: sigma_A from 'sigma A'"});
  EXPECT_EQ(known.excluded.at(0).reason, "include = 0");
}

TEST(Dataset, ALogIsToldByTimesAndFramesWithoutContact) {
  std::string frames = "time,P,T,A\n", points = frames;
  for (int i = 0; i < 40; ++i) {
    const std::string row = std::to_string(0.1 * i) + ",1," + std::to_string(0.05 * i) + ",";
    frames += row + (i < 5 ? "0\n" : "19\n");
    points += row + "19\n";
  }
  const Dataset log = load_text(frames);
  EXPECT_TRUE(log.like_a_log);
  ASSERT_FALSE(log.notes.empty());
  EXPECT_EQ(texts_of(log.notes)[0],
            "the file has a column of times, and 5 of 40 rows are no points: if it is a log, mixity runs makes loading "
            "runs of it");
  EXPECT_FALSE(load_text(points).like_a_log);
}

TEST(Dataset, TheNameOfARunIsReadInTheEncodingOfItsFile) {
  const Dataset data = load_text("curve,P,T,A\nProb\xe4,1,0,20\nProb\xf6,1,0,20\nµ,5,1,25\n\"a\nb\",5,1,25\n");
  EXPECT_EQ(data.curves, (std::vector<std::string>{"Probä", "Probö", "Âµ", "a?b"}));
}

TEST(Dataset, WhatIsNoTextInTheNameOfAFileIsAQuestionMark) {
  const TemporaryFolder folder;
  EXPECT_EQ(load_dataset(folder.write("Prob\xe4.csv", "P,T,A\n1,0,20\n")).name, "Prob?");
}

TEST(Dataset, APartHasWhatBelongsToItsPoints) {
  const Dataset data = load_text("curve,P,T,A,sigma_T,sigma_A\na,1,0,20,0.1,0.2\nb,5,1,25,0.3,0.4\nc,9,2,30,0.5,0.6\n");
  const Dataset part = part_of(data, {2, 1});
  ASSERT_EQ(part.points.size(), 2);
  for (const auto& [i, of_all] : {std::pair(0U, 2U), std::pair(1U, 1U)}) {
    EXPECT_EQ(part.points[i].line, data.points[of_all].line);
    EXPECT_EQ(part.curves[part.points[i].curve], data.curves[data.points[of_all].curve]);
    EXPECT_EQ(part.errors_of(i).A, data.errors_of(of_all).A);
  }
  EXPECT_EQ(part.title(), data.title());
  EXPECT_EQ(part_of(load_text("psi,Gc\n0.1,2\n0.2,3\n"), {1}).toughness(0)->ratio, 3);
}

TEST(Dataset, AMillionRowsAreRead) {
  std::string csv = "P,T,A\n";
  for (int i = 0; i < 1000000; ++i) csv += "1," + std::to_string(i) + "e-6,19.5\n";
  const Dataset data = load_text(csv);
  ASSERT_EQ(data.points.size(), 1000000);
  EXPECT_EQ(data.points.back().line, 1000001);
  EXPECT_EQ(data.points.back().T, 0.999999);
  EXPECT_EQ(data.curves.size(), 1);
}

}  // namespace dataset_test
}  // namespace mixity
