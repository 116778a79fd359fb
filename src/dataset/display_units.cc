#include "dataset/display_units.h"

#include <cmath>
#include <numbers>

#include "base/number_text.h"
#include "base/units.h"

namespace mixity {

DrawnUnits::DrawnUnits(const Dataset& data)
    : force(data.display.force_scale),
      area(data.display.area_scale),
      held(data.held_scale()),
      force_unit(data.display.force),
      area_unit(data.display.area),
      held_unit(data.held_unit()),
      held_name(data.held_name()) {
  if (!data.contact) return;
  displacement_unit = "µm";
  displacement = data.contact->displacement_unit() * 1e6;
  // the unit whose square is the unit of area, if it is written as a square
  for (const char* square : {"^2", "²", "2"})
    if (area_unit.ends_with(square)) {
      radius_unit = area_unit.substr(0, area_unit.size() - std::string(square).size());
      break;
    }
  const auto unit = parse_unit(radius_unit);
  if (!unit || unit->dimension != dimension::length) radius_unit = "mm";
  radius = data.contact->length_unit() / parse_unit(radius_unit)->factor;
}

std::string with_unit(double value, int digits, const std::string& unit) {
  return rounded(value, digits) + unit_text(unit);
}

std::string point_hover(const Dataset& data, std::size_t i) {
  const Point& point = data.points[i];
  const DisplayUnits& units = data.display;
  std::string text = data.line_text(point.line);
  if (!data.curves[point.curve].empty()) text += ", run " + data.curves[point.curve];
  text += ": ";
  if (data.has_loads)
    text += std::string(data.held_name()) + " = " + with_unit(point.P * data.held_scale(), 5, data.held_unit()) +
            ", T = " + with_unit(point.T * units.force_scale, 5, units.force) +
            ", A = " + with_unit(point.A * units.area_scale, 5, units.area);
  if (const auto toughness = data.toughness(i))
    text += (data.has_loads ? ", ψ = " : "ψ = ") + rounded(toughness->psi() * 180 / std::numbers::pi, 4) +
            "°, Gc/GIc = " + rounded(toughness->ratio, 4);
  return text;
}

}  // namespace mixity
