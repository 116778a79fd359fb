// Physical units as experimenters write them: "mN", "mm^2", "mm2", "µm²", "mJ/m^2", "N/mm", "kPa", "deg", "%".
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "dataset/trim.h"

namespace mixity {

/// Powers of newton, metre and radian; enough for contact mechanics (Pa = N/m^2, J/m^2 = N/m).
struct Dimension {
  int force = 0, length = 0, angle = 0;
  bool operator==(const Dimension&) const = default;
};

namespace dimension {
inline constexpr Dimension none{}, force{1, 0, 0}, length{0, 1, 0}, area{0, 2, 0}, stress{1, -2, 0},
    energy_per_area{1, -1, 0}, angle{0, 0, 1};
}

/// A unit and what one of it is in SI (N, m, rad).
struct Unit {
  double factor = 1;
  Dimension dimension;
  std::string text;  // as written
};

/// Null if the text is no unit. An SI prefix (p n u µ m c d k M G) may stand before m, N, Pa, J and rad;
/// powers as ^2, 2 or ²; products by space, '*' or '·'; '/' divides by the one unit that follows it.
std::optional<Unit> parse_unit(std::string_view text);

struct Quantity {
  double value = 0;  // in `unit`
  Unit unit;
  double si() const { return value * unit.factor; }
};

/// "9.42 mm" or "9.42mm"; a bare number has dimension none. Null if the text is not a finite number, in SI too,
/// followed by nothing or a unit.
std::optional<Quantity> parse_quantity(std::string_view text);

/// A whole field as one number, surrounding blanks allowed. Null if it is not; inf and nan are numbers here.
std::optional<double> parse_number(std::string_view text);
/// The same for files of millions of them; false if it is none.
bool parse_number(std::string_view text, double& value);

/// How a dimension is called in messages: "a force such as mN".
std::string describe(const Dimension& dimension);

}  // namespace mixity
