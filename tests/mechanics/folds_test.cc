// Folds under load, displacement and through a spring: closed forms, 40-digit tables, and what a jump leads to.
#include "mechanics/folds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>
#include <string>

#include "mechanics/printed_equation.h"

namespace mixity {
namespace {

using truth::Digits50;

constexpr Control kLoad{Control::Kind::load}, kDisplacement{Control::Kind::displacement};
Control spring(double k) { return {Control::Kind::stiffness, k}; }

/// Model c without its closed forms: the general route must find the same.
struct GeneralModelC {
  static constexpr ModelInfo info = PapangeloCiavarella::info;
  static constexpr auto parameters = PapangeloCiavarella::parameters;
  template <class S>
  static ShearTerm<S> shear_term(const std::array<S, 1>& p, const S& y, const S& T) {
    return PapangeloCiavarella::shear_term(p, y, T);
  }
  static double small_shear(const std::array<double, 1>& p) { return PapangeloCiavarella::small_shear(p); }
};

void expect_near(double value, const Digits50& truth, double relative, const std::string& what) {
  EXPECT_LE(abs(Digits50(value) - truth), relative * abs(truth)) << what << " is " << value << " not " << truth;
}

template <class Model>
std::string text(const Parameters<Model>& p, double P, const Control& control) {
  std::ostringstream out;
  out.precision(17);
  out << Model::info.key << ' ' << p[0] << ' ' << (p.size() > 1 ? p[1] : 0) << " P=" << P << ' '
      << to_string(control.kind) << ' ' << control.stiffness;
  return out.str();
}

/// Calls visit(model, p) for a model by name.
template <class Visit>
void with_parameters(std::string_view model, double p0, double p1, Visit visit) {
  with_model(model, [&](auto m) {
    Parameters<decltype(m)> p{};
    p[0] = p0;
    if (p.size() > 1) p[p.size() - 1] = p1;
    visit(m, p);
  });
}

/// Model c in closed form, 50 digits (the design's, minus branch).
struct ClosedForm {
  Digits50 T_load, a_load, T_disp, a_disp, a_plus;
  ClosedForm(double lambda, double load) {
    const Digits50 l = lambda, P = load, q = truth::kPi, c = Digits50(3) / 4;
    T_load = sqrt(Digits50(3 * q * (3 * q + 2 * P) / l));
    a_load = cbrt(Digits50(c * (3 * q + P)));
    const Digits50 root = sqrt(Digits50(3 * pow(3 * q + P, 2) * (3 * q * q + 2 * q * P + 3 * P * P)));
    T_disp = sqrt(Digits50(Digits50(3) / 2 * (9 * q * q + 6 * q * P - 3 * P * P + root) / l)) / 2;
    const Digits50 v = sqrt(Digits50(9 * q * q + 6 * q * P - l * T_disp * T_disp));
    a_disp = cbrt(Digits50(c * (3 * q + P - v)));
    a_plus = cbrt(Digits50(c * (3 * q + P + v)));
  }
};

/// How v = T, u or u + T/k changes along the printed curve at a state (y, T) on it, in 50 digits: d ln v/d ln y, from
/// central differences of the printed equation.
template <class Model>
Digits50 printed_slope(const Parameters<Model>& p, double P, const Control& control, const Digits50& y,
                       const Digits50& T) {
  const auto F = [&](const Digits50& y_, const Digits50& T_) { return truth::residual_of<Model>(p, P, y_, T_); };
  const Digits50 h = y * Digits50(1e-15), k = T * Digits50(1e-15);
  const Digits50 T_y = -((F(y + h, T) - F(y - h, T)) / h) / ((F(y, T + k) - F(y, T - k)) / k);
  if (control.kind == Control::Kind::load) return T_y * y / T;
  const Digits50 a = cbrt(Digits50(Digits50(3) / 4 * (y + P))), u = Digits50(3) / 4 * T / a;
  const Digits50 u_y = u * (T_y / T - 1 / (4 * a * a * a));
  if (control.kind == Control::Kind::displacement) return u_y * y / u;
  return (u_y + T_y / control.stiffness) * y / (u + T / control.stiffness);
}

// T is at an extremum and holds to a few roundings; A and u carry those of y besides.
TEST(ModelCFolds, AreTheClosedForms) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 1000; ++i) {
    const double lambda = std::pow(10, -8 * uniform(random));
    const double P = i % 2 ? -4.7 + 9.7 * uniform(random) : std::pow(10, -1 + 5 * uniform(random));
    const ClosedForm closed(lambda, P);
    const auto check = [&](const auto& curve, const Control& control, const Digits50& T, const Digits50& a) {
      const auto folds = find_folds(curve, control);
      const std::string where = text<PapangeloCiavarella>({lambda}, P, control);
      ASSERT_EQ(folds.size(), 1u) << where;
      EXPECT_TRUE(folds[0].place.maximum);
      expect_near(folds[0].T, T, 4e-15, "T " + where);
      expect_near(folds[0].A, truth::kPi * a * a, 1e-14, "A " + where);
      expect_near(folds[0].u, Digits50(3) / 4 * T / a, 1e-14, "u " + where);
    };
    const EquilibriumCurve<PapangeloCiavarella> curve({lambda}, P);
    const EquilibriumCurve<GeneralModelC> general({lambda}, P);
    check(curve, kLoad, closed.T_load, closed.a_load);
    check(curve, kDisplacement, closed.T_disp, closed.a_disp);
    check(general, kLoad, closed.T_load, closed.a_load);
    check(general, kDisplacement, closed.T_disp, closed.a_disp);
  }
}

