// The units of a data set's figures, which are those of its file.
#pragma once

#include <string>

#include "dataset/dataset.h"

namespace mixity {

/// Value in a figure = dimensionless * scale. Radii are in the square root of the unit of area, displacements in um.
/// For dimensionless data all scales are 1 and all units empty.
struct DrawnUnits {
  explicit DrawnUnits(const Dataset& data);

  double force, area, held, radius = 1, displacement = 1;  // held: of what is held, load or approach
  std::string force_unit, area_unit, held_unit, radius_unit, displacement_unit, held_name;

  // Axis labels: quantity and unit
  std::string P() const {
    return held_name == "P" ? with("P", force_unit, "/(R G_{Ic})") : with("δ", held_unit, " ξ^2/R");
  }
  std::string T() const { return with("T", force_unit, "/(R G_{Ic})"); }
  std::string A() const { return with("A", area_unit, " ξ^2/R^2"); }
  std::string a() const { return with("a", radius_unit, " ξ/R"); }
  std::string u() const { return with("u", displacement_unit, " ξ^2/R"); }

  static std::string with(const std::string& quantity, const std::string& unit, const std::string& dimensionless) {
    return unit.empty() ? quantity + dimensionless : quantity + " [" + unit + "]";
  }
};

/// "line 5, run 2: P = 2 mN, T = 5.1 mN, A = 0.298 mm^2, ψ = 17.8°, Gc/GIc = 1.2".
std::string point_hover(const Dataset& data, std::size_t i);

/// "0.31 mN", or "0.31" without a unit.
std::string with_unit(double value, int digits, const std::string& unit);

}  // namespace mixity
