// A number with its first two derivatives along one direction. Evaluating an expression on such numbers gives exact
// derivatives.
#pragma once

#include <cmath>
#include <compare>
#include <type_traits>

namespace mixity {

struct Taylor {
  double value = 0, first = 0, second = 0;

  Taylor() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a constant is a number, too
  template <class Number>
  requires std::is_arithmetic_v<Number> Taylor(Number constant) : value(static_cast<double>(constant)) {}
  Taylor(double f, double slope, double bend) : value(f), first(slope), second(bend) {}
  explicit operator double() const { return value; }

  /// f(x) of a function whose value and derivatives at x are f, f' and f''. If x does not change along the direction,
  /// its derivatives are 0 even where f' is infinite.
  Taylor through(double f, double slope, double bend) const {
    if (first == 0) return {f, 0, second == 0 ? 0 : slope * second};
    return {f, slope * first, slope * second + bend * first * first};
  }

  Taylor& operator+=(const Taylor& other) { return *this = *this + other; }
  Taylor& operator-=(const Taylor& other) { return *this = *this - other; }
  Taylor& operator*=(const Taylor& other) { return *this = *this * other; }
  Taylor& operator/=(const Taylor& other) { return *this = *this / other; }

  friend Taylor operator+(const Taylor& x) { return x; }
  friend Taylor operator-(const Taylor& x) { return {-x.value, -x.first, -x.second}; }
  friend Taylor operator+(const Taylor& x, const Taylor& y) {
    return {x.value + y.value, x.first + y.first, x.second + y.second};
  }
  friend Taylor operator-(const Taylor& x, const Taylor& y) {
    return {x.value - y.value, x.first - y.first, x.second - y.second};
  }
  friend Taylor operator*(const Taylor& x, const Taylor& y) {
    return {x.value * y.value, x.first * y.value + x.value * y.first,
            x.second * y.value + 2 * x.first * y.first + x.value * y.second};
  }
  friend Taylor operator/(const Taylor& x, const Taylor& y) {
    const double inverse = 1 / y.value, value = x.value / y.value, first = (x.first - value * y.first) * inverse;
    return {value, first, (x.second - 2 * first * y.first - value * y.second) * inverse};
  }

  // Numbers are compared by value alone.
  friend bool operator==(const Taylor& x, const Taylor& y) { return x.value == y.value; }
  friend auto operator<=>(const Taylor& x, const Taylor& y) { return x.value <=> y.value; }

  friend Taylor exp(const Taylor& x) {
    const double e = std::exp(x.value);
    return x.through(e, e, e);
  }
  friend Taylor log(const Taylor& x) { return x.through(std::log(x.value), 1 / x.value, -1 / (x.value * x.value)); }
  friend Taylor sqrt(const Taylor& x) {
    const double root = std::sqrt(x.value);
    return x.through(root, 0.5 / root, -0.25 / (root * x.value));
  }
  friend Taylor sin(const Taylor& x) {
    const double s = std::sin(x.value);
    return x.through(s, std::cos(x.value), -s);
  }
  friend Taylor cos(const Taylor& x) {
    const double c = std::cos(x.value);
    return x.through(c, -std::sin(x.value), -c);
  }
  friend Taylor tan(const Taylor& x) {
    const double t = std::tan(x.value), slope = 1 + t * t;
    return x.through(t, slope, 2 * t * slope);
  }
  friend Taylor asin(const Taylor& x) {
    const double r = 1 / std::sqrt((1 - x.value) * (1 + x.value));
    return x.through(std::asin(x.value), r, x.value * r * r * r);
  }
  friend Taylor acos(const Taylor& x) {
    const double r = 1 / std::sqrt((1 - x.value) * (1 + x.value));
    return x.through(std::acos(x.value), -r, -x.value * r * r * r);
  }
  friend Taylor atan(const Taylor& x) {
    const double slope = 1 / (1 + x.value * x.value);
    return x.through(std::atan(x.value), slope, -2 * x.value * slope * slope);
  }
  friend Taylor sinh(const Taylor& x) {
    const double s = std::sinh(x.value);
    return x.through(s, std::cosh(x.value), s);
  }
  friend Taylor cosh(const Taylor& x) {
    const double c = std::cosh(x.value);
    return x.through(c, std::sinh(x.value), c);
  }
  friend Taylor tanh(const Taylor& x) {
    const double t = std::tanh(x.value), slope = 1 - t * t;
    return x.through(t, slope, -2 * t * slope);
  }
  friend Taylor abs(const Taylor& x) { return x.value < 0 ? -x : x; }
  friend Taylor pow(const Taylor& x, const Taylor& y) {
    const double power = std::pow(x.value, y.value), n = y.value;
    if (y.first == 0 && y.second == 0) {
      if (x.first == 0 && x.second == 0) return {power, 0, 0};
      if (x.value != 0 && power != 0 &&
          std::isfinite(power)) {  // from the one power: more calls of pow would cost more than all else
        const double slope = n * power / x.value;
        return x.through(power, slope, (n - 1) * slope / x.value);
      }
      return x.through(power, n == 0 ? 0 : n * std::pow(x.value, n - 1),
                       n == 0 || n == 1 ? 0 : n * (n - 1) * std::pow(x.value, n - 2));
    }
    if (x.value == 0 && n > 0) return {0, 0, 0};  // whatever the exponent's derivatives
    const Taylor exponent = y * log(x);
    return {power, power * exponent.first, power * (exponent.second + exponent.first * exponent.first)};
  }
};

}  // namespace mixity
