#include "analysis/readers_units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>

#include "base/units.h"
#include "dataset/constants.h"

namespace mixity {
namespace {

struct NamedUnit {
  const char* text;
  double factor;  // in SI
};
constexpr std::array kForces{NamedUnit{"kN", 1e3}, NamedUnit{"N", 1}, NamedUnit{"mN", 1e-3}, NamedUnit{"uN", 1e-6},
                             NamedUnit{"nN", 1e-9}};
constexpr std::array kAreas{NamedUnit{"m^2", 1}, NamedUnit{"mm^2", 1e-6}, NamedUnit{"um^2", 1e-12},
                            NamedUnit{"nm^2", 1e-18}};
constexpr std::array kLengths{NamedUnit{"m", 1}, NamedUnit{"mm", 1e-3}, NamedUnit{"um", 1e-6}, NamedUnit{"nm", 1e-9}};

/// By what a number in an old unit is multiplied, and the new one.
using Changes = std::map<std::string, ReadableUnit>;

/// Changes a unit of the display if its largest number is below `least` or above 10^4. `scale`: to this unit.
void choose(double largest, double least, std::span<const NamedUnit> units, std::string& unit, double& scale,
            Changes& changes) {
  const double shown = largest * scale;
  const auto written = parse_unit(unit);
  if (!written || !(shown > 0) || (shown >= least && shown < 1e4)) return;
  const double si = shown * written->factor;
  const auto found =
      std::find_if(units.begin(), units.end(), [&](const NamedUnit& one) { return si >= least * one.factor; });
  const NamedUnit& chosen = found == units.end() ? units.back() : *found;
  const ReadableUnit change{written->factor / chosen.factor, chosen.text};
  scale *= change.factor;
  changes.emplace(unit, change);
  unit = change.unit;
}

Changes change_units(const Dataset& data, DisplayUnits& units) {
  Changes changes;
  double force = 0, area = 0, held = 0, length = 0;
  for (const Point& point : data.points) {
    force = std::max({force, point.shear(), data.holds_approach() ? 0 : std::abs(point.P)});
    area = std::max(area, std::abs(point.A));
    held = std::max(held, std::abs(point.P));
  }
  for (const PullOffReading& one : data.pull_off) {
    force = std::max({force, std::abs(one.P), one.held == HeldShear::load ? std::abs(one.shear) : 0});
    if (one.held != HeldShear::load) length = std::max(length, std::abs(one.shear));
  }
  constexpr double kForce = 1, kLength = 1, kArea = 1e-3;  // of areas the units are 10^6 apart
  choose(force, kForce, kForces, units.force, units.force_scale, changes);
  choose(area, kArea, kAreas, units.area, units.area_scale, changes);
  if (data.holds_approach()) choose(held, kLength, kLengths, units.approach, units.approach_scale, changes);
  choose(length, kLength, kLengths, units.length, units.length_scale, changes);
  return changes;
}

/// Multiplies numbers in `unit`, which is changed, too.
class Change {
 public:
  Change() = default;
  Change(const Changes& changes, std::string& unit) {
    const auto found = changes.find(unit);
    if (unit.empty() || found == changes.end()) return;
    factor_ = found->second.factor;
    unit = found->second.unit;
  }
  void operator()(double& value) const { value *= factor_; }
  void operator()(std::optional<double>& value) const {
    if (value) *value *= factor_;
  }
  template <class... Values>
  void all(Values&... values) const {
    ((*this)(values), ...);
  }

 private:
  double factor_ = 1;
};

Change change(FittedParameter& one, const Changes& changes) {
  if (one.name == kConstantNames[kRadius]) return {};  // a length of another size, as it was written
  const Change by(changes, one.unit);
  by.all(one.value, one.stderr_, one.lower, one.upper);
  if (one.interval) by.all(one.interval->low, one.interval->high);
  if (one.bootstrap)
    by.all(one.bootstrap->low, one.bootstrap->high, one.bootstrap->standard_deviation, one.bootstrap->bias);
  if (one.prior) by.all(one.prior->mean, one.prior->standard_error);
  if (one.profile)
    for (auto& [x, rise] : one.profile->points) by(x);
  return by;
}

void change(FitResult& fit, const Changes& changes, double area) {
  std::vector<Change> of_free;
  for (FittedParameter& one : fit.parameters) {
    const Change by = change(one, changes);
    if (!one.held) of_free.push_back(by);
  }
  const auto change_each = [&](std::vector<double>& values) {
    for (std::size_t k = 0; k < std::min(values.size(), of_free.size()); ++k) of_free[k](values[k]);
  };
  if (fit.influence) {
    for (PointInfluence& point : fit.influence->points) change_each(point.change);
    for (std::vector<double>& run : fit.influence->runs) change_each(run);
  }
  if (fit.paper)
    for (FittedParameter& one : fit.paper->parameters) change(one, changes);
  for (Explanation& one : fit.explanations) change(one.first, changes);
  if (fit.area) {
    fit.area->rmse *= area;
    fit.area->max_abs_residual *= area;
  }
  if (fit.budget) {
    const Change of_parameter(changes, fit.budget->unit);
    for (ExactConstant& one : fit.budget->exact) {
      const Change by = one.constant == kConstantNames[kRadius] ? Change() : Change(changes, one.unit);
      of_parameter(one.effect);
      by(one.step);
      if (one.score) by(one.score->value);
    }
  }
  for (RunTest& one : fit.run_tests)
    if (!one.relative) {
      const Change by(changes, one.unit);
      by.all(one.all.size, one.odd.size, one.drift.size);
    }
}

}  // namespace

std::optional<Analysis> in_readers_units(const Analysis& result) {
  if (!result.data.contact) return std::nullopt;
  DisplayUnits units = result.data.display;
  const Changes changes = change_units(result.data, units);
  if (changes.empty()) return std::nullopt;
  const double area = units.area_scale / result.data.display.area_scale;
  Analysis shown = result;
  shown.data.display = units;
  for (FitResult& fit : shown.fits) change(fit, changes, area);
  for (PerCurve& one : shown.per_curve)
    for (CurveFit& run : one.curves) change(run.fit, changes, area);
  for (ComparedModel& one : shown.comparison)
    if (one.left_out) {
      one.left_out->rmse_area *= area;
      for (LeftOut::Run& run : one.left_out->runs) run.rmse_area *= area;
    }
  if (shown.unsheared)
    for (UnshearedTest::Implied& one : shown.unsheared->implied)
      Change(changes, one.unit).all(one.stated, one.value, one.standard_error);
  return shown;
}

}  // namespace mixity
