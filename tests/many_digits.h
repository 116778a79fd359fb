// Numbers of many digits, in which the truth is computed. By MPFR: what computes with a library compiles in two thirds
// of the time that arithmetic made of templates takes.
#pragma once

#include <boost/multiprecision/mpfr.hpp>

namespace mixity::truth {

template <unsigned n>
using Digits =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<n>, boost::multiprecision::et_off>;

using Digits50 = Digits<50>;

}  // namespace mixity::truth
