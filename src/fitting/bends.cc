#include "fitting/bends.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

namespace mixity {
namespace {

std::size_t passed(const std::vector<double>& ends, double shear) {
  return static_cast<std::size_t>(std::count_if(ends.begin(), ends.end(), [&](double end) { return shear > end; }));
}

/// Where the end that is number `which` from below is the load, between two values.
double passed_at(const LoadEnds& load, double shear, std::size_t which, double low, double high) {
  const auto beyond = [&](double x) {
    std::vector<double> here = load.ends(x);
    if (here.size() <= which) return -shear;
    std::nth_element(here.begin(), here.begin() + static_cast<std::ptrdiff_t>(which), here.end());
    return shear - std::min(here[which], 1e300);
  };
  std::uintmax_t evaluations = 80;
  const auto [from, to] = boost::math::tools::toms748_solve(
      beyond, low, high, beyond(low), beyond(high),
      [](double one, double other) { return other - one <= 1e-15 * std::abs(other); }, evaluations);
  return 0.5 * (from + to);
}

}  // namespace

std::vector<Bend> find_bends(std::span<const LoadEnds> loads, std::span<const double> places, std::size_t most,
                             const WorthALook& worth) {
  std::vector<std::vector<std::vector<double>>> ends(loads.size());  // by load and place
  for (std::size_t l = 0; l < loads.size(); ++l)
    for (const double x : places) ends[l].push_back(loads[l].ends(x));
  std::vector<Bend> bends;
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    // calls use(load, point, ends passed at the place and at the next) for the points that pass one in between
    const auto passing = [&](auto&& use) {
      for (std::size_t l = 0; l < loads.size(); ++l)
        for (std::size_t i = 0; i < loads[l].shears.size(); ++i) {
          const double shear = loads[l].shears[i];
          const std::size_t here = passed(ends[l][k], shear), there = passed(ends[l][k + 1], shear);
          if (here != there) use(loads[l], i, here, there);
        }
    };
    std::vector<std::size_t> points;
    passing([&](const LoadEnds& load, std::size_t i, auto, auto) { points.push_back(load.points[i]); });
    if (points.empty() || !worth(k, points)) continue;
    passing([&](const LoadEnds& load, std::size_t i, std::size_t here, std::size_t there) {
      if (bends.size() > most) return;
      const double x = passed_at(load, load.shears[i], std::max(here, there) - 1, places[k], places[k + 1]);
      bends.push_back({x, there > here, load.points[i]});
    });
  }
  std::sort(bends.begin(), bends.end(), [](const Bend& one, const Bend& other) { return one.x < other.x; });
  return bends;
}

std::vector<double> dip_places(double bend, double other) {
  // Fractions of the root in steps of 4, one of which meets the lower half of any parabola's dip below its end: the
  // least dip is a millionth of the root wide.
  constexpr double kShares[] = {0x1p-40, 0x1p-36, 0x1p-32, 0x1p-28, 0x1p-24, 0x1p-20,
                                0x1p-16, 0x1p-12, 0x1p-8,  0x1p-4,  0x1p-2,  0x1p-1};
  std::vector<double> places;
  for (const double share : kShares) places.push_back(bend + share * (other - bend));
  return places;
}

}  // namespace mixity
