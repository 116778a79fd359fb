// Models of contacts whose approach is held (held_model.h). Reference values: the nearest states in 50 digits (mpmath),
// found as minima of the distance along the curve, and central differences of them.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "mechanics/contact.h"
#include "mechanics/contact_model.h"
#include "mechanics/held_approach.h"

namespace mixity {
namespace held_model_test {

constexpr double kNone = std::numeric_limits<double>::infinity();

ContactModel model(const char* key, double compliance = 0) {
  return ContactModel::find(key).value().at_held_approach(compliance);
}

/// The distance of one point, with its load unless sigma_P is infinite. Rows: in lambda, approach, compliance, T, A, P
/// and the logarithms of their errors.
struct Distance {
  double r[2]{};
  std::array<std::array<double, 2>, 9> slopes{};
  double place_T = 0, place_A = 0;
  bool found = false;
};

Distance distance(const ContactModel& of, double lambda, double approach, double T, double A, double P, double sigma_T,
                  double sigma_A, double sigma_P, double compliance = -1) {
  Distance d;
  std::vector<std::vector<double>> own(16, std::vector<double>(1));
  const std::vector<double> D{approach}, Ts{T}, As{A}, sTs{sigma_T}, sAs{sigma_A}, q{P}, sq{sigma_P}, slant{0},
      m{compliance};
  PlanePoints points{D, Ts, As, sTs, sAs};
  const bool loaded = std::isfinite(sigma_P);
  if (loaded) {
    points.q = q;
    points.sigma_q = sq;
    points.slant = slant;
  }
  if (compliance >= 0) points.compliance = m;
  CurveDistances out{own[0], own[1], own[2], own[3], own[4], own[5], own[6]};
  if (loaded) out.axes = {own[7], own[8], own[9], own[10], own[11], own[12], own[13], own[14], own[15]};
  std::vector<std::vector<double>> more(6, std::vector<double>(1));
  out.dm = more[0];
  if (loaded) {
    out.axes.dm = more[1];
    out.axes.of_q = more[2];
    out.axes.own_q = more[3];
    out.axes.of_sigma_q = more[4];
    out.axes.own_sigma_q = more[5];
  }
  d.found = of.curve_distances({&lambda, 1}, points, Search::global, true, out);
  const auto errors = [&](double slope, double sigma) { return -own[0][0] * slope * slope * sigma * sigma; };
  d.r[0] = own[0][0];
  d.r[1] = own[7][0];
  d.slopes = {{{own[4][0], own[11][0]},
               {own[1][0], own[8][0]},
               {more[0][0], more[1][0]},
               {own[2][0], own[9][0]},
               {own[3][0], own[10][0]},
               {more[2][0], more[3][0]},
               {loaded ? own[12][0] : errors(own[2][0], sigma_T), own[14][0]},
               {loaded ? own[13][0] : errors(own[3][0], sigma_A), own[15][0]},
               {more[4][0], more[5][0]}}};
  d.place_T = own[5][0];
  d.place_A = own[6][0];
  return d;
}

TEST(HeldModel, HasTheDistancesOfAReferenceSolutionAndTheirDerivatives) {
  struct Case {
    const char* model;
    double lambda, approach, compliance;
    struct {
      double T, A, P, sigma_T, sigma_A, sigma_P;
    } at;
    double r[2];
    double slopes[9][2];
  };
  const std::vector<Case> cases{
      {"c",
       0.15,
       5,
       0,
       {20, 28, 0, 1, 0.3, kNone},
       {2.6201664988180183, 0.0},
       {{-16.679994457668, 0.0},
        {11.9221220616172, 0.0},
        {-140.55779687816, 0.0},
        {-0.24249605896406, 0.0},
        {-3.23384130268718, 0.0},
        {0, 0},
        {-0.154077158019198, 0.0},
        {-2.46608934079882, 0.0},
        {0, 0}}},
      {"a",
       0.5,
       3,
       0.1,
       {12, 19.5, 3.5, 0.5, 0.2, 0.3},
       {2.56958797454025869, -1.80609670915679917},
       {{-16.0678917936487, 3.24861087635764},
        {13.492502744833, 8.650132750108},
        {-39.8837285713222, -25.5241419536873},
        {-0.872689095917478, 0.16160744380981},
        {-4.49889962697537, -0.196272530412223},
        {0.000205720341044142, -3.31985745829888},
        {-0.489060076664547, 0.193247871784009},
        {-2.0803058490577, -0.178674136443623},
        {-0.000222048818008329, 1.79152297381641}}},
      {"b",
       0.3,
       10,
       0,
       {40, 45, 38, 1, 0.5, 0.8},
       {-0.84936408092116577, 2.1251780673400702},
       {{-16.439540193483, 3.51067183959573},
        {7.10737564276158, 7.87115369244905},
        {-282.176556916119, -312.482095808351},
        {-0.206614217238878, 0.0445390304365952},
        {-1.95684508394186, -0.0187804731317739},
        {-1.85442125196148e-5, -1.24870440050406},
        {0.0363190959461411, -0.0198240708134926},
        {0.813107974851262, 0.0154209463836998},
        {-6.29898762373816e-5, -2.12077494291028}}},
      {"c",
       0.02,
       5,
       0.3,
       {41, 22.5, 4.6, 2, 0.4, 0.25},
       {2.11872431571112238, 2.47991833006111053},
       {{-84.784406896936, 24.2573055227532},
        {4.39482483743378, 7.03711429486179},
        {-22.9440770603402, -36.7238697750946},
        {-0.0813542396246922, 0.0230245250313835},
        {-2.4666869167358, -0.018857914947488},
        {-0.000195971625683902, -3.99564447416},
        {-0.0558524512650599, 0.0262866946234064},
        {-2.06262912205627, -0.0316844328051318},
        {-0.00024274238979642, -2.47452059187939}}},
      {"c",
       0.15,
       -0.5,
       0,
       {12.7, 4.4, -2.2, 0.4, 0.2, 0.3},
       {-1.75681932324330434, -0.473347218155943057},
       {{-94.6938451732719, -8.8696787064475},
        {14.5409709731369, 8.66373824937727},
        {34.1353839824041, 19.5631387246866},
        {-2.36017269879198, -0.23424882501735},
        {1.64920058305446, -1.3080540083229},
        {0.00838880879202063, -3.20365544591284},
        {1.56603972267655, 0.314056465786096},
        {0.193047151611559, -0.277901966239622},
        {-0.00226755104480248, 0.437192718609469}}},
  };
  for (const Case& one : cases)
    for (const double side : {1.0, -1.0}) {
      const auto& at = one.at;
      const Distance d = distance(model(one.model, one.compliance), one.lambda, one.approach, side * at.T, at.A, at.P,
                                  at.sigma_T, at.sigma_A, at.sigma_P);
      ASSERT_TRUE(d.found);
      // T/sigma_T and A/sigma_A are about 100, and rounded
      for (int k = 0; k < 2; ++k) EXPECT_NEAR(d.r[k], one.r[k], 1e-12) << one.model << one.approach << ' ' << k;
      for (std::size_t i = 0; i < d.slopes.size(); ++i)
        for (std::size_t k = 0; k < 2; ++k)
          // those of the law have a difference in their small part, of which 1e-9 remains
          EXPECT_NEAR(d.slopes[i][k], (i == 3 ? side : 1) * one.slopes[i][k],
                      (i == 0 && std::isfinite(at.sigma_P) ? 1e-9 : 1e-11) * (1 + std::abs(one.slopes[i][k])))
              << one.model << one.approach << " slope " << i << ' ' << k;
    }
}

/// Stiffness 0: Delta = m P with m -> infinity is a held load. Infinite: m = 0 is the limit of small m.
TEST(HeldModel, HasTheLimitsOfTheStiffness) {
  for (const char* key : {"a", "b", "c"})
    for (const double P : {-2.0, 3.0}) {
      const double lambda = 0.3, m = 1e15, T = 6, sT = 0.3, sA = 0.2;
      const ContactModel loaded = ContactModel::find(key).value();
      for (const double A : {0.7, 0.9, 1.1}) {
        std::vector<double> values(7);
        const std::vector<double> Ps{P}, Ts{T}, As{A * area_from_radius(jkr_radius(P))}, sTs{sT}, sAs{sA};
        const auto out_of = [&](std::size_t i) { return std::span(values).subspan(i, 1); };
        CurveDistances out{out_of(0), out_of(1), out_of(2), out_of(3), out_of(4), out_of(5), out_of(6)};
        ASSERT_TRUE(loaded.curve_distances({&lambda, 1}, {Ps, Ts, As, sTs, sAs}, Search::global, true, out));
        const Distance soft = distance(model(key, m), lambda, m * P, T, As[0], 0, sT, sA, kNone);
        ASSERT_TRUE(soft.found);
        EXPECT_NEAR(soft.r[0] / values[0], 1, 1e-12) << key << P << A;
        EXPECT_NEAR(soft.slopes[0][0] / values[4], 1, 1e-12);
        EXPECT_NEAR(soft.slopes[1][0] * m / values[1], 1, 1e-12);
        EXPECT_NEAR(soft.slopes[3][0] / values[2], 1, 1e-12);
        EXPECT_NEAR(soft.slopes[4][0] / values[3], 1, 1e-12);
        const double approach = 4;
        const Distance stiff = distance(model(key, 1e-16), lambda, approach, T, As[0], 0, sT, sA, kNone),
                       rigid = distance(model(key), lambda, approach, T, As[0], 0, sT, sA, kNone);
        EXPECT_NEAR(stiff.r[0] / rigid.r[0], 1, 1e-12);
      }
      for (const double T_near : {0.0, 2.0, 5.0}) {
        std::vector<double> A(2);
        std::vector<EquilibriumStatus> status(2);
        loaded.areas_at({&lambda, 1}, P, {&T_near, 1}, {A.data(), 1}, {status.data(), 1});
        model(key, m).areas_at({&lambda, 1}, m * P, {&T_near, 1}, {&A[1], 1}, {&status[1], 1});
        EXPECT_EQ(status[0], status[1]);
        EXPECT_NEAR(A[1] / A[0], 1, 1e-12);
      }
      for (const Control control :
           {Control{Control::Kind::load}, Control{Control::Kind::displacement}, Control{Control::Kind::stiffness, 2}}) {
        const auto of_load = loaded.folds({&lambda, 1}, P, control),
                   of_soft = model(key, m).folds({&lambda, 1}, m * P, control);
        ASSERT_EQ(of_load.size(), of_soft.size()) << key << P;
        for (std::size_t i = 0; i < of_load.size(); ++i) {
          EXPECT_NEAR(of_soft[i].T / of_load[i].T, 1, 1e-11) << key << P;
          EXPECT_NEAR(of_soft[i].A / of_load[i].A, 1, 1e-7);  // at the fold to the root of a rounding
          EXPECT_EQ(of_soft[i].jumps_to, of_load[i].jumps_to);
          EXPECT_NEAR(of_soft[i].area_after, of_load[i].area_after, 1e-11 * of_load[i].area_after);
        }
      }
    }
}

/// A point of the curve has distance 0; its residual of the load is that of the reading.
TEST(HeldModel, HasNoDistanceOnItsCurve) {
  const double lambda = 0.2, approach = 5, m = 0.2;
  for (const char* key : {"a", "b", "c"})
    for (const double T : {0.0, 1e-6, 5.0, 20.0}) {
      double A = 0;
      EquilibriumStatus status{};
      model(key, m).areas_at({&lambda, 1}, approach, {&T, 1}, {&A, 1}, {&status, 1});
      ASSERT_EQ(status, EquilibriumStatus::ok);
      const double P = HeldApproach{approach, m}.load(radius_from_area(A));
      const Distance d = distance(model(key, m), lambda, approach, T, A, P, 1, 0.1, 0.1);
      ASSERT_TRUE(d.found);
      for (const double r : d.r) EXPECT_NEAR(r, 0, 1e-11) << key << T;
      EXPECT_NEAR(d.place_A / A, 1, 1e-12);
    }
}

/// The compliance of a point replaces that of the model.
TEST(HeldModel, TakesTheComplianceOfEachPoint) {
  const Distance own = distance(model("b"), 0.3, 5, 10, 25, 4, 1, 0.3, 0.5, 0.4),
                 common = distance(model("b", 0.4), 0.3, 5, 10, 25, 4, 1, 0.3, 0.5);
  for (int k = 0; k < 2; ++k) EXPECT_EQ(own.r[k], common.r[k]);
}

/// Toughness of measured points, as under the load that their approach has.
TEST(HeldModel, DifferentiatesTheToughnessOfPoints) {
  const double lambda = 0.3, m = 0.1;
  const auto value = [&](double approach, double T, double A, std::vector<double>* slopes) {
    std::vector<double> values(5);
    const auto at = [&](std::size_t i) { return std::span(values).subspan(i, 1); };
    EXPECT_TRUE(model("b", m).toughness_residuals({&lambda, 1}, {&approach, 1}, {&T, 1}, {&A, 1},
                                                  {at(0), at(1), at(2), at(3), at(4)}));
    if (slopes) *slopes = values;
    return values[0];
  };
  std::vector<double> slopes;
  const double D = 5, T = 11, A = 21, e = 1e-5;
  value(D, T, A, &slopes);
  // central differences: rounding over the step, 1e-16/1e-5
  EXPECT_NEAR(slopes[1], (value(D + e, T, A, nullptr) - value(D - e, T, A, nullptr)) / (2 * e), 1e-9);
  EXPECT_NEAR(slopes[2], (value(D, T + e, A, nullptr) - value(D, T - e, A, nullptr)) / (2 * e), 1e-9);
  EXPECT_NEAR(slopes[3], (value(D, T, A + e, nullptr) - value(D, T, A - e, nullptr)) / (2 * e), 1e-9);
}

/// Models a with S-shaped curves jump to a lower branch, others to Hertz or off contact.
TEST(HeldModel, JumpsToTheNextStableState) {
  const double lambda = 0.15;
  const auto folds = [&](double approach) { return model("c").folds({&lambda, 1}, approach, {Control::Kind::load}); };
  ASSERT_EQ(folds(5).size(), 1u);
  EXPECT_EQ(folds(5)[0].jumps_to, Jump::hertz);
  EXPECT_NEAR(folds(5)[0].area_after, pi<double>() * 5, 1e-12);  // a^2 = Delta
  EXPECT_EQ(folds(-0.5)[0].jumps_to, Jump::off_contact);
  EXPECT_GT(folds(5)[0].T, 0);
  const auto later = model("c").folds({&lambda, 1}, 5, {Control::Kind::displacement});
  ASSERT_FALSE(later.empty());
  EXPECT_GT(later[0].u, folds(5)[0].u);  // a held displacement holds the contact longer
}

TEST(HeldModel, IsNeverNaNWithoutAStatus) {
  for (const char* key : {"a", "b", "c"})
    for (const double lambda : {0.0, 0.3, 1.0})
      for (const double approach : {-1e3, -0.9, -0.5, 0.0, 1e-3, 7.0, 1e6})
        for (const double compliance : {0.0, 0.1, 1e10})
          for (const double T : {0.0, 1.0, 1e4})
            for (const double A : {0.01, 10.0, 1e4}) {
              const Distance d = distance(model(key, compliance), lambda, approach, T, A, 1, 1, 1, 1);
              if (d.found) {
                EXPECT_TRUE(std::isfinite(d.r[0]) && std::isfinite(d.r[1]))
                    << key << lambda << ' ' << approach << ' ' << compliance;
                EXPECT_LE(std::abs(d.r[0]), 1e150);
              } else {
                // no contact, or one that vanishes
                EXPECT_TRUE(!model(key, compliance).in_contact(approach) || approach == 0 || lambda == 1)
                    << key << lambda << ' ' << approach << ' ' << compliance << ' ' << T << ' ' << A;
              }
              for (const Control::Kind kind : {Control::Kind::load, Control::Kind::displacement})
                for (const Fold& fold : model(key, compliance).folds({&lambda, 1}, approach, {kind}))
                  EXPECT_TRUE(std::isfinite(fold.T) && std::isfinite(fold.A) && std::isfinite(fold.area_after));
              for (const CurvePoint& q : model(key, compliance).curve({&lambda, 1}, approach, {}).points)
                EXPECT_TRUE(std::isfinite(q.T + q.A + q.u + q.dT));
            }
}

/// a(Delta) at a constant T: the state lies on the curve of its approach.
TEST(HeldModel, HasItsApproachAtConstantShear) {
  const double lambda = 0.3, T = 10, m = 0.2;
  const std::vector<double> y{10, 25, 25 + 1e-4};
  const auto points = model("c", m).at_constant_shear({&lambda, 1}, T, y);
  for (const auto& q : points) EXPECT_NEAR(HeldApproach({q.P, m}).edge_load(q.a).value / q.y, 1, 1e-13);
  EXPECT_NEAR((points[2].P - points[1].P) / 1e-4 / points[1].dP_dy, 1, 1e-5);
}

TEST(HeldModel, RefusesLawsWhoseShearTermDoesNotGrow) {
  const std::vector<double> p{0.3};
  EXPECT_TRUE(model("c").obstacle(p, 3).empty());
  EXPECT_FALSE(model("c").obstacle(p, std::nan("")).empty());
  EXPECT_FALSE(model("c").problem(p, -5).empty());
}

}  // namespace held_model_test
}  // namespace mixity
