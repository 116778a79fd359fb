// Which heading is which quantity, and what is said where that is not clear.
#include "dataset/table/column_names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "dataset/load_text.h"
#include "dataset/logs/recording.h"

namespace mixity {
namespace column_names_test {

const Overrides kConstants{{"radius", "9.42 mm"}, {"modulus", "2.133 MPa"}, {"toughness", "27 mJ/m^2"}};

/// The columns that were taken, or the error, of rows "4.68,0,0.3" and so on under this header.
std::string read(const std::string& header, Overrides more = {},
                 const std::string& rows = "4.68,0,0.3\n4.67,1,0.29\n4.69,2,0.28\n") {
  more.insert(more.end(), kConstants.begin(), kConstants.end());
  std::string taken;
  const std::string error = input_error([&] {
    const Dataset data = load_text(header + "\n" + rows, "", more);
    EXPECT_EQ(data.points.size(), 3u);
    EXPECT_NEAR(data.points[1].P * data.contact.value().force_unit(), 4.67e-3, 1e-15) << header;
    EXPECT_NEAR(data.points[1].T * data.contact->force_unit(), 1e-3, 1e-15) << header;
    EXPECT_NEAR(data.points[1].A * data.contact->area_unit(), 0.29e-6, 1e-18) << header;
    for (const std::string& one : data.taken) taken += (taken.empty() ? "" : ", ") + one;
  });
  return error.empty() ? taken : error.substr(error.rfind(".csv:") + 5);
}

TEST(ColumnNames, AreFoldedInAsciiAsInUnicode) {
  // A text with a letter beyond ASCII is folded by the tables of Unicode, another by itself.
  std::string all;
  for (char c = 1; c < 127; ++c) all += c;
  for (const std::string& text : {all, std::string("Normal force F_N"), std::string("\0x", 2), std::string()})
    EXPECT_EQ(folded(text + "\xC3\xA9"), folded(text) + "e");
  EXPECT_EQ(sorted_words("Area of the contact contact"), "area contact");
}

TEST(ColumnNames, OfALogMayBeTheProgramsAndALaboratorysInOneFile) {
  const TemporaryFolder folder;
  for (const char* header : {"time [s],F_N [mN],F_T [mN],A [mm^2]", "time [s],P [mN],F_T [mN],A [mm^2]",
                             "time [s],P [mN],T [mN],Contact area (mm^2)", "t [s],F_N [mN],T [mN],A [mm^2]"}) {
    const Recording log =
        read_recordings(folder.write("m.csv", std::string(header) + "\n0,1,2,0.3\n1,1,3,0.3\n2,1,4,0.2\n"), Metadata{})
            .front();
    EXPECT_TRUE(log.holds_forces()) << header;
    EXPECT_TRUE(log.holds_areas()) << header;
    EXPECT_EQ(log.P.size(), 3u) << header;
  }
}

TEST(ColumnNames, OfPointsMayHaveATimeForEachChannelIfTheseAgree) {
  const std::string header = "X_Value,P [mN],X_Value,T [mN],X_Value,A [mm^2]";
  EXPECT_EQ(read(header, {}, "0,4.68,0,0,0,0.3\n1,4.67,1,1,1,0.29\n2,4.69,2,2,2,0.28\n"), "");
  EXPECT_EQ(read(header, {}, "0,4.68,0,0,0,0.3\n1,4.67,1,1,2,0.29\n2,4.69,2,2,4,0.28\n"),
            "3:12: the time of A is 2, but column 1 'X_Value' says 1: the channels have clocks of their own; resample "
            "them to one before the export, and export one column of times");
}

TEST(ColumnNames, WithAUnitThatIsNotKnownAreRefusedAndNotTakenForAnother) {
  const std::string remedy = "; if it is another way to write one: --columns=";
  EXPECT_EQ(read("Load (g),T [mN],A [mm^2]"),
            "1:1: 'Load (g)' may be P, but 'g' is not a force such as mN: it is a mass; if a weight is meant: "
            "--columns=\"P=Load (gf)\"");
  EXPECT_EQ(read("P [mN],T [mN],Contact area (thou^2)"),
            "1:15: 'Contact area (thou^2)' may be A, but 'thou^2' is not an area such as mm^2" + remedy +
                "\"A=Contact area (UNIT)\"");
  EXPECT_EQ(read("Load (g),T [mN],A [mm^2]", {{"columns", "P=Load (mN)"}}), "P from 'Load (g)'");  // as stated
  EXPECT_NE(read("Load (g),T [mN],A [mm^2]", {{"columns", "P=Load (g)"}})
                .find("'g' of column 'Load' is a mass; if a weight is meant: "
                      "--columns=\"P=Load (gf)\""),
            std::string::npos);
}

TEST(ColumnNames, WhichOfTwoForcesIsWhichIsNotGuessedByAHint) {
  EXPECT_EQ(read("Kraft eins [mN],Kraft zwei [mN],A [mm^2]"),
            "1:1: column 'T' is missing; not understood: 'Kraft eins [mN]', 'Kraft zwei [mN]'. To say which columns "
            "are P and "
            "T: --columns=\"P=HEADING (UNIT),T=HEADING (UNIT)\"");
  EXPECT_EQ(
      read("Kraft eins [mN],Kraft zwei [mN],Patch [mm^2]"),
      "1:1: the header names no known quantity; wanted P, T and A (or a), or psi (or mode_ratio) and Gc (or "
      "Gc_over_GIc), or G_I and G_II; not understood: 'Kraft eins [mN]', 'Kraft zwei [mN]', 'Patch [mm^2]'. To say "
      "which columns are P, T and A: --columns=\"P=HEADING (UNIT),T=HEADING (UNIT),A=Patch [mm^2]\"");
  // one alone can be it, and the hint can be followed as it stands
  EXPECT_EQ(read("P [mN],Kraft zwei [mN],A [mm^2]"),
            "1:1: column 'T' is missing; not understood: 'Kraft zwei [mN]'. To say which column is T: "
            "--columns=\"T=Kraft zwei [mN]\"");
  EXPECT_EQ(read("P [mN],Kraft zwei [mN],A [mm^2]", {{"columns", "T=Kraft zwei [mN]"}}), "T from 'Kraft zwei [mN]'");
  // what a mapping would not read back is named by its number
  EXPECT_EQ(read("P [mN],\"Kraft, 2 [mN]\",A [mm^2]"),
            "1:1: column 'T' is missing; not understood: 'Kraft, 2 [mN]'. To say which column is T: "
            "--columns=\"T=2\"");
  EXPECT_NE(read("\"Kraft, 1 [mN]\",\"Kraft, 2 [mN]\",A [mm^2]").find("--columns=\"P=NUMBER (UNIT),T=NUMBER (UNIT)\""),
            std::string::npos);
}

/// Two for each quantity whose heading is taken for it.
std::ptrdiff_t quotes_in(const std::string& taken) { return std::count(taken.begin(), taken.end(), '\''); }

TEST(ColumnNames, MayNameTheChannelOfARecorder) {
  for (const char* header : {"CH1 Normal load (mN),CH2 Friction force (mN),CH3 Contact area (mm2)",
                             "Ch. 1: Fn [mN],Ch. 2: Ft [mN],Ch. 3: A [mm^2]", "AI0_Fz [mN],AI1_Fx [mN],AI2_area [mm^2]",
                             "Kanal 1 - Normalkraft [mN],Kanal 2 - Reibkraft [mN],Kanal 3 - Kontaktfläche [mm²]"})
    EXPECT_EQ(quotes_in(read(header)), 6) << header;
  // a channel alone says nothing
  EXPECT_NE(read("CH1 (mN),CH2 (mN),CH3 (mm^2)").find("--columns=\"P=HEADING (UNIT),T=HEADING (UNIT),A=CH3 (mm^2)\""),
            std::string::npos);
  EXPECT_NE(read("Max 1 Fn [mN],T [mN],A [mm^2]").find("column 'P' is missing"), std::string::npos);
}

TEST(ColumnNames, MayWriteTheRatioOfToughnessesAsAFraction) {
  for (const char* ratio : {"Gc/GIc", "G_c/G_Ic [-]", "G_c/G_{Ic}", "G/GIc (1)", "Γ/Γ0", "toughness ratio"}) {
    const Dataset data = load_text("psi [deg]," + std::string(ratio) + "\n0,1\n30,1.1\n60,1.4\n");
    ASSERT_EQ(data.converted.size(), 3u) << ratio;
    EXPECT_NEAR(data.converted[2].ratio, 1.4, 1e-15) << ratio;
  }
}

TEST(ColumnNames, MayHaveTheWordForAForceBesideItsSymbol) {
  for (const char* header : {"Fn_Kraft [mN],Ft_Kraft [mN],A [mm^2]", "Kraft Fn [mN],Kraft Ft [mN],A [mm^2]",
                             "Fz force (mN),Fx force (mN),A (mm^2)", "sensor_Fz [mN],sensor_Fx [mN],A [mm^2]"})
    EXPECT_EQ(quotes_in(read(header)), 4) << header;
  // "N" is a unit, and two signs are none
  EXPECT_NE(read("Force N,T [mN],A [mm^2]").find("'P' is missing"), std::string::npos);
  EXPECT_NE(read("Fz setpoint [mN],T [mN],A [mm^2]").find("'P' is missing"), std::string::npos);
}

TEST(ColumnNames, AreThoseAboveRowsThatACommaMakesWider) {
  const std::string header = "curve,P [mN],T [mN],A [mm^2]\n", aged = "aged,4,0,0.3\naged,4,1,0.3\n";
  std::string wide;
  for (int i = 0; i < 6; ++i) wide += "fresh, 5 d,4," + std::to_string(i) + ",0.3\n";
  EXPECT_EQ(
      load_error(header + aged + wide, "radius = \"9.42 mm\"\nmodulus = \"2.133 MPa\"\ntoughness = \"27 mJ/m^2\"\n"),
      "a.csv:4:16: the row has more fields than the header's 4 (a text with a comma needs quotes around it)");
}

TEST(ColumnNames, MayNameADeviceBeforeAColon) {
  EXPECT_EQ(quotes_in(read("Latest: Normal Force (mN),Latest: Friction Force (mN),Latest: Contact Area (mm²)")), 6);
  EXPECT_NE(read("Max: Normal Force (mN),T [mN],A [mm^2]").find("'P' is missing"), std::string::npos);
}

TEST(ColumnNames, OfRHaveDotsForBrackets) {
  for (const char* header :
       {"Fn.mN,Ft.mN,A.mm2", "Fn..mN.,Ft..mN.,Area..mm2.", "Normal.force..mN.,Shear.force..mN.,Contact.area..mm2."})
    EXPECT_EQ(read(header).find("missing"), std::string::npos) << read(header);
}

TEST(ColumnNames, OfADiameterGiveTheArea) {
  const double d = 2 * std::sqrt(0.29 / std::numbers::pi);  // mm
  for (const char* name : {"EquivDiameter_um", "Contact diameter [um]", "diamètre de contact (µm)"}) {
    const std::string text = std::to_string(1e3 * d);
    EXPECT_NE(
        load_text(std::string("P [mN],T [mN],") + name + "\n4.68,0," + text + "\n4.67,1," + text + "\n", "", kConstants)
            .taken.back()
            .find("diameter from"),
        std::string::npos);
  }
}

TEST(ColumnNames, AreKnownInJapaneseAndChinese) {
  for (const char* header : {"垂直荷重 [mN],せん断力 [mN],接触面積 [mm²]", "法線力(mN),摩擦力(mN),接触面積(㎟)",
                             "法向力 (mN),切向力 (mN),接触面积 (mm2)"})
    EXPECT_EQ(quotes_in(read(header)), 6) << header;
}

TEST(ColumnNames, WhoseUnitIsOfAnotherKindAreNotTheQuantityWhereAnotherColumnIs) {
  const std::string rows = "20,4.68,0,0.3\n20,4.67,1,0.29\n20,4.69,2,0.28\n";
  EXPECT_EQ(read("T [°C],P [mN],Friction force (mN),A [mm^2]", {}, rows), "T from 'Friction force (mN)'");
  EXPECT_EQ(read("P (kPa),Fn (mN),T (mN),A [mm^2]", {}, rows), "P from 'Fn (mN)'");
  EXPECT_EQ(read("T (K),P (mN),T (mN),A [mm^2]", {}, rows), "");
  EXPECT_EQ(read("T,P,Friction force,A\n°C,mN,mN,mm^2", {}, rows), "T from 'Friction force'");
  EXPECT_NE(read("P [mN],T [°C],A [mm^2]").find("'°C' of column 'T' is no unit"), std::string::npos);
}

TEST(Numbers, ThatMayBeInGroupsOfThreeAreRefusedWithTheFlagThatSaysSo) {
  EXPECT_EQ(load_error("P;T;A\n0,8;0,1;238.180\n0,8;1,1;236.180\n"),
            "a.csv:2:9: column 'A': '238.180' is not a number but for 238180, if digits stand in groups of three: "
            "--decimal=\",\" says so");
}

TEST(ColumnNames, OfErrorsAndRunsAreKnownBesideTheProgramsOwnNames) {
  const std::string rows = "4.68,0,0.3,0.2,0.01,dry\n4.67,1,0.29,0.2,0.01,dry\n4.69,2,0.28,0.2,0.01,wet\n";
  for (const auto& [T, A] : std::vector<std::pair<std::string, std::string>>{
           {"T_err [mN]", "A_err [mm^2]"},
           {"sigma T (mN)", "sigma A (mm^2)"},
           {"Shear force error (mN)", "Contact area std (mm^2)"},
           {"standard error of T [mN]", "standard deviation of the contact area [mm^2]"},
           {"u_FT [mN]", "s_A [mm^2]"},
           {"T +/- (mN)", "A ± (mm^2)"},
           {"err(T)", "err(A)"},
           {"Fehler Reibkraft (mN)", "Unsicherheit der Kontaktfläche (mm^2)"},
           {"erreur de frottement (mN)", "Aire de contact écart-type (mm^2)"},
           {"T_err_mN", "A_err_mm2"},
       })
    for (const std::string run : {"run", "series", "Curve", "Versuch"}) {
      const bool bare = T == "err(T)";  // as P, T and A
      const std::string header = (bare ? "P,T,A," : "P [mN],T [mN],A [mm^2],") + T + "," + A + "," + run;
      const Dataset data = load_text(header + "\n" + rows, "", bare ? Overrides{} : kConstants);
      ASSERT_EQ(data.errors.size(), 3u) << header;
      const double T_unit = bare ? 1 : 1e-3 / data.contact.value().force_unit();
      EXPECT_NEAR(data.errors[1].T, 0.2 * T_unit, 1e-15) << header;
      EXPECT_GT(data.errors[1].A, 0) << header;
      EXPECT_EQ(data.curves, (std::vector<std::string>{"dry", "wet"})) << header;
    }
  const Dataset converted = load_text("psi [deg],Gc_over_GIc,Gc error,Include\n0,1,0.1,1\n9,1.1,0.2,0\n");
  ASSERT_EQ(converted.errors.size(), 1u);
  EXPECT_EQ(converted.errors[0].ratio, 0.1);
  EXPECT_NE(read("P [mN],T [mN],A [mm^2],run,series", {}, rows).find("may both be curve; say which"),
            std::string::npos);
}

TEST(ColumnNames, ThatAreMisspeltAreSaidWithTheNameThatWasMeant) {
  const auto notes = [](const std::string& more) {
    return texts_of(load_text("P [mN],T [mN],A [mm^2]," + more + "\n1,0,0.3,1\n1,1,0.29,1\n", "", kConstants).notes);
  };
  for (const auto& [given, name, meant] :
       std::vector<std::array<std::string, 3>>{{"simga_T [mN]", "simga_T", "sigma_T"},
                                               {"Sigma_AA [mm^2]", "Sigma_AA", "sigma_A"},
                                               {"inclued", "inclued", "include"},
                                               {"curv", "curv", "curve"}})
    EXPECT_EQ(notes(given), std::vector<std::string>{"column '" + name + "' is not used: did you mean " + meant + "?"})
        << given;
  for (const char* other : {"simga_T [mm]", "phi", "x", "T2", "temperature", "cycle"})
    EXPECT_EQ(notes(other), std::vector<std::string>{}) << other;
  const std::string both = "P [mN],T [mN],A [mm^2],sigma_T [mN],simga_T [mN]\n1,0,0.3,1,1\n1,1,0.29,1,1\n";
  EXPECT_EQ(texts_of(load_text(both, "", kConstants).notes), std::vector<std::string>{});
}

TEST(ColumnNames, ThatAreMisspeltInAMappingAreRefusedWithTheNameThatWasMeant) {
  const auto end = [](const std::string& mapping) {
    Overrides constants = kConstants;
    constants.emplace_back("columns", mapping);
    try {
      load_text("Druck [mN],Querkraft [mN],Zelle [mm^2]\n1,0,0.3\n1,1,0.29\n", "", constants);
    } catch (const InputError& error) {
      const std::string text = error.what();
      return text.substr(text.rfind("'Zelle [mm^2]'") + 14);
    }
    return std::string("read");
  };
  EXPECT_EQ(end("P=Druck,T=Querkraft,A=Zelle"), "read");
  EXPECT_EQ(end("P=Druck,T=Querkarft (mN),A=Zelle"), ": did you mean Querkraft?");
  EXPECT_EQ(end("P=Druck,T=Weg,A=Zelle"), "");
  EXPECT_EQ(end("P=Druck,T=Querkraft,simga_T=Zelle"), "; 'simga_T' is no quantity: did you mean sigma_T?");
}

TEST(ColumnNames, ThatAreKnownAndNotUsedAreSaidWithTheReason) {
  const auto notes = [](const std::string& more) {
    return texts_of(load_text("P [mN],T [mN],A [mm^2]," + more + "\n1,0,0.3,1\n1,1,0.29,1\n", "", kConstants).notes);
  };
  EXPECT_EQ(notes("Load (mN)"), std::vector<std::string>{"column 'Load' is not used: P is read from 'P [mN]'"});
  EXPECT_EQ(notes("A_err [mm]"),
            std::vector<std::string>{"column 'A_err' is not used: its unit 'mm' does not fit sigma_A"});
  EXPECT_EQ(
      notes("Gc error [J/m^2]"),
      std::vector<std::string>{"column 'Gc error' is not used: it may be sigma_Gc, which these columns do not need"});
  EXPECT_EQ(notes("radius (mm)"),
            std::vector<std::string>{"column 'radius' is not used: it may be a, which these columns do not need"});
  EXPECT_EQ(notes("time [s]"), std::vector<std::string>{});
  EXPECT_EQ(notes("camera"), std::vector<std::string>{});
}

TEST(ColumnNames, OfTimesDoNotMatterToPoints) {
  EXPECT_EQ(read("Time (s),P [mN],Time (s),T [mN],Time (s),A [mm^2]", {},
                 "0,4.68,0,0,0,0.3\n0,4.67,0,1,0,0.29\n0,4.69,0,2,0,0.28\n"),
            "");
}

TEST(ColumnNames, MayLeaveThoseOfRowsOut) {
  const std::string rows = "1,4.68,0,0.3\n2,4.67,1,0.29\n3,4.69,2,0.28\n";
  EXPECT_EQ(read("P [mN],T [mN],A [mm^2]", {}, rows), "");
  EXPECT_EQ(read("\"P [mN]\" \"T [mN]\" \"Contact area [mm^2]\"", {},
                 "\"a\" 4.68 0 0.3\n\"b\" 4.67 1 0.29\n\"c\" 4.69 2 0.28\n"),
            "A from 'Contact area [mm^2]'");
  EXPECT_NE(read("P [mN],T [mN],A [mm^2]", {}, "4.68,0,0.3,1\n4.67,1,0.29,1\n4.69,2,0.28,1\n").find("more fields"),
            std::string::npos);
}

TEST(ColumnNames, OfRunsBesideEachOtherAreSaidWhereOneIsRead) {
  const std::string rows = "4.68,0,0.3,2,0,0.2\n4.67,1,0.29,2,1,0.2\n";
  const auto notes = [&](const std::string& header, const std::string& columns) {
    Overrides stated = kConstants;
    stated.emplace_back("columns", columns);
    return texts_of(load_text(header + "\n" + rows, "", stated).notes);
  };
  EXPECT_EQ(notes("P1 [mN],T1 [mN],A1 [mm^2],P2 [mN],T2 [mN],A2 [mm^2]", "P=P1,T=T1,A=A1").at(0),
            "one run is read, and the runs beside it are not: 'P2 [mN]', 'T2 [mN]', 'A2 [mm^2]' are named like its "
            "columns except for a number; put them below it, or in separate files");
  EXPECT_EQ(notes("P [mN],T [mN],A [mm^2],P [mN],T [mN],A [mm^2]", "P=4,T=5,A=6").size(), 1u);
  EXPECT_EQ(notes("P1 [mN],T1 [mN],A1 [mm^2],P2 [mN],x,y", "P=P1,T=T1,A=A1").size(), 0u);
}

}  // namespace column_names_test
}  // namespace mixity
