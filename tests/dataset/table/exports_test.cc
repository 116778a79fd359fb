// Ordinary exports of one experiment, in the forms that laboratories have them, are the same points.
#include <gtest/gtest.h>
#include <iconv.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <sstream>

#include "base/number_text.h"
#include "dataset/dataset.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace exports_test {

using Row = std::array<double, 3>;  // P and T in mN, A in mm^2

std::vector<Row> experiment() {
  std::vector<Row> rows;
  for (const double P : {4.68, 2.31, 0.95})
    for (const double T : {0.0, 1.5, 3.25, 5.125, 7.0})
      rows.push_back({P, T, 0.3 + 0.02 * P - 0.0004 * T * T / (1 + P)});
  return rows;
}

std::string with_comma(std::string number) {
  std::replace(number.begin(), number.end(), '.', ',');
  return number;
}

/// Lines of the experiment, each field as `field` writes it from what `convert` makes of a row.
struct Form {
  char separator = ',';
  std::function<std::string(double)> field = [](double value) { return shortest(value); };
  std::function<std::vector<double>(const Row&)> convert = [](const Row& row) {
    return std::vector<double>(row.begin(), row.end());
  };
};
std::string lines(const Form& form) {
  std::string text;
  for (const Row& row : experiment()) {
    std::string line;
    for (const double value : form.convert(row))
      line += (line.empty() ? "" : std::string(1, form.separator)) + form.field(value);
    text += line + "\n";
  }
  return text;
}
const auto kComma = [](double value) { return with_comma(shortest(value)); };
std::string german() { return lines({';', kComma}); }

std::string encoded(const std::string& text, const char* encoding) {
  const iconv_t state = iconv_open(encoding, "UTF-8");
  std::string in = text, out(4 * text.size() + 16, '\0');
  char *from = in.data(), *to = out.data();
  std::size_t left = in.size(), room = out.size();
  EXPECT_NE(iconv(state, &from, &left, &to, &room), static_cast<std::size_t>(-1));
  iconv_close(state);
  out.resize(out.size() - room);
  return out;
}

const Overrides kConstants{{"radius", "9.42 mm"}, {"modulus", "2.133 MPa"}, {"toughness", "27 mJ/m^2"}};

Overrides with(Overrides more) {
  more.insert(more.end(), kConstants.begin(), kConstants.end());
  return more;
}

/// 1e-12 is what conversions of units and the square of a radius may round away.
void expect_the_experiment(const std::string& text, const Overrides& more = {}, const std::string& name = "a.csv") {
  const TemporaryFolder folder;
  Dataset data;
  try {
    data = load_dataset(folder.write(name, text), with(more));
  } catch (const InputError& error) {
    FAIL() << error.what() << "\n" << text;
  }
  const auto rows = experiment();
  ASSERT_EQ(data.points.size(), rows.size()) << text;
  ASSERT_TRUE(data.contact) << text;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto near = [&](double found, double wanted) {
      EXPECT_NEAR(found, wanted, 1e-12 * std::abs(wanted)) << text;
    };
    near(data.points[i].P * data.contact->force_unit(), 1e-3 * rows[i][0]);
    near(data.points[i].T * data.contact->force_unit(), 1e-3 * rows[i][1]);
    near(data.points[i].A * data.contact->area_unit(), 1e-6 * rows[i][2]);
  }
}

TEST(Exports, OfExcelInEurope) {
  const std::string text = "Normalkraft (mN);Reibkraft (mN);Kontaktfläche (mm²)\n" + german();
  expect_the_experiment(text);
  expect_the_experiment("\xEF\xBB\xBF" + text);
  expect_the_experiment(encoded(text, "ISO-8859-1"));
  expect_the_experiment(encoded(text, "UTF-16"));  // with its mark
  expect_the_experiment(encoded(text, "UTF-16LE"));
  expect_the_experiment(encoded(text, "UTF-16BE"));
  expect_the_experiment("sep=;\n" + text);
  std::string crlf;
  for (const char c : text) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  expect_the_experiment(encoded(crlf, "UTF-16"));
  expect_the_experiment(encoded(crlf, "WINDOWS-1252"));
}

