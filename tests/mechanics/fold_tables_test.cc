// Folds against tables that brute force on the printed equation made.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

#include "mechanics/fold_checks.h"
#include "mechanics/folds.h"
#include "mechanics/registry.h"

namespace mixity {
namespace fold_tables_test {

/// Calls visit(model, p) for a model by name.
template <class Visit>
void with_parameters(std::string_view model, double p0, double p1, Visit visit) {
  for_each_model([&](auto m) {
    if (m.info.key != model) return;
    Parameters<decltype(m)> p{};
    p[0] = p0;
    if (p.size() > 1) p[p.size() - 1] = p1;
    visit(m, p);
  });
}

struct Row {
  const char* model;
  double p0, p1, P;
  Control control;
  std::size_t index;
  double T, u, A;
};

// Brute force in 40 digits (every extremum of T, u, u + T/k on a dense sampling of the printed curve, refined).
const Row kRows[] = {
    {"a", 0.5, 0, -4.7, spring(0.1), 0, 0.68431243082352288, 0.33666172737663485, 7.3011918958657352},
    {"a", 0.95, 0, 0.0, spring(0.1), 0, 9.9509754547435363, 3.9979923772115958, 10.947621807339782},
    {"a", 0.95, 0, 0.0, spring(0.1), 1, 7.9854020896237212, 5.1725074224681464, 4.2117611335790164},
    {"a", 0.999999999999, 0, 0.0, kDisplacement, 0, 8.1620971390458184, 4.0187922627479988, 7.2892828511034010},
    {"a", 0.999999999999, 0, 0.0, kDisplacement, 1, 0.000043530703246659163, 0.085058820594746748,
     4.6283378473083246e-7},
    {"a", 0.999999999999, 0, 11.5, spring(1.0), 0, 17.439866662474651, 5.3284698550131141, 18.930134231694198},
    {"a", 0.999999999999, 0, 11.5, spring(1.0), 1, 14.724754715928573, 5.3847639147463608, 13.214027406697386},
    {"a", 0.999999999999, 0, 11.5, spring(10.0), 1, 14.724841199578978, 5.3847388308339468, 13.214305740832359},
    {"a", 0.999999999999, 0, 1000.0, kDisplacement, 0, 137.47343424408829, 11.336310667153216, 259.87618656813057},
    {"a", 0.999999999999, 0, 1000.0, kDisplacement, 1, 137.29756097247448, 11.333480296981069, 259.34116421263339},
    {"a", 1.0, 0, -0.23, spring(0.1), 0, 9.1911422116079279, 3.6372064326605250, 11.284321996612518},
    {"a", 1.0, 0, 0.0, spring(0.1), 0, 9.4240120152069058, 3.6986543057777613, 11.472460680195294},
    {"a", 1.0, 0, 11.5, kLoad, 0, 17.481313815257135, 5.2367433748806009, 19.692368488078469},
    {"a", 1.0, 0, 1000.0, spring(10.0), 0, 137.58766611495878, 11.332758862793861, 260.47144007433219},
    {"b", 0.0001, 0, -0.23, spring(1.0), 0, 56142.514734892292, 30207.443752401121, 6.1041918093821250},
    {"b", 0.0023, 0, -4.7, kLoad, 0, 11.936391003916288, 5.8743738863319424, 7.2961760337522872},
    {"b", 0.0023, 0, -0.23, spring(0.1), 0, 2483.9204578317273, 1234.6546356065826, 7.1524821983691289},
    {"b", 0.15, 0, -1.79, spring(0.1), 0, 29.440721544095113, 13.868981065054158, 7.9630636718312240},
    {"b", 0.3, 0, -0.23, kLoad, 0, 23.236289928667671, 10.291349252429185, 9.0086837053124125},
    {"b", 1.0, 0, -4.7, spring(1.0), 0, 0.55805056872809969, 0.27463393096195415, 7.2964418091625239},
    {"b", 1.7, 0, -0.23, kDisplacement, 0, 8.0543523695310593, 4.0169557549102015, 7.1045987378142133},
    {"b", 1.7, 0, 30.4, spring(1.0), 0, 26.203169218228931, 6.4197589179393637, 29.440325269526881},
    {"b", 2.0, 0, -0.23, kDisplacement, 0, 7.9629050765690589, 3.9514923143140706, 7.1761778533522996},
    {"b", 2.0, 0, 1.0, kDisplacement, 0, 9.0266473975832328, 4.2719703932785340, 7.8898525611351234},
    {"b", 2.0, 0, 11.5, spring(0.1), 0, 17.480729979181669, 5.2485411610706034, 19.602628678369349},
    {"c", 0.0001, 0, -1.79, kDisplacement, 0, 657.88040134535118, 336.62137145151786, 6.7496760089820750},
    {"c", 0.0023, 0, -4.7, spring(0.1), 0, 10.076364544120109, 4.9572549415432182, 7.3012569543417444},
    {"c", 0.15, 0, -0.23, kLoad, 0, 23.733386013216391, 9.3516188229332379, 11.381990332837813},
    {"c", 0.15, 0, 1.0, kDisplacement, 0, 23.306703361950921, 11.030180125772608, 7.8898525611351234},
    {"c", 0.15, 0, 1.0, spring(0.1), 0, 26.790516380072024, 10.165131925917666, 12.274633392106477},
    {"c", 0.5, 0, 30.4, spring(10.0), 0, 35.866435368580612, 9.0080069573794042, 28.015050226403063},
    {"c", 0.95, 0, -1.79, spring(1.0), 0, 7.5698006556266102, 3.2935825530354554, 9.3347819627263355},
    {"c", 0.95, 0, 30.4, kLoad, 0, 26.394834814182520, 6.3803132714655462, 30.243098947596212},
    {"c", 1.0, 0, 1.0, spring(1.0), 0, 10.321563955809401, 4.0434235158478550, 11.515026725714103},
    {"c", 1.0, 0, 30.4, spring(1.0), 0, 25.702290589655414, 6.2720438481512201, 29.675489168958024},
    {"bk", 1.5, 1.0, 0.0, kDisplacement, 0, 10.461200376919653, 5.0051208813044516, 7.7198044504066590},
    {"bk", 1.774, 2.284, 1000.0, kDisplacement, 0, 183.07635246714279, 15.098572084001889, 259.81555490033272},
    {"bk", 0.7, 1.5, 1000.0, kDisplacement, 0, 115.16058293556722, 9.4869982413312504, 260.38890092874606},
    {"bk", 1.5, 1.0, 1000.0, spring(10.0), 0, 168.55468047961256, 13.879653460013026, 260.61342677055950},
    {"bk", 1.774, 2.284, 30.4, kLoad, 0, 33.988957081602671, 8.3000721751931181, 29.633594885295302},
    {"bk", 0.7, 1.5, 1000.0, kLoad, 0, 115.37917530818480, 9.4700594499786239, 262.31422928464852},
};

TEST(Folds, AreThoseOfTheTable) {
  for (const Row& row : kRows)
    with_parameters(row.model, row.p0, row.p1, [&](auto model, const auto& p) {
      const std::string where = describe(model, p, row.P, row.control);
      const auto folds = find_folds(EquilibriumCurve(model, p, row.P), row.control);
      ASSERT_GT(folds.size(), row.index) << where;
      const Fold& fold = folds[row.index];
      EXPECT_EQ(fold.place.maximum, row.index == 0) << where;
      // what the header promises
      EXPECT_NEAR(fold.T, row.T, 1e-13 * row.T) << where;
      EXPECT_NEAR(fold.u, row.u, 1e-12 * row.u) << where;
      EXPECT_NEAR(fold.A, row.A, 1e-12 * row.A) << where;
      const double a = std::sqrt(row.A / pi<double>()), y = 4.0 / 3 * a * a * a - row.P;
      // y + P to 1.5e-12, so y to more where P cancels; d psi <= dy/y
      EXPECT_NEAR(fold.psi, std::atan2(row.T, y), 2e-12 * (1 + std::abs(row.P) / y)) << where;
    });
}

struct Counts {
  const char* model;
  double p0;
  const char* folds;  // for each load five digits: under load, displacement, k = 0.1, 1, 10
};
const double kTableLoads[] = {-4.7, -1.79, -0.23, -1e-6, 0, 1, 5.5, 11.5, 30.4, 1000};
// From the same brute force, for a and b; c and bk fold once, whatever their parameters.
const Counts kCounts[] = {
    {"a", 0.0001, "00000 00000 00000 00000 00000 00000 00000 00000 00000 00000"},
    {"a", 0.0023, "00000 00000 00000 00000 00000 00000 00000 00000 00000 00000"},
    {"a", 0.15, "11111 00000 00000 00000 00000 00000 00000 00000 00000 00000"},
    {"a", 0.5, "11111 00000 00000 00000 00000 00000 00000 00000 00000 00000"},
    {"a", 0.8888888888888888, "11111 11111 20200 20000 00000 00000 00000 00000 00000 00000"},
    {"a", 0.9, "11111 11111 20200 20200 20200 00000 00000 00000 00000 00000"},
    {"a", 0.95, "11111 11111 20220 20220 20220 20220 00000 00000 00000 00000"},
    {"a", 0.999999999999, "11111 11111 11111 11111 22222 22222 22222 22222 22222 22222"},
    {"a", 1.0, "11111 11111 11111 11111 11111 11111 11111 11111 11111 11111"},
    {"b", 0.0001, "11111 11111 11111 11111 11111 10110 00000 00000 00000 00000"},
    {"b", 0.0023, "11111 11111 11111 11111 11111 10110 00000 00000 00000 00000"},
    {"b", 0.15, "11111 11111 11111 11111 11111 10110 10000 00000 00000 00000"},
    {"b", 0.3, "11111 11111 11111 11111 11111 10111 10100 00000 00000 00000"},
    {"b", 1.0, "11111 11111 11111 11111 11111 11111 10111 10110 10100 00000"},
    {"b", 1.7, "11111 11111 11111 11111 11111 11111 11111 11111 11111 10111"},
    {"b", 2.0, "11111 11111 11111 11111 11111 11111 11111 11111 11111 11111"},
};

TEST(Folds, AreAsManyAsBruteForceFinds) {
  for (const Counts& row : kCounts)
    with_parameters(row.model, row.p0, 0, [&](auto model, const auto& p) {
      std::string found;
      for (const double P : kTableLoads) {
        const EquilibriumCurve curve(model, p, P);
        found += found.empty() ? "" : " ";
        for (const Control& control : {kLoad, kDisplacement, spring(0.1), spring(1), spring(10)})
          found += std::to_string(find_folds(curve, control).size());
      }
      EXPECT_EQ(found, row.folds) << row.model << ' ' << row.p0;
    });
  for (const double P : kTableLoads)
    for (const Control& control : {kLoad, kDisplacement, spring(0.1), spring(1), spring(10)}) {
      for (const double lambda : {0.0001, 0.0023, 0.15, 0.5, 0.95, 1.0})
        EXPECT_EQ(find_folds(EquilibriumCurve(PapangeloCiavarella{}, {lambda}, P), control).size(), 1u);
      for (const auto& p : {std::array{1.774, 2.284}, {1.5, 1.0}, {3.0, 2.5}, {0.7, 1.5}})
        EXPECT_EQ(find_folds(EquilibriumCurve(BenzeggaghKenane{}, p, P), control).size(), 1u);
    }
}

}  // namespace fold_tables_test
}  // namespace mixity
