#include "mechanics/batch.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace mixity::batch_detail {
namespace {

/// Cube root of x, 1e-150 < x < 1e300, to 2 ulp, in operations that compilers vectorise (std::cbrt is a call). A third
/// of the exponent's bits is within 5 %; two Halley steps and a Newton step cube, cube and square the error.
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

/// pi a^2 of 4/3 a^3 = load.
inline double area_of(double load) {
  const double a = cube_root(0.75 * load);
  return pi<double>() * a * a;
}

}  // namespace

// Four lanes where the processor has them, two elsewhere, chosen when the program starts.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define MIXITY_LANES __attribute__((target_clones("avx2", "default")))
#else
#define MIXITY_LANES
#endif

MIXITY_LANES void areas_from_loads(std::span<double> loads) {
  double* const load = loads.data();
  const std::size_t n = loads.size();
  for (std::size_t i = 0; i < n; ++i) load[i] = load[i] > 0 ? area_of(load[i]) : 0.0;
}

MIXITY_LANES std::size_t closed_form_areas(double root_lambda, double S0, double P, std::span<const double> T,
                                           std::span<double> areas) {
  const double centre = 3 * pi<double>();
  const double limit = S0 * (1 + std::numeric_limits<double>::epsilon());  // as LoadedContact::at
  const double* const in = T.data();
  double* const out = areas.data();
  const std::size_t n = T.size();
  double found = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double tau = root_lambda * in[i];
    const bool ok = (in[i] >= 0) & (in[i] <= kLargestLoad) & (tau <= limit);
    const double gap = S0 - tau;
    const double root = std::sqrt((ok & (gap > 0)) ? gap * (S0 + tau) : 0.0);
    out[i] = ok ? area_of(centre + root + P) : 0.0;
    found += ok ? 1.0 : 0.0;
  }
  return static_cast<std::size_t>(found);
}

}  // namespace mixity::batch_detail