TEST(Exports, WithHeadingsInOtherLanguages) {
  for (const char* headings : {
           "Force normale (mN);Force tangentielle (mN);Aire de contact (mm²)",
           "Forza normale [mN];Forza di attrito [mN];Area di contatto [mm²]",
           "Carga normal (mN);Fuerza de fricción (mN);Área de contacto (mm²)",
           "NORMALKRAFT [mN];SCHERKRAFT [mN];KONTAKTFLÄCHE [mm^2]",
           "normal_force_mN;shear_force_mN;contact_area_mm2",
           "F_N (mN);F_T (mN);A (mm^2)",
           "N (mN);Q (mN);Ac (mm^2)",
           "F_N / mN;F_T / mN;A / mm²",
           "Normalkraft in mN;Reibungskraft in mN;Kontaktfläche in mm²",
           "Normal force, mN;Tangential force, mN;Contact area, mm²",
           "Normal force P (mN);Tangential load T (mN);Contact area A (mm²)",
           "Normal force (F_N) [mN];Friction force (F_T) [mN];Area (A) [mm^2]",
       })
    expect_the_experiment(std::string(headings) + "\n" + german());
}

TEST(Exports, WithARowOfUnits) {
  const std::string rows = lines({'\t'});
  expect_the_experiment("Normal load\tTangential load\tContact area\nmN\tmN\tmm^2\n\tsample 3\t\n" + rows);  // Origin
  expect_the_experiment("P\tT\tA\n[mN]\t[mN]\t[mm²]\n" + rows);
  const auto timed = [](const Row& row) { return std::vector<double>{0.1, row[0], row[1], row[2]}; };
  expect_the_experiment("Prüfer;Müller\nDatum;12.05.2024\n\nZeit;Normalkraft;Scherkraft;Kontaktfläche\ns;mN;mN;mm²\n" +
                        lines({';', kComma, timed}));  // Zwick
  const auto quoted = [](double value) { return '"' + shortest(value) + '"'; };
  expect_the_experiment(
      "\"Test\",\"friction.im\"\n\"Operator\",\"AB\"\n\n\"Time\",\"Load\",\"Friction "
      "force\",\"Contact area\"\n\"(s)\",\"(mN)\",\"(mN)\",\"(mm^2)\"\n" +
      lines({',', quoted, timed}));  // Instron
  expect_the_experiment(
      "LabVIEW "
      "Measurement\t\nSeparator\tTab\nDecimal_Separator\t,\n***End_of_Header***\t\nChannels\t3\t\t\nX_Value\tNormal "
      "force (mN)\tShear force (mN)\tContact area (mm^2)\tComment\n" +
      lines({'\t', kComma, timed}));
}

TEST(Exports, WithUnitsWhereverTheyStand) {
  const std::string rows = lines({'\t'});
  const auto timed = [](const Row& row) { return std::vector<double>{21.5, row[0], row[1], row[2]}; };
  // a column that is not read may have any unit
  expect_the_experiment("Temperatur\tP\tT\tA\n°C\tmN\tmN\tmm^2\n" + lines({'\t', Form{}.field, timed}));
  expect_the_experiment("mN\tmN\tmm^2\nP\tT\tA\n" + rows);
  expect_the_experiment("# P\tT\tA\n# mN\tmN\tmm^2\n" + rows);
  expect_the_experiment("# P T A\n# mN mN mm^2\n" + lines({' '}));
  expect_the_experiment("# P [mN] T [mN] A [mm^2]\n" + rows);  // numpy.savetxt with tabs
  expect_the_experiment("P [mN], T [mN], A [mm^2]\n" + rows);
  const auto in_N = [](const Row& row) { return std::vector<double>{1e-3 * row[0], 1e-3 * row[1], 1e-6 * row[2]}; };
  expect_the_experiment("normal_force_N,shear_force_N,contact_area_m2\n" + lines({',', Form{}.field, in_N}));
  expect_the_experiment("P_N,T_N,A_m^2\n" + lines({',', Form{}.field, in_N}));
  expect_the_experiment("P_mN_,T_mN_,A_mm2_\n" + lines({','}));                               // MATLAB's writetable
  expect_the_experiment("% P [mN] T [mN] A [mm^2]\n" + lines({' '}));                         // and its own comments
  expect_the_experiment("Normal load\tShear load\tContact area\nmN\tmN\tmm\\+(2)\n" + rows);  // Origin
}

