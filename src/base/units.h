// Physical units as experimenters write them: "mN", "mm^2", "mm2", "µm²", "mJ/m^2", "N/mm", "kPa", "deg", "%".
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/text.h"

namespace mixity {

/// Powers of newton, metre, radian, second and camera pixel. Pa = N/m^2, J/m^2 = N/m.
struct Dimension {
  int force = 0, length = 0, angle = 0, time = 0, pixel = 0;
  bool operator==(const Dimension&) const = default;
};

namespace dimension {
inline constexpr Dimension none{}, force{1, 0, 0}, length{0, 1, 0}, area{0, 2, 0}, stress{1, -2, 0},
    energy_per_area{1, -1, 0}, angle{0, 0, 1}, time{0, 0, 0, 1}, frequency{0, 0, 0, -1};
}

/// A unit and its size in SI (N, m, rad).
struct Unit {
  double factor = 1;
  Dimension dimension;
  std::string text;  // as written
};

/// Whether a text is the form of a clock: "hh:mm:ss", "HH:MM:SS.fff".
bool is_form_of_clock(std::string_view text);

/// Null if the text is not a unit; the form of a clock is one of time. m, N, Pa, J, rad, s and Hz may have an SI prefix
/// (p n u µ m c d k M G). Powers are written ^2, 2 or ², products with a space, '*' or '·'; '/' divides by the next
/// unit only. A power of ten may stand before it: "10^-3 N".
std::optional<Unit> parse_unit(std::string_view text);

/// The unit of this dimension that the text spells with other capitals: "MPa" for "Mpa"; of several, the one with the
/// fewest changes. Empty if there is none or a tie.
std::string with_other_capitals(std::string_view unit, const Dimension& wanted);

struct Quantity {
  double value = 0;  // in `unit`
  Unit unit;
  double si() const { return value * unit.factor; }
};

/// Reads "9.42 mm" or "9.42mm"; a bare number has no dimension. Null unless the text is a number, finite also in SI,
/// followed by nothing or a unit.
std::optional<Quantity> parse_quantity(std::string_view text);

/// A quantity with its standard error, in SI; the error is 0 (exact) if none is stated.
struct UncertainQuantity {
  Quantity quantity;
  double standard_error = 0;
};

/// Whether a text contains the sign of a standard error: "+/-", "+-" or "±".
bool states_error(std::string_view text);

/// Reads "2.133 +/- 0.1 MPa", "2.133 MPa +/- 0.1 MPa", "(2.133 +/- 0.1) MPa" or "2.133 MPa +/- 5%"; "+-" and "±" equal
/// "+/-". Null if the text is neither one of these nor a plain quantity, and if the error is negative, not finite, or a
/// percentage of 0.
std::optional<UncertainQuantity> parse_uncertain(std::string_view text);

/// The text in the place of a unit, of the value or its error, that is not one. Empty if there is none.
std::string_view unknown_unit(std::string_view text);

/// A unit for readers, and the factor from SI to it.
struct ReadableUnit {
  double factor;
  std::string unit;
};
/// Chosen by the size of `value`: MPa for Pa, mJ/m^2 for J/m^2, mm for m and so on; other units are unchanged.
ReadableUnit readable_unit(double value, const std::string& unit);

/// Reads a whole text as a number with a decimal point or comma, ignoring blanks around it. Null if it is not a number,
/// and for "2,133", whose comma may group thousands (two_readings); inf and nan are numbers. Quantities are alike.
std::optional<double> parse_number(std::string_view text);
/// The same with a decimal point only, as in fields of tables; false if the text is not a number.
bool parse_number(std::string_view text, double& value);

/// The possible meanings of a number with a comma before three digits: "\"2.133 MPa\" or \"2133 MPa\""; else empty.
std::string two_readings(std::string_view text);

/// The trimmed parts of a list of names and of NAME=NUMBER. A comma before a bare number, which cannot be a part, is a
/// decimal comma: "a=0,5,b" has two parts.
std::vector<std::string> split_assignments(std::string_view text);

/// A dimension in the words of messages: "a force such as mN".
std::string describe(const Dimension& dimension);

/// A common unit of this dimension: "mN"; empty if there is none.
std::string_view example_unit(const Dimension& dimension);

}  // namespace mixity
