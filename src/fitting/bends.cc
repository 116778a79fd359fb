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

}  // namespace

void find_bends(const std::function<std::vector<double>(double)>& ends, std::span<const double> shears,
                std::span<const std::size_t> points, std::span<const double> places, std::size_t most,
                std::vector<Bend>& bends) {
  std::vector<std::vector<double>> ends_at;
  for (const double x : places) ends_at.push_back(ends(x));
  for (std::size_t k = 0; k + 1 < places.size(); ++k)
    for (std::size_t i = 0; i < shears.size() && bends.size() <= most; ++i) {
      const double shear = shears[i];
      const std::size_t before = passed(ends_at[k], shear), behind = passed(ends_at[k + 1], shear);
      if (before == behind) continue;
      // where the last end passed on one side of the two is the load
      const std::size_t which = std::max(before, behind) - 1;
      const auto beyond = [&](double x) {
        std::vector<double> here = ends(x);
        if (here.size() <= which) return -shear;
        std::nth_element(here.begin(), here.begin() + static_cast<std::ptrdiff_t>(which), here.end());
        return shear - std::min(here[which], 1e300);
      };
      std::uintmax_t evaluations = 80;
      const auto [low, high] = boost::math::tools::toms748_solve(
          beyond, places[k], places[k + 1], beyond(places[k]), beyond(places[k + 1]),
          [](double one, double other) { return other - one <= 1e-15 * std::abs(other); }, evaluations);
      bends.push_back({0.5 * (low + high), behind > before, points[i]});
    }
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