TEST(Exports, WithMoreWordsThanNumbers) {
  std::string text = "Datum;Uhrzeit;Bediener;Probe;Kamera;P [mN];T [mN];A [mm²];Notiz;Ort\n";
  std::istringstream rows(german());
  for (std::string row; std::getline(rows, row);) text += "01.03.2024;12:00:01;AB;PDMS;Basler;" + row + ";x;y\n";
  expect_the_experiment(text);
  expect_the_experiment(
      "LabVIEW Measurement\t\n***End_of_Header***\t\nChannels\t3\t\t\nSamples\t15\t15\t15\n"
      "X_Value\tP (mN)\tT (mN)\tA (mm^2)\n" +
      lines({'\t', Form{}.field, [](const Row& row) {
               return std::vector<double>{0.1, row[0], row[1], row[2]};
             }}));
  const auto fortran = [](double value) {
    std::ostringstream out;
    out.precision(17);
    out << std::scientific << value;
    std::string number = out.str();
    std::replace(number.begin(), number.end(), 'e', 'D');
    return number;
  };
  expect_the_experiment("P [mN]  T [mN]  A [mm^2]\n" + lines({' ', fortran}));
  expect_the_experiment("P [mN]|T [mN]|A [mm^2]\n" + lines({'|'}));
}

TEST(Exports, WithASummaryBelowHaveItLeftOut) {
  const TemporaryFolder folder;
  std::string text = " ,P (mN),T (mN),Area (mm^2)\n";
  std::size_t number = 0;
  std::istringstream rows(lines({','}));
  for (std::string row; std::getline(rows, row);) text += std::to_string(++number) + "," + row + "\n";
  const Dataset data =
      load_dataset(folder.write("Results.csv", text + "Mean,2.6,3.4,0.34\nSD,1.5,2.5,0.03\n"), kConstants);
  EXPECT_EQ(data.points.size(), number);
  ASSERT_EQ(data.excluded.size(), 2u);
  std::string labelled = "Label,P (mN),T (mN),Area (mm^2)\n";
  std::istringstream again(lines({','}));
  for (std::string row; std::getline(again, row);) labelled += "img," + row + "\n";
  EXPECT_EQ(
      load_dataset(folder.write("b.csv", labelled + "Mean,2.6,3.4,0.34\nMax,4,7,0.4\n"), kConstants).points.size(),
      number);
  EXPECT_EQ(data.excluded[0].reason, "summary row (text where the rows above have numbers)");
}

TEST(Exports, WithTheLabelOfASummaryInAColumnOfNumbersHaveItLeftOut) {
  const TemporaryFolder folder;
  const Dataset data = load_dataset(
      folder.write("a.csv", "P (mN),T (mN),Area (mm^2)\n" + lines({','}) + "Mean,50,0.4\nSD,1,0.1\n"), kConstants);
  ASSERT_EQ(data.excluded.size(), 2u);
  EXPECT_EQ(data.excluded[0].reason, "summary row (text where the rows above have numbers)");
  EXPECT_NE(input_error([&] {
              load_dataset(folder.write("b.csv", "P (mN),T (mN),Area (mm^2)\n" + lines({','}) + "Maen,50,0.4\n"),
                           kConstants);
            }).find("'Maen' is not a number"),
            std::string::npos);
}

TEST(Exports, WithSignsForNoValueHaveTheseRowsExcluded) {
  const TemporaryFolder folder;
  for (const char* sign : {"NA", "#N/A", "-", "1.#QNAN", ""}) {
    const Dataset data = load_dataset(
        folder.write("a.csv", "P [mN],T [mN],A [mm^2]\n4,0,0.3\n4,1," + std::string(sign) + "\n4,2,0.28\n"),
        kConstants);
    EXPECT_EQ(data.points.size(), 2u) << sign;
    EXPECT_EQ(data.excluded.at(0).reason, "A is empty") << sign;
  }
  const Dataset data = load_dataset(folder.write("b.csv",
                                                 "P [mN],T [mN],A [mm^2]\n\xE2\x88\x92"
                                                 "0.2,0,0.3\n\xE2\x88\x92"
                                                 "0.2,1,0.29\n"),
                                    kConstants);
  EXPECT_DOUBLE_EQ(data.points.at(0).P * data.contact.value().force_unit(), -0.2e-3);
}

