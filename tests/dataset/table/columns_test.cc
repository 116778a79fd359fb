#include "dataset/table/columns.h"

#include <gtest/gtest.h>

#include "dataset/table/csv_file.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace columns_test {

/// The columns of a header; throws what Columns throws.
Columns columns_of(const std::string& header) {
  const TemporaryFolder folder;
  std::optional<Columns> columns;
  read_csv(folder.write("a.csv", header + "\n"),
           [&](const CsvRow& row) { columns.emplace("a.csv", headings_of(row)); });
  return columns.value();
}

std::string error_of(const std::string& header) {
  return input_error([&] { columns_of(header); });
}

TEST(Columns, StandInAnyOrder) {
  for (const auto& [header, P, T, A] : {std::tuple{"P,T,A", 0, 1, 2}, {"A,T,P", 2, 1, 0}, {"x,T,A,,P", 4, 1, 2}}) {
    const Columns columns = columns_of(header);
    EXPECT_EQ(columns.find(ColumnId::P)->index, P) << header;
    EXPECT_EQ(columns.find(ColumnId::T)->index, T) << header;
    EXPECT_EQ(columns.find(ColumnId::A)->index, A) << header;
  }
}

TEST(Columns, CarryUnitsInBracketsOrParentheses) {
  for (const char* header : {"P [mN],T [mN],A [mm^2]", "P (mN),T (mN),A (mm^2)", "P[mN],T( mN ),A [ mm² ]"}) {
    const Columns columns = columns_of(header);
    EXPECT_EQ(columns.find(ColumnId::T)->unit.factor, 1e-3) << header;
    EXPECT_DOUBLE_EQ(columns.find(ColumnId::A)->unit.factor, 1e-6) << header;  // 4 ulp: 1e-3 squared is rounded
    EXPECT_EQ(columns.find(ColumnId::A)->unit.dimension, dimension::area) << header;
  }
}

TEST(Columns, MayHaveNoBreakSpacesAroundTheirNames) {
  const Columns columns = columns_of("\xC2\xA0P\xC2\xA0[mN],T\xC2\xA0 [\xC2\xA0mN],\xC2\xA0 A [mm^2] \xC2\xA0\n");
  EXPECT_TRUE(columns.ignored.empty());
  EXPECT_EQ(columns.find(ColumnId::T)->unit.text, "mN");
}

TEST(Columns, AreNamedByTheWordsOfANameInAnyOrderAndInTeX) {
  for (const char* header :
       {"Area reale di contatto (mm^2),Carico normale (mN),Forza di attrito (mN)",
        "area of the contact (mm^2),Force normal (mN),Force of friction (mN)", "$A$ (mm$^{2}$),$F_N$ (mN),$F_{T}$ [mN]",
        "$A_\\mathrm{c}$ ($\\mu\\mathrm{m}^2$),$F_{\\rm N}$\\:(mN),$F_\\text{T}$ (\\textmu N)"}) {
    const Columns columns = columns_of(header);
    EXPECT_EQ(columns.find(ColumnId::A)->index, 0) << header;
    EXPECT_EQ(columns.find(ColumnId::P)->index, 1) << header;
    EXPECT_EQ(columns.find(ColumnId::T)->index, 2) << header;
    EXPECT_EQ(columns.find(ColumnId::A)->unit.dimension, dimension::area) << header;
  }
}

TEST(Columns, WithoutAUnitAreDimensionless) {
  const Columns columns = columns_of("P,T,a");
  EXPECT_EQ(columns.find(ColumnId::a)->unit.dimension, dimension::none);
  EXPECT_EQ(columns.find(ColumnId::a)->unit.factor, 1);
  EXPECT_TRUE(columns.holds_loads());
  EXPECT_FALSE(columns.has(ColumnId::A));
}

TEST(Columns, ThatMeanNothingAreKeptByName) {
  const Columns columns = columns_of("P,time [ms],T,A,,Temp (C)");
  EXPECT_EQ(columns.ignored, (std::vector<std::string>{"time", "Temp"}));
  EXPECT_EQ(columns.count, 6);
  EXPECT_EQ(columns_of("P,T,A,strain (%) max,b [c").ignored, (std::vector<std::string>{"strain (%) max", "b [c"}));
  // such names go into notes
  EXPECT_EQ(columns_of("P,T,A,te\x1bmp,Wei\xdf").ignored, (std::vector<std::string>{"te?mp", "Weiß"}));
}

TEST(Columns, OfConvertedPointsAreOneAngleAndOneToughness) {
  for (const char* header :
       {"psi,Gc", "psi [deg],Gc_over_GIc", "Gc [N/mm],mode_ratio", "mode_ratio,Gc_over_GIc,curve"}) {
    EXPECT_FALSE(columns_of(header).holds_loads()) << header;
  }
  EXPECT_EQ(columns_of("psi [rad],Gc").find(ColumnId::psi)->unit.factor, 1);
}

TEST(Columns, AStandardErrorMayBeAPercentage) {
  EXPECT_EQ(columns_of("P,T,A,sigma_A [%]").find(ColumnId::sigma_A)->unit.factor, 0.01);
  EXPECT_EQ(columns_of("P [N],T [N],A [m^2],sigma_T (%)").find(ColumnId::sigma_T)->unit.text, "%");
}

// Otherwise a standard error in mm^2 would silently be taken for one in units of (R/xi)^2, or the reverse.
TEST(Columns, AStandardErrorHasAUnitExactlyIfItsQuantityHasOne) {
  for (const char* header :
       {"P,T,A,sigma_A [mm^2]", "P,T,A,sigma_T [mN]", "P [N],T [N],A [m^2],sigma_A", "P [N],T [N],A [m^2],sigma_T",
        "psi,Gc_over_GIc,sigma_Gc [N/mm]", "psi,Gc [N/mm],sigma_Gc"})
    EXPECT_NE(error_of(header), "") << header;
}

