#!/bin/sh
# Boost.Math 1.74 (Debian 12): the upper tail of chi^2 at a tiny chi^2.
#
# What we guessed: the probability of so small a chi^2 or a larger one is 1, whatever the degrees of freedom.
# What we saw: up to 3,508 degrees of freedom it is 1. From 3,510 on cdf(complement(chi_squared(freedom), 1e-20)) throws
# std::overflow_error from tgamma. A fit to exact data with as many points meets this.
# What we do: src/statistics/distributions.cc returns 1 where Chernoff's bound leaves less than a rounding.
set -eu
version=1.74.0+ds1-21
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -q "libboost1.74-dev=$version" >/dev/null
dpkg-deb -x libboost1.74-dev_*.deb .
cat >tail.cc <<'CODE'
#include <boost/math/distributions/chi_squared.hpp>
#include <cstdio>
#include <stdexcept>
int main() {
  for (const double freedom : {10.0, 3000.0, 3508.0, 3510.0, 4000.0}) {
    try {
      std::printf("%g %.17g\n", freedom, cdf(complement(boost::math::chi_squared(freedom), 1e-20)));
    } catch (const std::overflow_error&) {
      std::printf("%g overflow_error\n", freedom);
    }
  }
}
CODE
g++ -std=c++17 -isystem usr/include tail.cc -o tail
./tail >seen
cat seen
printf '%s\n' '10 1' '3000 1' '3508 1' '3510 overflow_error' '4000 overflow_error' | cmp - seen
