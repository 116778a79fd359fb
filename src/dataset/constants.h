// Constants of the experiment, and how measured values are rescaled by them.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace mixity {

/// Constants of the experiment that may be fitted with a model's parameters, with or without a prior. Factors are
/// logarithms: toughness, modulus and radius relative to the data set's own values, area_scale of the areas, force_gain
/// of loads and shears. approach_offset is that of a held approach. Offsets are dimensionless and added to the
/// readings. Changes are numbers about 0 that act on some points more than on others, see PointPlace: modulus_drift and
/// toughness_drift, the change of the logarithm from the first to the last run; shape, the relative error of the radius
/// at a run's largest shear, read too large as the contact is not circular; hysteresis, the difference of the logarithm
/// of the toughness without shear.
enum Constant : std::size_t {
  kToughness,
  kModulus,
  kRadius,
  kAreaScale,
  kForceGain,
  kLoadOffset,
  kShearOffset,
  kAreaOffset,
  kApproachOffset,
  kModulusDrift,
  kToughnessDrift,
  kShape,
  kHysteresis
};
inline constexpr std::array<std::string_view, 13> kConstantNames{
    "toughness",   "modulus",         "radius",        "area_scale",      "force_gain", "load_offset", "shear_offset",
    "area_offset", "approach_offset", "modulus_drift", "toughness_drift", "shape",      "hysteresis"};
/// Values of all constants, and the convention of mode III that holds for the data, which is never fitted: the shear in
/// the equations of a contact is shear_weight times that of the experiment (Metadata::shear_weight). Values are
/// compared without it. The same goes for what is held, the load or the approach.
struct Constants : std::array<double, kConstantNames.size()> {
  double shear_weight = 1;
  bool approach_held = false;
};
inline constexpr std::array<Constant, kConstantNames.size()> kAllConstants{
    kToughness,  kModulus,        kRadius,       kAreaScale,      kForceGain, kLoadOffset, kShearOffset,
    kAreaOffset, kApproachOffset, kModulusDrift, kToughnessDrift, kShape,     kHysteresis};

constexpr bool is_factor(Constant c) { return c <= kForceGain; }
constexpr bool is_change(Constant c) { return c >= kModulusDrift; }
constexpr bool is_change(std::string_view name) {
  for (const Constant c : kAllConstants)
    if (is_change(c) && kConstantNames[c] == name) return true;
  return false;
}

/// Whether any change is not 0.
constexpr bool has_changes(const Constants& c) {
  return c[kModulusDrift] != 0 || c[kToughnessDrift] != 0 || c[kShape] != 0 || c[kHysteresis] != 0;
}

/// The position of a point in its experiment.
struct PointPlace {
  double order = 0;        // of its run: -1/2 for the first run of the file to 1/2 for the last
  double stretch = 0;      // (T over the largest of its run)^2, 0..1
  bool unsheared = false;  // T up to 1 % of the largest of its run
  /// Deviations of its run's constants from the common ones: logarithms for factors, differences for offsets.
  double log_force = 0, log_area = 0, load_offset = 0, shear_offset = 0, area_offset = 0;
  double log_approach = 0, log_compliance = 0, approach_offset = 0;

  bool has_own_constants() const {
    return log_force != 0 || log_area != 0 || load_offset != 0 || shear_offset != 0 || area_offset != 0 ||
           approach_offset != 0;
  }
  /// Adds `by` to a constant of its run, a factor or an offset.
  void shift(Constant c, double by) {
    if (c == kToughness || c == kRadius) log_force -= by;
    if (c == kForceGain) log_force += by;
    if (c == kLoadOffset) load_offset += by;
    if (c == kShearOffset) shear_offset += by;
    if (c == kAreaOffset) area_offset += by;
    if (c == kToughness) log_area -= 2.0 / 3 * by;
    if (c == kModulus) log_area += 2.0 / 3 * by;
    if (c == kRadius) log_area -= 4.0 / 3 * by;
    if (c == kAreaScale) log_area += by;
    if (c == kApproachOffset) approach_offset += by;
    if (c == kToughness) log_approach -= 2.0 / 3 * by;
    if (c == kModulus) log_approach += 2.0 / 3 * by;
    if (c == kRadius) log_approach -= 1.0 / 3 * by;
    if (c == kModulus || c == kRadius) log_compliance += 2.0 / 3 * by;
    if (c == kToughness) log_compliance += 1.0 / 3 * by;
  }
};

/// Converts measured values to the dimensionless units of the contact with these constants: forces by 1/(R G), areas by
/// (E R/G)^(2/3)/R^2, displacements by (E R/G)^(2/3)/R; shears and their displacements also by shear_weight. `held` is
/// that of what is held in the normal direction, of loads or of approaches, and the offset is its own. The compliance
/// of a machine grows by E^(2/3) R^(2/3) G^(1/3).
struct ConstantsScale {
  double force, shear_force, area, displacement, held, load_offset, shear_offset, area_offset, held_offset,
      compliance = 1;

  explicit ConstantsScale(const Constants& c, const PointPlace& place = {})
      : load_offset(c[kLoadOffset] + place.load_offset),
        shear_offset(c[kShearOffset] + place.shear_offset),
        area_offset(c[kAreaOffset] + place.area_offset) {
    const double modulus = c[kModulus] + place.order * c[kModulusDrift],
                 toughness = c[kToughness] + place.order * c[kToughnessDrift] + (place.unsheared ? c[kHysteresis] : 0);
    force = std::exp(c[kForceGain] - toughness - c[kRadius] + place.log_force);
    shear_force = c.shear_weight * force;
    area = std::exp(2.0 / 3 * (modulus - toughness - 2 * c[kRadius]) + c[kAreaScale] - 2 * place.stretch * c[kShape] +
                    place.log_area);
    displacement = c.shear_weight * std::exp(2.0 / 3 * (modulus - toughness + c[kRadius]) - c[kRadius]);
    held = force;
    held_offset = load_offset;
    if (!c.approach_held) return;
    held = std::exp(2.0 / 3 * (modulus - toughness + c[kRadius]) - c[kRadius] + place.log_approach);
    held_offset = c[kApproachOffset] + place.approach_offset;
    compliance = std::exp(2.0 / 3 * (modulus + c[kRadius]) + toughness / 3 + place.log_compliance);
  }

  /// Of the load, or of the approach where that is held.
  double load(double P) const { return (P + held_offset) * held; }
  /// Of a load that was measured beside a held approach.
  double load_beside(double P) const { return (P + load_offset) * force; }
  double shear(double T) const { return (T + shear_offset) * shear_force; }
  double true_area(double A) const { return (A + area_offset) * area; }
  double measured_load(double P) const { return P / held - held_offset; }
  double measured_shear(double T) const { return T / shear_force - shear_offset; }
  double measured_area(double A) const { return A / area - area_offset; }
};

}  // namespace mixity