/// The erratum: at the printed u_u (+ branch) the displacement is not stationary, on the minus branch it is.
TEST(ModelCFolds, TheDisplacementFoldLiesOnTheMinusBranchNotOnThePrintedOne) {
  for (const double lambda : {0.0023, 0.15, 1.0})
    for (const double P : {-4.0, -1.0, 0.0, 1.0, 5.0, 100.0}) {
      const ClosedForm closed(lambda, P);
      const auto slope = [&](const Digits50& a) {
        const Digits50 y = Digits50(4) / 3 * a * a * a - P;
        return printed_slope<PapangeloCiavarella>({lambda}, P, kDisplacement, y, closed.T_disp);
      };
      EXPECT_LT(abs(slope(closed.a_disp)), 1e-25) << lambda << ' ' << P;  // the error of the differences
      EXPECT_GT(abs(slope(closed.a_plus)), 0.01) << lambda << ' ' << P;
      const Fold fold = find_folds(EquilibriumCurve<PapangeloCiavarella>({lambda}, P), kDisplacement)[0];
      const double u_plus = static_cast<double>(Digits50(3) / 4 * closed.T_disp / closed.a_plus);
      EXPECT_GT(fold.u, 1.01 * u_plus) << lambda << ' ' << P;  // the largest u lies above what is printed
    }
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
      const std::string where = text<decltype(model)>(p, row.P, row.control);
      const auto folds = find_folds(EquilibriumCurve<decltype(model)>(p, row.P), row.control);
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
        const EquilibriumCurve<decltype(model)> curve(p, P);
        found += found.empty() ? "" : " ";
        for (const Control& control : {kLoad, kDisplacement, spring(0.1), spring(1), spring(10)})
          found += std::to_string(find_folds(curve, control).size());
      }
      EXPECT_EQ(found, row.folds) << row.model << ' ' << row.p0;
    });
  for (const double P : kTableLoads)
    for (const Control& control : {kLoad, kDisplacement, spring(0.1), spring(1), spring(10)}) {
      for (const double lambda : {0.0001, 0.0023, 0.15, 0.5, 0.95, 1.0})
        EXPECT_EQ(find_folds(EquilibriumCurve<PapangeloCiavarella>({lambda}, P), control).size(), 1u);
      for (const auto& p : {std::array{1.774, 2.284}, {1.5, 1.0}, {3.0, 2.5}, {0.7, 1.5}})
        EXPECT_EQ(find_folds(EquilibriumCurve<BenzeggaghKenane>(p, P), control).size(), 1u);
    }
}

