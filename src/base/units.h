// Physical units as experimenters write them: "mN", "mm^2", "mm2", "µm²", "mJ/m^2", "N/mm", "kPa", "deg", "%".
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/text.h"

namespace mixity {

/// Powers of newton, metre, radian, second and camera pixel; enough for contact mechanics (Pa = N/m^2, J/m^2 = N/m).
struct Dimension {
  int force = 0, length = 0, angle = 0, time = 0, pixel = 0;
  bool operator==(const Dimension&) const = default;
};

namespace dimension {
inline constexpr Dimension none{}, force{1, 0, 0}, length{0, 1, 0}, area{0, 2, 0}, stress{1, -2, 0},
    energy_per_area{1, -1, 0}, angle{0, 0, 1}, time{0, 0, 0, 1}, frequency{0, 0, 0, -1};
}

/// A unit and what one of it is in SI (N, m, rad).
struct Unit {
  double factor = 1;
  Dimension dimension;
  std::string text;  // as written
};

/// Null if the text is not a unit. An SI prefix (p n u µ m c d k M G) may stand before m, N, Pa, J, rad, s and Hz;
/// powers as ^2, 2 or ²; products by space, '*' or '·'; '/' divides by the one unit that follows it.
std::optional<Unit> parse_unit(std::string_view text);

/// The unit of this dimension that a text names with other capitals: "MPa" for "Mpa". Of several the one with the
/// fewest changes. Empty if there is none, or two such.
std::string with_other_capitals(std::string_view unit, const Dimension& wanted);

struct Quantity {
  double value = 0;  // in `unit`
  Unit unit;
  double si() const { return value * unit.factor; }
};

/// "9.42 mm" or "9.42mm"; a bare number has dimension none. Null if the text is not a finite number, in SI too,
/// followed by nothing or a unit.
std::optional<Quantity> parse_quantity(std::string_view text);

/// A quantity with its standard error, in SI; 0, or exact, if none is stated.
struct UncertainQuantity {
  Quantity quantity;
  double standard_error = 0;
};

/// Whether a text contains the sign of a standard error: "+/-", "+-" or "±".
bool states_error(std::string_view text);

/// "2.133 +/- 0.1 MPa", "2.133 MPa +/- 0.1 MPa", "(2.133 +/- 0.1) MPa", "2.133 MPa +/- 5%"; "+-" and "±" stand for
/// "+/-". Null if the text is none of these or a plain quantity, the error is negative or not finite, or is a
/// percentage of 0.
std::optional<UncertainQuantity> parse_uncertain(std::string_view text);

/// The text that stands for the unit of the value or of the error but is none. Empty if there is no such text.
std::string_view unknown_unit(std::string_view text);

/// A unit for readers, and the factor from SI to it.
struct ReadableUnit {
  double factor;
  std::string unit;
};
/// Chosen by the size of `value`: MPa for Pa, mJ/m^2 for J/m^2, mm for m and so on; other units stay.
ReadableUnit readable_unit(double value, const std::string& unit);

/// The whole text as one number, with a decimal point or comma, surrounding blanks allowed. Null if it is not a number,
/// and for "2,133", which may be a group of thousands (two_readings); inf and nan are numbers. So for quantities.
std::optional<double> parse_number(std::string_view text);
/// The same with a decimal point only, as fields of tables are read; false if the text is not a number.
bool parse_number(std::string_view text, double& value);

/// How a number with a comma before three digits may be meant: "\"2.133 MPa\" or \"2133 MPa\""; empty for others.
std::string two_readings(std::string_view text);

/// A dimension as messages name it: "a force such as mN".
std::string describe(const Dimension& dimension);

/// A unit of these in common use: "mN"; empty if there is none.
std::string_view example_unit(const Dimension& dimension);

}  // namespace mixity
