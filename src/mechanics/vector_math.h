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

// Chooses at run time between vectors of four doubles (MIXITY_WIDE), if the processor has them, and of two.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define MIXITY_WIDE __attribute__((target("avx2")))
#define MIXITY_HAS_WIDE __builtin_cpu_supports("avx2")
#else
#define MIXITY_WIDE
#define MIXITY_HAS_WIDE false
#endif
// The same for one function, chosen at program start. Not with sanitizers, which are not ready by then.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define MIXITY_SIMD __attribute__((target_clones("avx2", "default")))
#else
#define MIXITY_SIMD
#endif
#define MIXITY_LOOP inline __attribute__((always_inline))
