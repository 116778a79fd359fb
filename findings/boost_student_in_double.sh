#!/bin/sh
# Boost.Math 1.74 (Debian 12): Student's distribution evaluated in double, without promotion to long double.
#
# What we guessed: both tails keep 1e-13 relative to the closed form everywhere; only speed differs.
# What we saw: with one degree of freedom cdf(t) is right to 1e-13 from |t| = 0.1 on, but at t = -1e-6, where it is
# nearly 1/2, it is wrong by more than 1e-11: the loss is at the middle of the distribution, not in its tail. Promoted to long
# double it is right there.
# What we do: src/statistics/distributions.cc takes doubles from |t| = 0.1 on, and long double below.
set -eu
version=1.74.0+ds1-21
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -q "libboost1.74-dev=$version" >/dev/null
dpkg-deb -x libboost1.74-dev_*.deb .
cat >student.cc <<'CODE'
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <cstdio>
namespace bm = boost::math;
using InDouble = bm::policies::policy<bm::policies::promote_double<false>>;
template <class Policy>
const char* error(double t) {
  const long double exact = std::atan2(1.0L, static_cast<long double>(t)) / std::acos(-1.0L);  // of one degree of freedom
  const double off = std::abs(static_cast<double>(cdf(bm::students_t_distribution<double, Policy>(1), -t) / exact - 1));
  return off < 1e-13 ? "right" : off > 1e-11 ? "off by more than 1e-11" : "between";
}
int main() {
  for (const double t : {1e-6, 0.1, 2.0, 1000.0})
    std::printf("%g in double: %s; promoted: %s\n", t, error<InDouble>(t), error<bm::policies::policy<>>(t));
}
CODE
g++ -std=c++17 -isystem usr/include student.cc -o student
./student >seen
cat seen
printf '%s\n' '1e-06 in double: off by more than 1e-11; promoted: right' '0.1 in double: right; promoted: right' \
  '2 in double: right; promoted: right' '1000 in double: right; promoted: right' | cmp - seen
