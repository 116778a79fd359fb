// A mode-mixity model as a value: the only interface of the rooms above to the physics. Its law is published
// (models/*.h) or was defined at run time (laws/user_law.h). Arguments and results are arrays of dimensionless numbers
// (contact.h) and sets of parameters in the order of parameters().
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mechanics/base/parameter_values.h"
#include "mechanics/ellipse.h"
#include "mechanics/states.h"

namespace mixity {

class UserLaw;
struct AnyLaw;
struct HeldApproach;

/// A strided array: value i is i steps behind the first. With step 0, one value for all points.
struct Values {
  const double* first = nullptr;
  std::ptrdiff_t step = 0;
  double operator[](std::size_t i) const { return first[static_cast<std::ptrdiff_t>(i) * step]; }
};

/// Points in the layout that the vectorised loop of a one-parameter model reads.
struct PackedMixities {
  std::vector<double> first, second;
  std::size_t size() const { return first.size(); }
};

/// How a curve is sampled. even: uniformly in phi; fewest: with the fewest points whose chords stay within `chord` of
/// the curve; soonest: with three times as many, found a hundred times faster.
struct CurveSampling {
  enum class Rule { even, fewest, soonest } rule = Rule::even;
  std::size_t points = 101;        // even: for each range, at least two
  double chord = 2e-4;             // in the plane of T and A, each as a fraction of its range
  std::optional<double> T_most{};  // where a curve that runs to infinite T is cut; null: at ten times its natural scale
  bool first_range_only = false;   // of a curve in two pieces (model a, P < 0), only the one that starts from JKR
};

struct SampledCurve {
  std::vector<CurvePoint> points;
  bool uncoupled;  // shear does not affect the area, which is that of the one point at every T
};

struct Equilibria {
  std::vector<Equilibrium> at;
  std::optional<StableBranch> last;     // the last stable branch, set if a T lies beyond it
  std::optional<StableBranch> first{};  // of a held approach, the first one
};

/// Cheap to copy; may be used on several threads at once. Spans of parameters hold as many values as parameters().
class ContactModel {
 public:
  /// The published model with this key, or the law that was defined with it (define_law); with "-ellipse" or
  /// "-ellipse-equal" behind it, of elliptic contacts (elliptic_model.h). Null if there is none.
  static std::optional<ContactModel> find(std::string_view key);
  /// The same law with elliptic contacts, see elliptic_model.h; null if this model has them already. equal: with one
  /// set of parameters for modes II and III.
  std::shared_ptr<const AnyLaw> of_ellipses(bool equal) const;
  /// Whether contacts are ellipses (ellipse.h). Areas are then pi a b, edge loads those of a circle of the same area;
  /// the functions that say so do not know ellipses.
  bool is_elliptic() const;
  /// The same law with circular contacts; this model if its contacts are circles.
  ContactModel circle() const;
  /// The parameters at both ends, and the states' axes. Null for circles.
  std::optional<EndParameters> ends_of(std::span<const double> p) const;
  /// The same law for contacts whose approach is held by a machine with this compliance (held_approach.h), 0 if it is
  /// rigid. Whatever is called a load P below is then the approach; functions that do not know it are empty.
  ContactModel at_held_approach(double compliance) const;
  bool holds_approach() const;
  /// The same law under a held load.
  ContactModel of_loads() const;
  bool has_compliance() const;  // it holds an approach by a machine that is not rigid
  /// The contact at this approach, of a model that holds it.
  HeldApproach held_at(double approach) const;
  static const std::vector<ContactModel>& published();
  explicit ContactModel(std::shared_ptr<const UserLaw> law);

  const ModelInfo& info() const;
  std::span<const ParameterInfo> parameters() const;

  /// Why these parameters define no contact under the load P: a parameter out of its range, no unique equilibrium, or a
  /// load that is not a number. Empty if they do, and also if the load lies below pull-off (above_pull_off).
  std::string_view obstacle(std::span<const double> p, double P = 0) const;
  /// Like `obstacle`, but also reports a wrong number of parameters and a load below pull-off.
  std::string problem(std::span<const double> p, double P = 0) const;
  /// Whether there is a contact without shear: not below pull-off.
  bool in_contact(double P) const;
  /// The radius without shear, where there is a contact.
  double unsheared_radius(double P) const;
  /// The load at the radius a: P, or that of the approach P.
  double load(double P, double a) const;
  /// The state with a solved edge load y; its P is a load.
  ContactState state(double P, double T, double y) const;
  /// Replaces parameters at which curves change abruptly by the nearest ones at which they do not.
  void make_continuous(std::span<double> p) const;

