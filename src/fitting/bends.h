// Where the cost of areas bends: the values of the only free parameter at which a measured load is that of a fold.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace mixity {

/// Between two bends the cost is smooth; on the side from which a point comes to its fold its area is that of the fold
/// plus a square root of the distance, so that basins there may be as narrow as one likes.
struct Bend {
  double x;
  bool root_below;    // the point lies before its fold at values below x
  std::size_t point;  // its place among the residuals
};

/// Appends the bends of one normal load. `ends`: tangential loads at which its branches end, at a value of the
/// parameter; `shears` and `points`: loads of its points and their places; `places`: rising values, between two of
/// which a point passes an end once at most. Stops when there are more than `most`.
void find_bends(const std::function<std::vector<double>(double)>& ends, std::span<const double> shears,
                std::span<const std::size_t> points, std::span<const double> places, std::size_t most,
                std::vector<Bend>& bends);

/// Values between a bend, on the side of its root, and the next such that a parabola in the root shows where it dips
/// below the bend, down to a millionth of the way.
std::vector<double> dip_places(double bend, double other);

}  // namespace mixity
