// Golden sections: the lowest place of a function between two others.
#pragma once

#include <vector>

namespace mixity::stress {

struct Place {
  std::vector<double> x;
  double cost;
};

template <class F>
Place golden(const F& f, double low, double high, int steps) {
  constexpr double kGolden = 0.6180339887498949;
  double one = high - kGolden * (high - low), two = low + kGolden * (high - low), at_one = f(one), at_two = f(two);
  for (int i = 0; i < steps; ++i) {
    if (at_one < at_two) {
      high = two, two = one, at_two = at_one;
      at_one = f(one = high - kGolden * (high - low));
    } else {
      low = one, one = two, at_one = at_two;
      at_two = f(two = low + kGolden * (high - low));
    }
  }
  return at_one < at_two ? Place{{one}, at_one} : Place{{two}, at_two};
}

}  // namespace mixity::stress
