// Ordinary exports of one experiment, in the forms that laboratories have them, are the same points.
#include "dataset/table/exports.h"

#include <numbers>
#include <regex>

namespace mixity {
namespace exports_test {

using namespace exports;

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

/// Two bytes for a letter: instruments with Windows of Japan and China.
TEST(Exports, OfEastAsia) {
  const std::string japanese =
                        "試験日,2021/06/02\n\"垂直力\",\"摩擦力\",\"接触面積\"\n\"mN\",\"mN\",\"mm2\"\n" + lines({}),
                    chinese = "样品,硅橡胶\n法向力 (mN),摩擦力 (mN),接触面积 (mm2)\n" + lines({});
  expect_the_experiment(japanese);
  expect_the_experiment(encoded(japanese, "CP932"));
  expect_the_experiment(encoded(chinese, "GB18030"));
  // letters of Western Europe side by side, and signs that are parts of letters elsewhere
  for (const char* title : {"Versuch „Größe“ – 5 °C ± 2", "créée le 3 février", "ÄÖÜ", "5 µm², déjà vu"})
    expect_the_experiment(encoded(
        std::string(title) + "\nNormalkraft (mN);Reibkraft (mN);Kontaktfläche (mm²)\n" + german(), "WINDOWS-1252"));
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
           "Normalkraft F_N [mN];Reibkraft F_R [mN];Kontaktfläche A_K [mm²]",
           "Normal force FV [mN];Lateral force (F_lt) [mN];Contact area Ak [mm²]",
       })
    expect_the_experiment(std::string(headings) + "\n" + german());
}

TEST(Exports, WithAColumnOfAMaximumOrACommandAreNotReadAsOfThePoint) {
  const TemporaryFolder folder;
  for (const char* other : {"Reibkraft F_max", "Reibkraft F_sd", "Reibkraft F2", "Reibkraft A_R"})
    EXPECT_THROW(load_dataset(folder.write(
                     "a.csv", "Normalkraft [mN];" + std::string(other) + " [mN];Kontaktfläche [mm²]\n1;2;3\n")),
                 InputError)
        << other;
}

/// Whole files of the old Macintosh, files to which another program added lines, a header pasted from elsewhere.
TEST(Exports, WithCarriageReturnsHaveEachEndALine) {
  const std::string header = "P [mN],T [mN],A [mm^2]", blanks = "P_mN T_mN A_mm2";
  const auto with = [](std::string text, char from, const char* to, std::size_t first = 0, std::size_t last = 1000) {
    std::string out;
    std::size_t n = 0;
    for (const char c : text)
      if (c == from && ++n > first && n <= last)
        out += to;
      else
        out += c;
    return out;
  };
  const std::string file = "Lab book\n# a note\n" + header + "\n" + lines({}), parted = blanks + "\n" + lines({' '});
  expect_the_experiment(with(file, '\n', "\r"));
  expect_the_experiment(with(file, '\n', "\r", 0, 3));
  expect_the_experiment(with(file, '\n', "\r", 3));
  expect_the_experiment(with(file, '\n', "\r\n", 6));
  expect_the_experiment(with(file, '\n', "\r\r", 2, 6));
  expect_the_experiment(with(parted, '\n', "\r", 4));
  expect_the_experiment(encoded(with(file, '\n', "\r", 5, 9), "UTF-16"));
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

TEST(Exports, WithQuotesInLinesOfWords) {
  const std::string rows = "P (mN)\tT (mN)\tA (mm^2)\n" + lines({'\t'});
  for (const char* line : {"Operator: James \"Jim\" Smith\n", "\"Jim\" Smith, 4\" wafer\n", "Wafer\t4\" glass\n"})
    expect_the_experiment(line + rows);
  // commands of Igor below the table
  expect_the_experiment("IGOR\nWAVES/D\tP_mN\tT_mN\tA_mm2\nBEGIN\n\t" +
                        std::regex_replace(lines({'\t'}), std::regex("\n(?=.)"), "\n\t") +
                        "END\nX SetScale/P x 0,1,\"\", P_mN; SetScale y 0,0,\"mN\", P_mN\n");
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
    EXPECT_EQ(data.excluded.at(0).reason, sign[0] == 0 ? "A is empty" : "A is missing") << sign;
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
  const TemporaryFolder folder;
  EXPECT_NE(input_error([&] {
              load_dataset(folder.write("Results.csv", "P_mN,T_mN,Area\n" + lines({',', Form{}.field, pixels})),
                           {{"pixel", "1.7 um"}});
            }).find("say its unit: --columns=\"A=Area (px)\""),
            std::string::npos);
  const auto axes = [](double stretch, double factor) {
    return [=](const Row& row) {
      const double a = factor * std::sqrt(row[2] / std::numbers::pi);
      return std::vector<double>{row[0], row[1], a * stretch, a / stretch};
    };
  };
  expect_the_experiment("P [mN],T [mN],a_par [mm],a_perp [mm]\n" + lines({',', Form{}.field, axes(0.97, 1)}));
  expect_the_experiment("P [mN],T [mN],Major (um),Minor (um)\n" + lines({',', Form{}.field, axes(1.02, 2000)}));
}

}  // namespace exports_test
}  // namespace mixity
