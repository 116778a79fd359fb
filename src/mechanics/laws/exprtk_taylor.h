// The number type that lets ExprTk evaluate expressions on Taylor numbers, and ExprTk without its unused parts.
#pragma once

#include <boost/preprocessor/seq/for_each.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include "mechanics/laws/taylor.h"

#define exprtk_disable_break_continue
#define exprtk_disable_comments
#define exprtk_disable_caseinsensitivity
#define exprtk_disable_enhanced_features
#define exprtk_disable_return_statement
#define exprtk_disable_rtl_io
#define exprtk_disable_rtl_io_file
#define exprtk_disable_rtl_vecops
#define exprtk_disable_sc_andor
#define exprtk_disable_string_capabilities
#define exprtk_disable_superscalar_unroll

namespace exprtk::details {
inline bool is_true(const mixity::Taylor& x) { return x.value != 0; }
inline bool is_false(const mixity::Taylor& x) { return x.value == 0; }
}  // namespace exprtk::details

#include <exprtk.hpp>

namespace mixity {

// The functions that ExprTk calls for this number type. Overload resolution finds them by the last argument.
struct TaylorTag {};

inline bool is_nan_impl(const Taylor& x, TaylorTag) { return std::isnan(x.value); }
inline int to_int32_impl(const Taylor& x, TaylorTag) { return static_cast<int>(x.value); }
inline long long to_int64_impl(const Taylor& x, TaylorTag) { return static_cast<long long>(x.value); }
inline bool is_integer_impl(const Taylor& x, TaylorTag) { return std::fmod(x.value, 1) == 0; }
inline Taylor const_pi_impl(TaylorTag) { return 3.141592653589793; }
inline Taylor const_e_impl(TaylorTag) { return 2.718281828459045; }
inline Taylor const_qnan_impl(TaylorTag) { return std::numeric_limits<double>::quiet_NaN(); }

#define MIXITY_ONE(name, value) \
  inline Taylor name##_impl(const Taylor& x, TaylorTag) { return value; }
#define MIXITY_TWO(name, value) \
  inline Taylor name##_impl(const Taylor& x, const Taylor& y, TaylorTag) { return value; }
MIXITY_ONE(abs, abs(x))
MIXITY_ONE(acos, acos(x))
MIXITY_ONE(asin, asin(x))
MIXITY_ONE(atan, atan(x))
MIXITY_ONE(cos, cos(x))
MIXITY_ONE(cosh, cosh(x))
MIXITY_ONE(exp, exp(x))
MIXITY_ONE(log, log(x))
MIXITY_ONE(neg, -x)
MIXITY_ONE(pos, x)
MIXITY_ONE(sin, sin(x))
MIXITY_ONE(sinh, sinh(x))
MIXITY_ONE(sqrt, sqrt(x))
MIXITY_ONE(tan, tan(x))
MIXITY_ONE(tanh, tanh(x))
MIXITY_TWO(min, y < x ? y : x)
MIXITY_TWO(max, x < y ? y : x)
MIXITY_TWO(pow, pow(x, y))
// ExprTk also requires these. They are never called, since no expression may name them.
#define MIXITY_NONE_OF_ONE(r, data, name) MIXITY_ONE(name, (static_cast<void>(x), const_qnan_impl(TaylorTag{})))
#define MIXITY_NONE_OF_TWO(r, data, name) \
  MIXITY_TWO(name, (static_cast<void>(x), static_cast<void>(y), const_qnan_impl(TaylorTag{})))
// clang-format off
BOOST_PP_SEQ_FOR_EACH(MIXITY_NONE_OF_ONE, ,
    (acosh)(asinh)(atanh)(ceil)(cot)(csc)(d2g)(d2r)(erf)(erfc)(expm1)(floor)(frac)(g2d)(log10)(log1p)(log2)(ncdf)
    (notl)(r2d)(round)(sec)(sgn)(sinc)(trunc))
BOOST_PP_SEQ_FOR_EACH(MIXITY_NONE_OF_TWO, ,
    (and)(atan2)(equal)(hypot)(logn)(modulus)(nand)(nequal)(nor)(or)(root)(roundn)(shl)(shr)(xnor)(xor))
// clang-format on

inline bool string_to_real(const char*& from, const char* end, Taylor& x, TaylorTag) {
  char* behind = nullptr;
  x = std::strtod(std::string(from, end).c_str(), &behind);
  from = end;
  return std::isfinite(x.value);
}

}  // namespace mixity

namespace exprtk::details::numeric::details {
template <>
struct number_type<mixity::Taylor> {
  using type = mixity::TaylorTag;
};
template <>
struct epsilon_type<mixity::Taylor> {
  static mixity::Taylor value() { return 1e-10; }
};
}  // namespace exprtk::details::numeric::details
