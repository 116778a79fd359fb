// A law under a held approach as a ContactModel (held_approach.h): under the law's own key, with its parameters. What
// the functions of ContactModel call the load P is then the approach Delta.
//
// Each function implements the member of ContactModel with its name.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "mechanics/any_law.h"
#include "mechanics/held_approach.h"

namespace mixity {

struct HeldModel {
  double compliance;  // of the machine; replaced by that of a point where points have their own
};

namespace held {

std::string_view obstacle(const AnyLaw& law, ParameterSpan p, double approach);
void areas(const AnyLaw& law, std::span<const Values> p, Values approach, Values T, std::span<double> A,
           std::span<EquilibriumStatus> status);
void area_slopes(const AnyLaw& law, std::span<const Values> p, Values approach, Values T, std::span<const double> A,
                 std::span<const std::span<double>> slopes);
void tangential_loads(const AnyLaw& law, std::span<const Values> p, Values approach, Values A, std::span<double> T);
Equilibria equilibria(const AnyLaw& law, ParameterSpan p, double approach, std::span<const double> T);
double first_stable_end(const AnyLaw& law, ParameterSpan p, double approach);
std::vector<Fold> folds(const AnyLaw& law, ParameterSpan p, double approach, Control control);
SampledCurve curve(const AnyLaw& law, ParameterSpan p, double approach, const CurveSampling& sampling);
std::vector<ConstantShearPoint> at_constant_shear(const AnyLaw& law, ParameterSpan p, double T,
                                                  std::span<const double> y);
std::optional<double> shear_sensitivity(const AnyLaw& law, ParameterSpan p, double A0);
bool curve_distances(const AnyLaw& law, ParameterSpan p, const PlanePoints& points, bool derivatives,
                     CurveDistances& out);

}  // namespace held
}  // namespace mixity