TEST(Exports, OfColumnsPartedByBlanks) {
  expect_the_experiment("P[mN]  T[mN]  A[mm^2]\n" + lines({' '}));
  expect_the_experiment("P [mN] T [mN] A [mm^2]\n" + lines({' '}));
  expect_the_experiment("Normal force (mN)   Shear force (mN)\tContact area (mm^2)\n" + lines({' '}));
  const auto aligned = [](double value) { return "   " + shortest(value) + " "; };
  expect_the_experiment("  P [mN]   T [mN]   A [mm^2]\n" + lines({' ', aligned}));
  expect_the_experiment("# P [mN] T [mN] A [mm^2]\n" + lines({' '}));  // numpy.savetxt
  expect_the_experiment("# made by a script\n# P [mN],T [mN],A [mm^2]\n" + lines({','}));
}

TEST(Exports, WithGroupsOfThreeDigits) {
  const auto micro = [](const Row& row) { return std::vector<double>{1e3 * row[0], 1e3 * row[1], 1e6 * row[2]}; };
  const auto grouped = [](const std::string& sign, const std::string& decimal) {
    return [=](double value) {
      std::string whole = std::to_string(static_cast<long>(value)), decimals = shortest(value - std::trunc(value));
      if (whole.size() > 3) whole.insert(whole.size() - 3, sign);
      std::ostringstream exact;
      exact.precision(17);
      exact << value;
      const std::string text = exact.str();
      const std::size_t point = text.find('.');
      return '"' + whole + decimal + (point == std::string::npos ? "0" : text.substr(point + 1)) + '"';
    };
  };
  const std::string header = "P [uN];T [uN];A [um^2]\n";
  expect_the_experiment("P [uN],T [uN],A [um^2]\n" + lines({',', grouped(",", "."), micro}));
  expect_the_experiment(header + lines({';', grouped(".", ","), micro}));
  expect_the_experiment(header + lines({';', grouped("\u202f", ","), micro}));
  expect_the_experiment(header + lines({';', grouped("'", "."), micro}));
}

TEST(Exports, OfImagePrograms) {
  const auto pixels = [](const Row& row) { return std::vector<double>{row[0], row[1], row[2] / (1.7e-3 * 1.7e-3)}; };
  expect_the_experiment("Normal force (mN),Shear force (mN),Contact area (px)\n" + lines({',', Form{}.field, pixels}),
                        {{"pixel", "1.7 um"}});
  const auto axes = [](double stretch, double factor) {
    return [=](const Row& row) {
      const double a = factor * std::sqrt(row[2] / std::numbers::pi);
      return std::vector<double>{row[0], row[1], a * stretch, a / stretch};
    };
  };
  expect_the_experiment("P [mN],T [mN],a_par [mm],a_perp [mm]\n" + lines({',', Form{}.field, axes(0.97, 1)}));
  expect_the_experiment("P [mN],T [mN],Major (um),Minor (um)\n" + lines({',', Form{}.field, axes(1.02, 2000)}));
}

TEST(Exports, WithoutTheNamesAreReadByAMapping) {
  const auto mixed = [](const Row& row) { return std::vector<double>{row[2], row[0], 1e-3 * row[1]}; };
  expect_the_experiment("Kanal 1 (mm²);Kanal 3 (mN);Kanal 4 (N)\n" + lines({';', kComma, mixed}),
                        {{"columns", "P=Kanal 3 (mN),T=Kanal 4 (N),A=Kanal 1"}});
  expect_the_experiment(lines({','}), {{"columns", "P=1 (mN),T=2 (mN),A=3 (mm^2)"}});
  const TemporaryFolder folder;
  const std::string names = folder.write(
      "lab.toml", "[P]\nnames = [\"Kanal 3\"]\n[T]\nnames = [\"Kanal 4\"]\n[A]\nsymbols = [\"Kanal 1\"]\n");
  expect_the_experiment("Kanal 1 (mm²);Kanal 3 (mN);Kanal 4 (N)\n" + lines({';', kComma, mixed}),
                        {{"headings", names}});
}

