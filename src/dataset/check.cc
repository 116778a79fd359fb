#include "dataset/check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include "base/number_text.h"
#include "statistics/drops.h"
#include "statistics/noise.h"

namespace mixity {
namespace {

using Lines = std::vector<std::string>;
using Curves = std::vector<CurveSummary>;

std::string times(std::size_t n) { return n == 1 ? "once" : std::to_string(n) + " times"; }

void check_units(const Curves& curves, Lines& odd) {
  double sum = 0, n = 0;
  for (const CurveSummary& curve : curves) {
    if (!curve.area_over_jkr) continue;
    const double power = std::log10(*curve.area_over_jkr);
    sum += power;
    ++n;
    if (std::abs(power) > 0.1 && std::abs(power) < 0.7)
      odd.push_back("run " + curve.name + ": the area at the smallest T is " + rounded(*curve.area_over_jkr, 3) +
                    " times that of JKR at this load");
  }
  const double mean = n > 0 ? sum / n : 0;
  if (std::abs(mean) >= 0.7)
    odd.push_back(
        "units: the areas at the smallest T are about 10^" + rounded(std::round(mean), 3) +
        " times those of JKR; a unit of A, P, radius, modulus or toughness is probably off by a power of ten");
}

void check_usable(const Dataset& data, Lines& odd) {
  if (data.points.empty() && data.pull_off.empty()) odd.push_back("no usable point is left");
  const BelowHertz below(data);
  if (below.points == 0) return;
  if (!below.most())
    odd.push_back("areas that do not exceed that of Hertz at their load (y <= 0): " + std::to_string(below.points) +
                  " of " + std::to_string(data.rows) + ", first in " + data.line_text(below.first_line) +
                  "; objective toughness leaves such points out");
  else
    odd.push_back("units: " + std::to_string(below.points) + " of " + std::to_string(data.rows) +
                  " areas do not exceed that of Hertz at their load; a unit of A, P, radius, modulus or toughness is "
                  "probably off by a power of ten");
}

bool in_contact(const Dataset& data, double P) {
  return data.holds_approach() ? HeldApproach{P, data.compliance}.unsheared().has_value() : above_pull_off(P) >= 0;
}
/// NaN without a contact.
double unsheared_radius(const Dataset& data, double P) {
  if (!data.holds_approach()) return jkr_radius(P);
  const auto radii = HeldApproach{P, data.compliance}.unsheared();
  return radii ? radii->stable : std::numeric_limits<double>::quiet_NaN();
}

/// A fit that needs standard errors rejects a file that states them only for some points.
void check_errors(const Dataset& data, Lines& odd) {
  const auto look = [&](std::string_view column, auto error_of) {
    std::size_t without = 0, first = 0;
    for (std::size_t i = 0; i < data.points.size(); ++i)
      if (error_of(i) < 0 && ++without == 1) first = data.points[i].line;
    if (without == data.points.size() && data.has_energies)
      odd.push_back(std::string(column) +
                    " is not stated where the error of the other energy is; a fit that needs both refuses the file");
    else if (without > 0 && without < data.points.size())
      odd.push_back(std::string(column) + " is empty at " + std::to_string(without) + " of " +
                    std::to_string(data.points.size()) + " points, first in " + data.line_text(first) +
                    "; a fit that needs it refuses the file");
  };
  if (data.errors.empty()) return;
  if (data.has_loads) {
    look("sigma_T", [&](std::size_t i) { return data.errors[i].T; });
    look("sigma_A", [&](std::size_t i) { return data.errors[i].A; });
  } else if (data.has_energies) {
    look("sigma_GI", [&](std::size_t i) { return data.energies[i].sigma_GI; });
    look("sigma_GII", [&](std::size_t i) { return data.energies[i].sigma_GII; });
  }
}

void check_order(const Dataset& data, const Curves& curves, Lines& odd) {
  constexpr double kNoise = 8;  // standard deviations: the range of a thousand readings of one value
  const auto runs = points_by_curve(data);
  const double unit = data.display.force_scale;
  for (std::size_t curve = 0; curve < runs.size(); ++curve) {
    std::vector<double> rising;  // noise about zero is not a run that rises or falls
    std::vector<const Point*> points;
    for (const std::size_t i : runs[curve])
      if (data.points[i].T >= 0) {
        rising.push_back(data.points[i].T);
        points.push_back(&data.points[i]);
      }
    const double least = curves[curve].T_min, most = curves[curve].T_max;
    if (most > 0 && -least > 0.1 * most)
      odd.push_back("run " + data.curves[curve] + ": T changes its sign, from " + rounded(least * unit, 4) + " to " +
                    rounded(most * unit, 4) + "; are runs of both directions mixed?");
    const double noise = noise_of(rising);
    const std::vector<Drop> found = drops(rising, 0, rising.size(), kNoise * noise);
    if (!found.empty())
      odd.push_back("run " + data.curves[curve] + ": T falls " + (noise > 0 ? "by more than its noise " : "") +
                    times(found.size()) + ", first at " + data.line_text(points[found.front().seen]->line) +
                    "; is unloading, slip or a second run mixed in?");
  }
}

/// Checks the unit of T by the phase angles and by the shear strength of the interface.
void check_shear_units(const Dataset& data, Lines& odd) {
  double most = 0;
  for (const Point& point : data.points) most = std::max(most, point.shear());
  if (!(most > 0)) return;
  const auto probably = [&](const std::string& what) {
    odd.push_back("units: " + what + "; the unit of T is probably off by a power of ten");
  };
  double smallest = 2, largest = 0;  // rad
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    const auto toughness = data.toughness(i);
    if (!toughness || data.points[i].shear() < 0.1 * most) continue;
    smallest = std::min(smallest, toughness->psi());
    largest = std::max(largest, toughness->psi());
  }
  constexpr double kHardly = 0.005, kWholly = 1.565;  // rad; of pi/2
  if (largest > 0 && largest < kHardly)
    probably("psi stays below " + rounded(kHardly, 1) + " rad, as if there were no shear");
  else if (largest > 0 && smallest > kWholly)
    probably("psi is above " + rounded(kWholly, 4) + " rad at all points with shear, as if there were no edge load");
  if (!data.contact || !data.metadata.shear_strength) return;
  double ratio = 0;  // T/(tau0 A)
  for (const Point& point : data.points)
    ratio = std::max(ratio, point.shear() * data.contact->force_unit() /
                                (*data.metadata.shear_strength * point.A * data.contact->area_unit()));
  if (ratio > 5)
    odd.push_back("units: T reaches " + rounded(ratio, 3) +
                  " times tau0 A, which would slide long before; a unit of T, A or shear_strength is probably off by a "
                  "power of ten");
  else if (ratio > 0 && ratio < 0.005)
    odd.push_back("units: T reaches only " + rounded(ratio, 2) +
                  " times tau0 A; a unit of T, A or shear_strength may be off by a power of ten");
}

void check_duplicates(const Dataset& data, Lines& odd) {
  const auto key = [&](std::size_t i) {
    if (data.has_energies) return std::tuple(data.energies[i].G_I, data.energies[i].G_II, 0.0);
    if (!data.has_loads)
      return std::tuple(data.converted[i].mixity.cos, data.converted[i].mixity.sin, data.converted[i].ratio);
    const Point& point = data.points[i];
    return std::tuple(point.P, point.T, point.A);
  };
  std::vector<std::size_t> order(data.points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return std::tuple(key(i), i) < std::tuple(key(j), j); });
  std::vector<std::pair<std::size_t, std::size_t>> repeats;  // a line, and the first line of equal values
  for (std::size_t k = 1, first = 0; k < order.size(); ++k)
    if (key(order[k]) == key(order[first]))
      repeats.emplace_back(data.points[order[k]].line, data.points[order[first]].line);
    else
      first = k;
  std::sort(repeats.begin(), repeats.end());
  for (const auto& [line, first] : repeats) odd.push_back(data.line_text(line) + " repeats " + data.line_text(first));
}