TEST(Columns, AMappingChoosesBetweenTwoNamesOfAQuantity) {
  const auto chosen = [](const std::string& header, const std::map<std::string, std::string>& mapping) {
    std::vector<Heading> headings;
    std::size_t place = 0;
    for (const std::string_view text : split(header))
      headings.push_back(split_heading(std::string(text), {1, ++place}));
    const Columns columns("a.csv", headings, {mapping});
    std::string names;
    for (const auto& column : columns.by_id)
      if (column) names += std::string(to_string(column->id)) + std::to_string(column->index) + " ";
    return names;
  };
  EXPECT_EQ(chosen("P,T,A,a", {{"A", "3"}}), "P0 T1 A2 ");
  EXPECT_EQ(chosen("P,T,A,a", {{"a", "4"}}), "P0 T1 a3 ");
  EXPECT_EQ(chosen("psi,mode_ratio,Gc", {{"psi", "psi"}}), "psi0 Gc2 ");
  EXPECT_EQ(chosen("psi,mode_ratio,Gc", {{"mode_ratio", "mode_ratio"}}), "mode_ratio1 Gc2 ");
  EXPECT_EQ(chosen("psi,Gc,Gc_over_GIc", {{"Gc_over_GIc", "3"}}), "psi0 Gc_over_GIc2 ");
}

TEST(Columns, AHeaderThatCannotBeUsedIsRefusedWithItsPlace) {
  const std::string force = "a force such as mN, or no unit if dimensionless";
  for (const auto& [header, error] : std::vector<std::pair<std::string, std::string>>{
           {"x,y",
            "1:1: the header names no known quantity; wanted P, T and A (or a), or psi (or mode_ratio) and Gc "
            "(or Gc_over_GIc), or G_I and G_II; not understood: 'x', 'y'. To say which columns are P, T and A: "
            "--columns=\"P=HEADING (UNIT),T=HEADING (UNIT),A=HEADING (UNIT)\""},
           {"p,t,area",
            "1:1: column 'T' is missing; not understood: 'p', 't'. To say which columns are P and T: "
            "--columns=\"P=HEADING (UNIT),T=HEADING (UNIT)\""},
           {"T,A",
            "1:1: column 'P' is missing; one normal load of all points is stated by --load=\"5 mN\", or the key load"},
           {"P,A", "1:1: column 'T' is missing"},
           {"P,T", "1:1: column 'A' or 'a' is missing"},
           {"psi", "1:1: column 'Gc' or 'Gc_over_GIc' is missing"},
           {"Gc", "1:1: column 'psi' or 'mode_ratio' is missing"},
           {"P,T,A,a",
            "1:1: columns 'A' or 'a': one of them, not both; --columns=\"A=3\" or --columns=\"a=4\" chooses"},
           {"psi,mode_ratio,Gc",
            "1:1: columns 'psi' or 'mode_ratio': one of them, not both; --columns=\"psi=psi\" or "
            "--columns=\"mode_ratio=mode_ratio\" chooses"},
           {"P,T,A,psi", "1:1: the header mixes loads (P, T, A) with toughness (psi, Gc); give one set"},
           {"P,T,T,A",
            "1:5: column 'T' stands twice, in columns 2 and 3; --columns=\"T=3\" says which; if these are runs side "
            "by side, put them below one another with a column 'curve'"},
           {"P [N],T [N],A [m^2],P (mN)",
            "1:21: column 'P' stands twice, in columns 1 and 4; --columns=\"P=4\" says which; if these are runs side "
            "by side, put them below one another with a column 'curve'"},
           {"P [N],T [mm],A [m^2]", "1:7: unit 'mm' of column 'T' does not fit; wanted " + force},
           {"P [foo],T,A", "1:1: 'foo' of column 'P' is no unit; wanted " + force},
           {"P [],T,A", "1:1: '' of column 'P' is no unit; wanted " + force},
           {"P,T [%],A", "1:3: unit '%' of column 'T' does not fit; wanted " + force},
           {"psi [N],Gc",
            "1:1: unit 'N' of column 'psi' does not fit; wanted an angle (rad or deg), or no unit if "
            "dimensionless"},
           {"mode_ratio [rad],Gc", "1:1: unit 'rad' of column 'mode_ratio' does not fit; wanted a plain number"},
           {"P [N,T,A", "1:1: the unit of column 'P' is not closed: 'P [N'"},
           {"P,T [N),A", "1:3: the unit of column 'T' is not closed: 'T [N)'"},
           {"P [N],T,A [m^2]",
            "1:7: column 'T' has no unit while P has one; P, T and A are either all dimensionless or "
            "none is; say its unit: --columns=\"T=T (N)\""},
           {"A [mm²],P,T",
            "1:1: column 'A' has a unit while P has none; P, T and A are either all dimensionless or "
            "none is"},
           {"µ [µm],P [N],T [N],a",
            "1:20: column 'a' has no unit while P has one; P, T and A are either all "
            "dimensionless or none is; say its unit: --columns=\"a=a (UNIT)\""},
       })
    EXPECT_EQ(error_of(header), "a.csv:" + error) << header;
}

TEST(Columns, AreNamedAsInTheHeader) {
  EXPECT_EQ(to_string(ColumnId::Gc_over_GIc), "Gc_over_GIc");
  EXPECT_EQ(to_string(ColumnId::a), "a");
  EXPECT_EQ(to_string(ColumnId::include), "include");
}

}  // namespace columns_test
}  // namespace mixity