TEST(Exports, WithoutALoadTakeItFromTheirNameOrAFlag) {
  const TemporaryFolder folder;
  const std::string text = "T [mN],A [mm^2]\n0,0.3\n1,0.29\n";
  const auto load_of = [&](const std::string& name, const Overrides& more) {
    const Dataset data = load_dataset(folder.write(name, text), with(more));
    return data.points.at(1).P * data.contact.value().force_unit();
  };
  EXPECT_DOUBLE_EQ(load_of("a.csv", {{"load", "4.68 mN"}}), 4.68e-3);
  EXPECT_DOUBLE_EQ(load_of("a.csv", {{"load", "-0.2 mN"}}), -0.2e-3);
  EXPECT_DOUBLE_EQ(load_of("run_4.68mN.csv", {{"load_from", "run_{P}mN"}}), 4.68e-3);
  EXPECT_DOUBLE_EQ(load_of("b_-0,2mN_3.csv", {{"load_from", "b_{P}mN"}}), -0.2e-3);
  EXPECT_DOUBLE_EQ(load_of("12uN-7.csv", {{"load_from", "{P}uN"}}), 12e-6);
  EXPECT_DOUBLE_EQ(load_of("load 1.2 mN.csv", {{"load_from", "load {P} mN"}}), 1.2e-3);
  EXPECT_DOUBLE_EQ(load_of("load_1.2_mN.csv", {{"load_from", "load_{P}_mN"}}), 1.2e-3);
  EXPECT_DOUBLE_EQ(load_of("run_2mN.csv", {{"load_from", "run_{P}mN"}, {"load", "3 mN"}}), 3e-3);  // said last
  const auto refused = [&](const std::string& name, const Overrides& more) {
    return input_error([&] { load_of(name, more); });
  };
  EXPECT_NE(refused("run_7,250mN.csv", {{"load_from", "run_{P}mN"}}).find("may be a thousand or a decimal"),
            std::string::npos);
  EXPECT_NE(refused("run-7mN.csv", {{"load_from", "run{P}mN"}}).find("may be a sign or part two words"),
            std::string::npos);
  EXPECT_NE(refused("a.csv", {{"load", "3 mN +/- 1 mN"}}).find("its error belongs in load_offset"), std::string::npos);
  EXPECT_NE(refused("a.csv", {{"pixel", "1.7 um +/- 5%"}}).find("its error belongs in area_scale"), std::string::npos);
  EXPECT_EQ(folder.left_out_of(input_error([&] {
    load_of("run7.csv", {{"load_from", "run_{P}mN"}});
  })),
            "run7.csv: the file's name states no load (load_from is \"run_{P}mN\")");
}

TEST(Exports, ThatCanBeReadInTwoWaysAreRefusedWithBoth) {
  const auto error = [](const std::string& text) {
    return file_error("a.csv", text, [](const std::string& path) { load_dataset(path, kConstants); });
  };
  EXPECT_EQ(
      error("P [mN],T [mN],A [mm^2]\n\"1,234\",\"2,345\",\"3,456\"\n\"1,235\",\"2,346\",\"3,457\"\n"),
      "a.csv:2:1: '1,234' may be 1.234 (decimal comma) or 1234 (comma between thousands); say which: --decimal=\",\" "
      "or --decimal=\".\"");
  EXPECT_EQ(error("P [mN],T [mN] (N),A [mm^2]\n1,2,3\n2,3,4\n"),
            "a.csv:1:8: column 'T [mN] (N)' states two units, mN and N");
  EXPECT_EQ(error("Normal force (mN),Load (mN),Friction force (mN),Contact area (mm^2)\n1,2,3,4\n2,2,3,4\n"),
            "a.csv:1:19: 'Normal force (mN)' and 'Load (mN)' may both be P; say which: "
            "--columns=\"P=Normal force (mN)\" or --columns=\"P=Load (mN)\"");
  EXPECT_EQ(error("P [mN],T [mN],A [px]\n1,2,3\n2,3,4\n"),
            "a.csv:1:15: column 'A' is in pixels; state the side of one: --pixel=\"1.7 um\", or the key pixel");
  // integers in groups of three, or three decimals: none of them can be told
  EXPECT_EQ(error("P [uN];T [uN];A [um^2]\n7.732;0;457.831\n7.732;854;456.212\n"),
            "a.csv:2:1: '7.732' may be 7732 (decimal comma) or 7.732 (decimal point); say which: --decimal=\",\" or "
            "--decimal=\".\"");
  EXPECT_NE(error("P [uN];T [uN];A [um^2]\n7,732;0;457,831\n7,732;854;456,212\n").find("say which: --decimal"),
            std::string::npos);
  EXPECT_EQ(error("P [mN],T [mN],A [mm^2]\nN,mN,mm^2\n1,2,3\n2,2,3\n"),
            "a.csv:2:1: the row of units has 'N' for column 'P [mN]', which itself says mN");
  EXPECT_EQ(
      error("P,T,A\nkg,mN,mm^2\n1,2,3\n2,2,3\n"),
      "a.csv:2:1: the row of units has 'kg' for column 'P', which is no unit that is known; if it is another way to "
      "write one: --columns=\"P=P (UNIT)\"");
  EXPECT_EQ(error("PK\x03\x04..."),
            "a.csv: is a workbook or an archive; export its sheet as CSV (Excel: Save As, CSV UTF-8)");
}