void check_loads(const Dataset& data, const Curves& curves, Lines& odd) {
  const auto single = std::count_if(curves.begin(), curves.end(), [](const CurveSummary& c) { return c.points == 1; });
  const bool many_single = single > 3 && 2 * static_cast<std::size_t>(single) > curves.size();
  if (many_single)
    odd.push_back(std::to_string(single) + " of " + std::to_string(curves.size()) +
                  " runs have one point; if P scatters within a run, name the runs in a column 'curve'");
  for (const CurveSummary& curve : curves) {
    if (many_single && curve.points == 1) continue;  // reported above
    if (curve.points < 3)
      odd.push_back("run " + curve.name + " has only " + std::to_string(curve.points) + " usable point" +
                    (curve.points == 1 ? "" : "s"));
    else if (!curve.area_over_jkr && in_contact(data, curve.P))
      odd.push_back("run " + curve.name + " has no point near T = 0 to compare with JKR");
    if (data.holds_approach() && !in_contact(data, curve.P))
      odd.push_back("run " + curve.name +
                    ": the approach lies below that of JKR pull-off; is its zero right (approach_offset)?");
    if (!data.holds_approach() && above_pull_off(curve.P) < 0)
      odd.push_back("run " + curve.name +
                    ": the load lies below the JKR pull-off load, -3 pi/2 R G_Ic; if the file has compression as "
                    "negative, its P are to be multiplied by -1");
  }
  const double unit = data.held_scale();
  for (const CurveSummary& curve : curves)
    if (curve.P_max - curve.P_min > 0.05 * std::max({std::abs(curve.P_min), std::abs(curve.P_max), 1.0}))
      odd.push_back("run " + curve.name + ": the " + data.held_word() + " varies from " +
                    rounded(curve.P_min * unit, 4) + " to " + rounded(curve.P_max * unit, 4) + " within the run");
  if (data.curves.size() == 1)
    odd.push_back("there is only one load, so a dependence of lambda on load cannot be detected");
}

