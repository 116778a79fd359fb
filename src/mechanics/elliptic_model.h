// A model of elliptic contacts as a ContactModel: a law at the ends of both axes (ellipse.h), under the law's key with
// "-ellipse". Its parameters are those of the law for mode II, those for mode III (lambda_II, lambda_III), and
// Poisson's ratio. With "-ellipse-equal" the modes share their parameters.
//
// Each function implements the member of ContactModel with its name. An edge load is that of a circle of the same area:
// y = 4/3 (a b)^(3/2) - P.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mechanics/any_law.h"

namespace mixity {

struct EllipticModel {
  std::shared_ptr<const AnyLaw> circle;  // the law with circular contacts
  bool equal;                            // one set of parameters for both modes
  std::string key, name, formula;
  std::vector<std::string> names;
  std::vector<ParameterInfo> parameters;
  ModelInfo info;
};

/// The law of elliptic contacts under this key; null if the key has no such ending.
std::shared_ptr<const AnyLaw> elliptic_law(std::string_view key);

namespace elliptic {

EndParameters ends_of(const EllipticModel& model, ParameterSpan p);
std::string_view obstacle(const EllipticModel& model, ParameterSpan p, double P);
void make_continuous(const EllipticModel& model, std::span<double> p);
void areas(const EllipticModel& model, std::span<const Values> p, Values P, Values T, std::span<double> A,
           std::span<EquilibriumStatus> status);
void semi_axes(const EllipticModel& model, std::span<const Values> p, Values P, Values T, std::span<double> a,
               std::span<double> b);
void area_slopes(const EllipticModel& model, std::span<const Values> p, Values P, Values T, std::span<const double> A,
                 std::span<const std::span<double>> slopes);
void tangential_loads(const EllipticModel& model, std::span<const Values> p, Values P, Values A, std::span<double> T);
Equilibria equilibria(const EllipticModel& model, ParameterSpan p, double P, std::span<const double> T);
double first_stable_end(const EllipticModel& model, ParameterSpan p, double P);
std::vector<Fold> folds(const EllipticModel& model, ParameterSpan p, double P, Control control);
std::optional<EllipseBranchEnd> closing(const EllipticModel& model, ParameterSpan p, double P, Control control);
SampledCurve curve(const EllipticModel& model, ParameterSpan p, double P, const CurveSampling& sampling);
std::optional<double> shear_sensitivity(const EllipticModel& model, ParameterSpan p, double P);
bool curve_distances(const EllipticModel& model, ParameterSpan p, const PlanePoints& points, bool derivatives,
                     CurveDistances& out);

}  // namespace elliptic
}  // namespace mixity
