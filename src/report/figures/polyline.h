// Cuts lines and areas to a frame and removes points that make no visible difference.
#pragma once

#include <utility>
#include <vector>

namespace mixity {

using Point2 = std::pair<double, double>;
using Polyline = std::vector<Point2>;

/// The parts of a line within the rectangle; of a closed area one outline or none. Skips points that are not finite.
std::vector<Polyline> cut_to_frame(const Polyline& line, bool closed, Point2 low, Point2 high);

/// Without the points that lie within `tolerance` of the line that remains (Douglas & Peucker 1973).
Polyline simplified(const Polyline& line, double tolerance);

}  // namespace mixity