void check_toughness(const Dataset& data, Lines& odd) {
  std::size_t too_wide = 0;
  for (const Excluded& excluded : data.excluded) too_wide += excluded.reason.starts_with("psi outside");
  if (too_wide > 0)
    odd.push_back("psi leaves 0..90 degrees " + times(too_wide) + "; is its unit rad where deg was meant?");
  for (std::size_t i = 0; i < data.points.size() && data.toughness_known; ++i) {
    const ToughnessPoint& point = data.converted[i];
    if (point.psi() < 0.05 && std::abs(std::log(point.ratio)) > 0.5)
      odd.push_back(data.line_text(data.points[i].line) + ": Gc/GIc is " + rounded(point.ratio, 3) +
                    " near psi = 0, where it must be 1; is toughness (G_Ic) right?");
  }
}

}  // namespace

std::vector<CurveSummary> summarise_curves(const Dataset& data) {
  if (!data.has_loads) return {};
  if (data.stated_constants() != Constants{}) return summarise_curves(corrected(data));
  std::vector<CurveSummary> curves(data.curves.size());
  std::vector<const Point*> unsheared(data.curves.size());  // per run: the point with the smallest |T|
  for (const Point& point : data.points) {
    CurveSummary& curve = curves[point.curve];
    if (curve.points++ == 0) {
      const auto [line, run, P, T, A] = point;
      curve = {data.curves[run], 1, P, P, P, T, T, A, A, {}};
      unsheared[run] = &point;
      continue;
    }
    curve.P_min = std::min(curve.P_min, point.P);
    curve.P_max = std::max(curve.P_max, point.P);
    curve.T_min = std::min(curve.T_min, point.T);
    curve.T_max = std::max(curve.T_max, point.T);
    curve.A_min = std::min(curve.A_min, point.A);
    curve.A_max = std::max(curve.A_max, point.A);
    if (point.shear() < unsheared[point.curve]->shear()) unsheared[point.curve] = &point;
  }
  for (std::size_t i = 0; i < curves.size(); ++i)
    if (unsheared[i] && in_contact(data, curves[i].P) &&
        unsheared[i]->shear() <= 0.1 * std::max(-curves[i].T_min, curves[i].T_max))
      curves[i].area_over_jkr = unsheared[i]->A / area_from_radius(unsheared_radius(data, unsheared[i]->P));
  return curves;
}

std::vector<std::string> find_oddities(const Dataset& data, Wording words) {
  if (data.stated_constants() != Constants{}) return find_oddities(corrected(data), words);
  Lines odd;
  check_usable(data, odd);
  if (data.has_loads) {
    const Curves curves = summarise_curves(data);
    check_units(curves, odd);
    if (std::none_of(odd.begin(), odd.end(), [](const std::string& one) { return one.starts_with("units"); }))
      check_shear_units(data, odd);
    check_order(data, curves, odd);
    check_loads(data, curves, odd);
  } else {
    check_toughness(data, odd);
  }
  check_errors(data, odd);
  check_duplicates(data, odd);
  for (const Message& note : data.notes) odd.push_back(note.text(words));
  for (const std::string& column : data.ignored_columns)
    if (std::none_of(data.notes.begin(), data.notes.end(),
                     [&](const Message& note) { return note.text().starts_with("column '" + column + "'"); }))
      odd.push_back("column '" + column + "' is not used");
  if (data.metadata.provenance == Provenance::unstated) odd.push_back("the provenance of the data is not stated");
  return odd;
}

}  // namespace mixity
