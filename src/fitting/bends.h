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

/// One normal load: where its branches end at a value of the parameter, and its points.
struct LoadEnds {
  std::function<std::vector<double>(double)> ends;  // tangential loads
  std::vector<double> shears;                       // of the points
  std::vector<std::size_t> points;                  // their places among the residuals
};

/// Whether to look between place k and the next, where these points pass an end.
using WorthALook = std::function<bool(std::size_t k, const std::vector<std::size_t>& points)>;

/// The bends between those of the rising places that are worth a look, in order; between two of them a point passes an
/// end once at most. Stops when there are more than `most`.
std::vector<Bend> find_bends(std::span<const LoadEnds> loads, std::span<const double> places, std::size_t most,
                             const WorthALook& worth);

/// Values between a bend, on the side of its root, and the next such that a parabola in the root shows where it dips
/// below the bend, down to a millionth of the way.
std::vector<double> dip_places(double bend, double other);

}  // namespace mixity
