// Runs loops over doubles in the widest vectors that the processor has. Sources of such loops need -fno-math-errno and
// -fno-trapping-math, which change no result.
#pragma once

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
/// multiply-add (-ffp-contract=off), so that the width changes no result but the last digits of vector forms of
/// functions.
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