  // ---- Arrays. Each point may have its own parameters: p has one Values for each parameter. Results are NaN if the
  // number of parameters is wrong. ----

  /// A[i] = pi a^2 and status[i] at the loads P[i] and T[i] (|T|: equilibrium depends on T^2), within 4e-15 of
  /// `equilibria`. A[i] is NaN exactly where status[i] is not ok: no_equilibrium beyond the last one, or below
  /// pull-off; invalid for parameters out of range and for loads that are not numbers. Neighbours with the same P and
  /// parameters are computed together.
  void areas(std::span<const Values> p, Values P, Values T, std::span<double> A,
             std::span<EquilibriumStatus> status) const;
  /// The semi-axes along and across the shear, with the same arguments; equal for circles, NaN where there is no area.
  void semi_axes(std::span<const Values> p, Values P, Values T, std::span<double> a, std::span<double> b) const;
  /// The same areas for one set of parameters and one load.
  void areas_at(std::span<const double> p, double P, std::span<const double> T, std::span<double> A,
                std::span<EquilibriumStatus> status) const;
  /// Derivatives of these areas: slopes[k][i] = dA[i]/d parameter k, each span as long as A. NaN where A[i] is NaN; not
  /// finite on a fold, like dA/dT.
  void area_slopes(std::span<const Values> p, Values P, Values T, std::span<const double> A,
                   std::span<const std::span<double>> slopes) const;
  /// f = G_c/G_Ic at phase angles psi [rad], 0..pi/2; NaN outside, and for parameters out of range. May be infinite at
  /// pi/2.
  void toughness_ratios(std::span<const Values> p, Values psi, std::span<double> f) const;
  /// The T >= 0 at which an equilibrium, stable or not, at the load P[i] has the area A[i]: on the stable branch the
  /// inverse of `areas`. NaN if there is none: A[i] is above JKR's area, not above Hertz's, or not reached at any
  /// finite T.
  void tangential_loads(std::span<const Values> p, Values P, Values A, std::span<double> T) const;

  // ---- One contact. Results are empty if obstacle(p, P) is not empty, or P is below pull-off. ----

  /// The state at each T of a contact that is loaded from T = 0 and follows its stable branch, and after a jump the
  /// lower one. 0 <= T <= kLargestLoad, else invalid. Relative error of the area below 4e-15 away from folds; towards a
  /// fold T_f it grows as eps/sqrt(1 - T/T_f).
  Equilibria equilibria(std::span<const double> p, double P, std::span<const double> T) const;
  /// T at which the stable branch that starts from JKR ends: infinite if the contact shrinks to an asymptote.
  double first_stable_end(std::span<const double> p, double P) const;
  /// All folds in order along the curve from T = 0. T is accurate to 1e-13, A and u to 1e-12.
  std::vector<Fold> folds(std::span<const double> p, double P, Control control) const;
  /// Where the edge of an elliptic contact closes before a fold under a control. Null if it does not, and for circles.
  std::optional<EllipseBranchEnd> closing(std::span<const double> p, double P, Control control) const;
  /// The regime for the strength tau0 > 0, or for unlimited strength if null. Null where there is no contact.
  std::optional<RegimeReport> regime(std::span<const double> p, double P, std::optional<double> tau0 = {}) const;
  SampledCurve curve(std::span<const double> p, double P, const CurveSampling& sampling) const;

  // ---- An elliptic contact ----

  /// Semi-axes at each T of a contact that is loaded from T = 0 and follows its stable branch. 0 <= T <= kLargestLoad;
  /// no_equilibrium beyond its end, or below pull-off; invalid for parameters out of range, a Poisson's ratio outside
  /// [0, 1/2], and laws whose tau does not grow with shear. Relative error of the axes below 1e-13 away from a fold.
  Ellipses ellipses(const EndParameters& parameters, double P, std::span<const double> T) const;
  /// Where the branch that is stable under a control ends, up to ten times the circle's natural scale of T. Null where
  /// it goes on. At a fold T, u and the area are accurate to 1e-12.
  std::optional<EllipseBranchEnd> ellipse_end(const EndParameters& parameters, double P, Control control) const;
  /// Derivatives of these states, which must be those of `ellipses` at the same arguments.
  EllipseSlopes ellipse_slopes(const EndParameters& parameters, double P, std::span<const double> T,
                               std::span<const EllipseState> at) const;

