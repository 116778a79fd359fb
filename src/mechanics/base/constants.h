// pi to about 60 digits for any scalar, and the pull-off load that depends on it.
#pragma once

namespace mixity {

namespace constants_detail {
/// pi minus the double nearest to it.
template <class S>
S pi_rest() {
  return (S(1.1124542208633657e-49) + S(-2.9947698097183397e-33)) + S(1.2246467991473532e-16);
}
}  // namespace constants_detail

/// pi as a sum of doubles: right to the last bit of whatever scalar S is (double, ceres::Jet, 50 digits).
template <class S>
S pi() {
  return constants_detail::pi_rest<S>() + S(3.141592653589793);
}

/// P + 3 pi/2, the distance from the JKR pull-off load -3 pi/2, below which no equilibrium exists. Accurate to
/// the last digit even where the sum cancels, because 3 pi/2 enters in two parts (1.5 times a double is exact here).
template <class S>
S above_pull_off(const S& P) {
  return (P + S(4.71238898038469)) + S(1.5) * constants_detail::pi_rest<S>();
}

}  // namespace mixity