TEST(Exports, WithAMappingThatCannotBeAreRefused) {
  const auto error = [](const std::string& text, const std::string& columns) {
    return file_error("a.csv", text, [&](const std::string& path) {
      load_dataset(path, with({{"columns", columns}}));
    });
  };
  const std::string twice = "Force (mN),Force (mN),A (mm^2)\n1,2,3\n2,2,3\n";
  EXPECT_EQ(error(twice, "P=1,T=1"), "a.csv:1:1: column 1 is mapped to T and to P");
  EXPECT_EQ(error(twice, "P=Force (mN),T=2"),
            "a.csv:1:12: columns 1 and 2 are both 'Force (mN)', which is to be P; say which by its number: "
            "--columns=\"P=2\"");
  // what is mapped stands over what is understood
  const TemporaryFolder folder;
  const Dataset data = load_dataset(
      folder.write("b.csv", "P [mN],T [mN],area [mm^2],r [mm]\n4,0,25,0.3\n4,1,25,0.29\n"), with({{"columns", "a=r"}}));
  EXPECT_NEAR(data.points.at(0).A * data.contact.value().area_unit(), std::numbers::pi * 0.09e-6, 1e-18);
}

TEST(Exports, WithLossesOfAreaDoNotTakeThemForErrors) {
  const TemporaryFolder folder;
  const Dataset data = load_dataset(folder.write("a.csv",
                                                 "P [mN],T [mN],A [mm^2],\xCE\x94"
                                                 "A [mm^2],dT [mN]\n4,0,0.3,0,1\n4,1,0.29,0.01,1\n"),
                                    kConstants);
  EXPECT_TRUE(data.errors.empty());
  EXPECT_EQ(data.points.size(), 2u);
}

TEST(Exports, AreSaidHowTheyWereRead) {
  const TemporaryFolder folder;
  const Dataset data = load_dataset(
      folder.write("a.csv",
                   encoded("Versuch 7\nNormalkraft;Reibkraft;Kontaktfläche\nmN;mN;mm²\n" + german(), "UTF-16")),
      kConstants);
  EXPECT_EQ(data.reading, "UTF-16LE, semicolons, decimal commas, units in line 3, headings in line 2");
  EXPECT_EQ(data.taken,
            (std::vector<std::string>{"P from 'Normalkraft'", "T from 'Reibkraft'", "A from 'Kontaktfläche'"}));
}

TEST(Exports, ThatAreLogsSaySo) {
  const TemporaryFolder folder;
  const std::string path =
      folder.write("a.csv", "Zeit (s);P [mN];T [mN];A [mm^2]\n0;1;0;\n1;1;0;0,2\n2;1;0;\n3;1;1;\n4;1;1;0,19\n");
  EXPECT_NE(texts_of(load_dataset(path, kConstants).notes).at(0).find("mixity runs makes loading runs of it"),
            std::string::npos);
}

TEST(Exports, WithStretchedContactsSaySo) {
  const TemporaryFolder folder;
  const Dataset data = load_dataset(
      folder.write("a.csv", "P [mN],T [mN],a_par [mm],a_perp [mm]\n4,0,0.3,0.3\n4,2,0.27,0.324\n"), kConstants);
  EXPECT_EQ(
      texts_of(data.notes).at(0),
      "areas are those of ellipses, axes as 1.2 to 1 (eccentricity 0.553) at most, in line 3; the models are of a "
      "circle, and around such an edge the energy release rate varies by about 20%");
}

}  // namespace exports_test
}  // namespace mixity
