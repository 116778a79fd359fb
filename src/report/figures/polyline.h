// Clips lines and areas to a frame and removes points that make no visible difference.
#pragma once

#include <utility>
#include <vector>

namespace mixity {

using Point2 = std::pair<double, double>;
using Polyline = std::vector<Point2>;

/// The parts of a line inside the rectangle; for a closed area at most one outline. Skips points that are not finite.
std::vector<Polyline> cut_to_frame(const Polyline& line, bool closed, Point2 low, Point2 high);

/// The line without points that lie within `tolerance` of what remains (Douglas & Peucker 1973).
Polyline simplified(const Polyline& line, double tolerance);

}  // namespace mixity
