// Numbers as text: exact, or rounded for a reader.
#pragma once

#include <string>

namespace mixity {

/// The shortest decimal text that reads back as exactly this (finite) double.
std::string shortest(double value);

/// The value without the rounding of a change of units, which moves 1.2 to 1.1999999999999997: the number of at most 12
/// digits that lies within a few roundings of it; the value itself if there is none.
double as_decimal(double value);

/// The value rounded to this many significant digits: 1.7e+03.
std::string significant(double value, int digits);

/// The same, without an exponent up to ten million: 1700.
std::string rounded(double value, int digits);

/// The same, but 0 for a rounding error of a difference of numbers of this size: below 1e-12 of it.
std::string rounded_difference(double value, double size, int digits);

/// A sum of squares in standard errors: chi^2. A millionth of a standard error is a rounding error.
std::string chi_squared_text(double chi_squared, int digits = 3);

/// The value with enough digits that a change by `resolution` changes the last but one.
std::string resolved(double value, double resolution);

/// A value and its standard error, rounded like the Particle Data Group: the error to two digits if its first three are
/// 100..354, else to one (950..999 becomes 1000), and the value to the same place.
struct RoundedToError {
  std::string value, error;
};
RoundedToError rounded_to_error(double value, double error);

/// A coefficient of determination with all its leading nines and two more digits, so that 0.9999 and 0.99994 differ.
std::string r2_text(double r2);

/// "T [mN]", or "T" for a dimensionless quantity.
std::string bracketed(const std::string& quantity, const std::string& unit);

/// " mN", or empty for a dimensionless quantity.
std::string unit_text(const std::string& unit);

}  // namespace mixity
