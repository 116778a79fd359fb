// Places from which to descend: the local minima of a cost over grids of its parameters.
#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "fitting/least_squares.h"

namespace mixity {

/// A place from which to descend, its cost where that is known, and how low its basin may reach.
struct Start {
  std::vector<double> x;
  double reachable = -std::numeric_limits<double>::infinity();
  double cost = std::numeric_limits<double>::infinity();
};

struct Scan {
  std::vector<Start> minima;                                             // best first
  double lowest = std::numeric_limits<double>::infinity(), highest = 0;  // over the finite costs
  // Of one parameter whose cost bends, and all of whose bends were looked at: the places and their costs.
  std::vector<std::pair<double, double>> line{};
};

/// True if a point passes a fold within the box that has these places as opposite corners.
bool bends_between(const LeastSquares& problem, const std::vector<double>& one, const std::vector<double>& other);

/// The highest cost between two values of the only parameter, as far as the scan's line tells; infinite without one.
double barrier(const Scan& scan, double one, double other);

/// Over the whole range of the parameters without a start, the others at theirs. Where the cost is not finite there is
/// no place. `guesses` are places, too: of one parameter on its axis.
Scan scan(const LeastSquares& problem, const std::vector<std::vector<double>>& guesses = {});

/// Looks closer where the scan has no line: over a grid of each parameter by up to the part `reach` above and below x;
/// empty if no bend of the cost lies there, without which a basin is as wide as what surrounds it.
Scan scan_around(const LeastSquares& problem, const std::vector<double>& x, double reach);

/// The minima along the line between two places, in the logarithms of what is positive; none if no bend of the cost
/// lies between them.
std::vector<Start> scan_between(const LeastSquares& problem, const std::vector<double>& one,
                                const std::vector<double>& other);

}  // namespace mixity