  // ---- The model itself ----

  /// The states at the tangential load T with these edge loads y > 0.
  std::vector<ConstantShearPoint> at_constant_shear(std::span<const double> p, double T,
                                                    std::span<const double> y) const;
  /// The lowest load of a contact at each shear that is held, 0 <= shear <= kMostPullOffShear, and its derivatives in
  /// the parameters (point after point), unless `gradient` is empty. Relative error of P below 1e-13, or of the edge
  /// load where that is larger. NaN for elliptic contacts.
  void pull_off(std::span<const double> p, HeldShear held, std::span<const double> shear, std::span<PullOff> out,
                std::span<double> gradient) const;
  /// The load below which the contact jumps: infinite if it jumps at every load, -3 pi/2 if at none. Null if
  /// obstacle(p) is not empty.
  std::optional<double> critical_load(std::span<const double> p) const;
  /// Boundaries between regimes in closed form; null if the model has none.
  std::optional<std::span<const RegimeBoundary>> regime_boundaries() const;
  /// alpha of A = A0 - alpha T^2 at small T for a contact with the area A0 at T = 0. Null at or below pull-off, and
  /// where the area does not fall with T^2.
  std::optional<double> shear_sensitivity(std::span<const double> p, double A0) const;

  // ---- Measured points, for fits ----

  /// ln f, and its derivatives in the parameters [n x parameters] unless `gradient` is empty, which may save time.
  void log_toughness(std::span<const double> p, std::span<const Mixity<double>> at, std::span<double> value,
                     std::span<double> gradient) const;
  /// Whether the model has a vectorised loop for ln f; it then has one parameter.
  bool has_packed_form() const;
  /// Appends points to packed ones; leaves them without such a loop.
  void pack(std::span<const Mixity<double>> at, PackedMixities& packed) const;
  /// ln f, its slope and its curvature in the parameter, at n points from number `begin` on. The absolute error of ln f
  /// is a few eps.
  void packed_log_toughness(double parameter, const PackedMixities& at, std::size_t begin, std::size_t n, double* value,
                            double* slope, double* curvature) const;
  /// T may have either sign. False if an area is not larger than Hertz's, where psi is not defined.
  bool toughness_residuals(std::span<const double> p, std::span<const double> P, std::span<const double> T,
                           std::span<const double> A, const ToughnessResiduals& out) const;
  /// Distances from the equilibrium curve of each point's load. Fills out.r, and if `derivatives` the other spans,
  /// which may be empty otherwise. Each result depends on its own point alone. False, with no usable results, if a
  /// point is invalid or has no curve (load below pull-off, law undefined for these parameters), if the nearest point
  /// of its curve is the contact that vanishes at P = 0, or if a result is not finite. Errors: of r a few roundings of
  /// T/sigma_T and A/sigma_A, of the derivatives about 1e-10.
  bool curve_distances(std::span<const double> p, const PlanePoints& points, Search search, bool derivatives,
                       CurveDistances& out) const;
  /// Distances of measured pull-off loads. False where one is not defined, and for elliptic contacts.
  bool pull_off_distances(std::span<const double> p, const PullOffPoints& points, const PullOffDistances& out) const;
  /// Distances from the law in the plane of G_I and G_II. A measured G_II < 0 is compared with the law's tangent at psi
  /// = 0.
  void energy_distances(std::span<const double> p, const EnergyPoints& points, const EnergyDistances& out) const;
  /// Unsigned distances, to a thousandth of the size of the law's curve.
  void rough_energy_distances(std::span<const double> p, const EnergyPoints& points, std::span<double> out) const;

 private:
  explicit ContactModel(std::shared_ptr<const AnyLaw> law);
  bool under_loads(std::span<const double> approach, std::span<const double> T, std::span<const double> A,
                   std::span<const double> p, const ToughnessResiduals& out) const;

  std::shared_ptr<const AnyLaw> law_;
};

/// Whether the model with this key is known and has elliptic contacts.
bool is_elliptic(std::string_view key);

}  // namespace mixity
