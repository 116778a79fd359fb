// The C library's vector forms of log, tan and atan, which compilers use by themselves only with -ffast-math. For
// sources with vectorised loops; these need -fno-math-errno -fno-trapping-math, which change no result.
#pragma once

#include <cmath>

#include "base/vector_loops.h"

#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__)
extern "C" {
__attribute__((simd("notinbranch"))) double log(double) noexcept;
__attribute__((simd("notinbranch"))) double tan(double) noexcept;
__attribute__((simd("notinbranch"))) double atan(double) noexcept;
}
#endif