/// All over the models: the states found lie on the printed curve, and what drives them is stationary there.
template <class Model>
void expect_stationary(const Parameters<Model>& p, double P, const Control& control, int& checked) {
  const EquilibriumCurve<Model> curve(p, P);
  double A = 1e300;
  for (const Fold& fold : find_folds(curve, control)) {
    const std::string where = text<Model>(p, P, control);
    const double y = fold.place.position.y;
    EXPECT_LT(fold.A, A) << where << ": not in the order of the curve";
    A = fold.A;
    const Digits50 residual = truth::residual_of<Model>(p, P, y, fold.T);
    EXPECT_LE(abs(residual), 1e-13 * 6 * truth::kPi * (y + std::abs(P))) << where;  // T to 1e-13
    // A to 1e-12 means y + P to 1.5e-12: a fold lies between places so far above and below.
    const double shift = 1.5e-12 * (y + P);
    if (!(y - shift > 0)) continue;
    const auto slope = [&](double at) {
      const double tau = std::sqrt(6 * pi<double>() * (at + P) - at * at);
      return printed_slope<Model>(p, P, control, at, tangential_load<Model>(p, at, tau));
    };
    EXPECT_LT(slope(y + shift) * slope(y - shift), 0) << where;
    ++checked;
  }
}

TEST(Folds, AreStationaryOnThePrintedCurve) {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> uniform(0, 1);
  int checked = 0;
  for (int i = 0; i < 300; ++i) {
    const double P = i % 2 ? -4.7 + 9.7 * uniform(random) : std::pow(10, -1 + 4 * uniform(random));
    const double small = std::pow(10, -8 * uniform(random));
    for (const Control& control : {kLoad, kDisplacement, spring(std::pow(10, -2 + 4 * uniform(random)))}) {
      expect_stationary<Johnson>({1 - small}, P, control, checked);
      expect_stationary<WatersGuduru>({i % 2 ? 2 * uniform(random) : 2 * small}, P, control, checked);
      expect_stationary<PapangeloCiavarella>({small}, P, control, checked);
      expect_stationary<BenzeggaghKenane>({1 + uniform(random), 2 + uniform(random)}, P, control, checked);
    }
  }
  EXPECT_GT(checked, 2000);
}

TEST(Folds, ThroughASpringTendToLoadAndDisplacementControl) {
  const auto check = [](const auto& curve) {
    const auto load = find_folds(curve, kLoad), displacement = find_folds(curve, kDisplacement);
    const auto soft = find_folds(curve, spring(1e-12)), stiff = find_folds(curve, spring(1e12));
    ASSERT_EQ(soft.size(), load.size());
    ASSERT_EQ(stiff.size(), displacement.size());
    // the difference is of first order in k and 1/k, with factors of order 10
    for (std::size_t i = 0; i < load.size(); ++i) EXPECT_NEAR(soft[i].A, load[i].A, 1e-10 * load[i].A);
    for (std::size_t i = 0; i < stiff.size(); ++i) EXPECT_NEAR(stiff[i].A, displacement[i].A, 1e-10 * stiff[i].A);
    const double at_k = find_folds(curve, spring(1e-4))[0].A, at_2k = find_folds(curve, spring(2e-4))[0].A;
    EXPECT_NEAR((load[0].A - at_2k) / (load[0].A - at_k), 2, 0.01);  // next order: 1e-4 of the first
  };
  for (const double P : {-4.0, -1.0, 0.0, 1.0, 5.0}) {
    check(EquilibriumCurve<PapangeloCiavarella>({0.15}, P));
    check(EquilibriumCurve<WatersGuduru>({0.15}, P));
    check(EquilibriumCurve<Johnson>({0.98}, P));
    check(EquilibriumCurve<BenzeggaghKenane>({1.774, 2.284}, P));
  }
}

