// A cube root in operations that compilers vectorise (std::cbrt is a call).
#pragma once

#include <bit>
#include <cstdint>

namespace mixity {

/// Cube root of x, 1e-150 < x < 1e300, to 2 ulp. Dividing the exponent bits by three gives a start within 5 %; each of
/// two Halley steps cubes the error, and a Newton step squares it.
inline double cube_root(double x) {
  constexpr std::uint64_t kMagic = 0x4330000000000000;  // 2^52 as a double: holds an integer in its low bits
  constexpr double kTwo52 = 4503599627370496.0;
  const double high = std::bit_cast<double>((std::bit_cast<std::uint64_t>(x) >> 32) | kMagic) - kTwo52;
  const double third = high * (1.0 / 3) + (kTwo52 + 715094163.0);
  double z = std::bit_cast<double>(std::bit_cast<std::uint64_t>(third) << 32);
  for (int i = 0; i < 2; ++i) {
    const double cube = z * z * z;
    z *= (cube + 2 * x) / (2 * cube + x);
  }
  return z - (z * z * z - x) / (3 * z * z);
}

}  // namespace mixity
