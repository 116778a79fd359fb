// The C library's vector forms of log, tan and atan, which compilers use by themselves only with -ffast-math. For
// sources with vectorised loops; these need -fno-math-errno -fno-trapping-math, which change no result.
#pragma once

#include <cmath>

#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__)
extern "C" {
__attribute__((simd("notinbranch"))) double log(double) noexcept;
__attribute__((simd("notinbranch"))) double tan(double) noexcept;
__attribute__((simd("notinbranch"))) double atan(double) noexcept;
}
#endif

#define MIXITY_LOOP inline __attribute__((always_inline))

namespace mixity {

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
// Each is compiled for its own vectors; `loop` and all that it calls is part of it.
template <class Loop>
[[gnu::flatten]] auto in_twos(const Loop& loop) {
  return loop();
}
template <class Loop>
[[gnu::flatten, gnu::target("avx2")]] auto in_fours(const Loop& loop) {
  return loop();
}
template <class Loop>
[[gnu::flatten, gnu::target("avx512f,avx512dq,avx512vl,prefer-vector-width=512")]] auto in_eights(const Loop& loop) {
  return loop();
}

/// Runs a loop over doubles in the widest vectors that the processor has: eight, four or two. The build allows no fused
/// multiply-add (-ffp-contract=off), so that the width changes no result but the last digits of vector forms above.
template <class Loop>
auto in_vectors(const Loop& loop) {
  if (__builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl")) return in_eights(loop);
  return __builtin_cpu_supports("avx2") ? in_fours(loop) : in_twos(loop);
}
#else
template <class Loop>
auto in_vectors(const Loop& loop) {
  return loop();
}
#endif

}  // namespace mixity