/// Judges where a fold jumps to with the printed equation at the same T, u or u + T/k, as a function of y alone:
/// positive above the stable root. Counts what it saw.
template <class Model>
void judge_jumps(const Parameters<Model>& p, double P, const Control& control, int (&seen)[4]) {
  for (const Fold& fold : find_folds(EquilibriumCurve<Model>(p, P), control)) {
    const std::string where = text<Model>(p, P, control);
    ++seen[static_cast<int>(fold.jumps_to)];
    const Digits50 T_f = fold.T, y_f = fold.place.position.y, k = control.stiffness;
    const auto a_at = [&](const Digits50& y) { return cbrt(Digits50(Digits50(3) / 4 * (y + P))); };
    const auto share = [&](const Digits50& y) {  // v/T
      if (control.kind == Control::Kind::load) return Digits50(1);
      const Digits50 u = Digits50(3) / 4 / a_at(y);
      return control.kind == Control::Kind::displacement ? u : Digits50(u + 1 / k);
    };
    const auto residual = [&](const Digits50& y) {
      const Digits50 T = T_f * share(y_f) / share(y);
      return truth::residual_of<Model>(p, P, y, T);
    };
    EXPECT_EQ(fold.area_lost, fold.A - fold.area_after) << where;
    Digits50 y_after = P < 0 ? Digits50(-P) : Digits50(0);  // off contact; Hertz
    if (fold.jumps_to == Jump::off_contact) {
      EXPECT_LE(P, 0) << where;
      EXPECT_EQ(fold.area_after, 0) << where;
    } else if (fold.jumps_to == Jump::hertz) {
      EXPECT_GT(P, 0) << where;
      const Digits50 a = a_at(0);
      expect_near(fold.area_after, truth::kPi * a * a, 1e-15, "Hertz area " + where);
    } else {
      const Digits50 a = sqrt(Digits50(Digits50(fold.area_after) / truth::kPi)), sum = Digits50(4) / 3 * a * a * a;
      y_after = sum - P;
      // the area to 1e-10: T and u of the fold are known to 1e-13, magnified where the lower branch is steep
      EXPECT_LT(residual(y_after - 1.5e-10 * sum), 0) << where;
      EXPECT_GT(residual(y_after + 1.5e-10 * sum), 0) << where;
      EXPECT_EQ(fold.jumps_to == Jump::lower_branch, fold.place.maximum) << where;
      EXPECT_EQ(fold.jumps_to == Jump::lower_branch, fold.area_lost > 0) << where;
    }
    // no state in between that would hold the contact
    for (int i = 1; i < 40; ++i) {
      const Digits50 y = y_after + (y_f - y_after) * i / 40;
      EXPECT_EQ(residual(y) > 0, fold.place.maximum) << where << " at y " << y;
    }
  }
}

TEST(Jumps, LeadToTheNextStateAtTheSameControl) {
  std::mt19937_64 random(13);
  std::uniform_real_distribution<double> uniform(0, 1);
  int seen[4] = {};
  for (int i = 0; i < 120; ++i) {
    const double P = i % 3 ? -4.7 + 24 * uniform(random) : std::pow(10, 3 * uniform(random));
    for (const Control& control : {kLoad, kDisplacement, spring(std::pow(10, -2 + 4 * uniform(random)))}) {
      judge_jumps<Johnson>({1 - 0.2 * std::pow(10, -6 * uniform(random))}, P, control, seen);
      judge_jumps<WatersGuduru>({2 * uniform(random)}, P, control, seen);
      judge_jumps<PapangeloCiavarella>({uniform(random)}, P, control, seen);
      judge_jumps<BenzeggaghKenane>({1 + uniform(random), 2 + uniform(random)}, P, control, seen);
    }
  }
  for (const Jump jump : {Jump::hertz, Jump::lower_branch, Jump::upper_branch, Jump::off_contact})
    EXPECT_GT(seen[static_cast<int>(jump)], 20) << to_string(jump);
}

}  // namespace
}  // namespace mixity
