// Lines and areas cut to a frame and freed of points that nobody would see.
#pragma once

#include <utility>
#include <vector>

namespace mixity {

using Point2 = std::pair<double, double>;
using Polyline = std::vector<Point2>;

/// What lies within the rectangle: of a line its parts; of a closed area one outline, empty if nothing does. Points
/// that are not finite are left out.
std::vector<Polyline> cut_to_frame(const Polyline& line, bool closed, Point2 low, Point2 high);

/// Without the points that lie within `tolerance` of the line that remains (Douglas & Peucker 1973).
Polyline simplified(const Polyline& line, double tolerance);

}  // namespace mixity
