// What an axis of a figure spans and where it is labelled.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/figures/figure.h"

namespace mixity {

struct AxisRange {
  double low, high;  // low < high; both above 0 on a logarithmic axis
};

/// The stated ends; one that is not stated lies a little beyond the points and their bars. Null without any.
std::optional<AxisRange> axis_range(const Figure& figure, bool x);

/// 1, 2, 2.5 or 5 times a power of ten: the smallest that makes at most `most` steps of a width.
double tick_step(double width, int most);

/// Labelled positions of a logarithmic axis of at most two decades: 1, 2, 5 or, where those are few, every digit.
/// Empty where these are few, too, and beyond two decades, where powers of ten are labelled.
std::vector<double> digit_ticks(const AxisRange& range);

struct Tick {
  double value;
  std::string label;  // empty: a small one
};

/// All ticks by rising value, with at most some `most` steps between labels.
std::vector<Tick> axis_ticks(const AxisRange& range, bool logarithmic, int most);

}  // namespace mixity
