// The ranges and ticks of a figure's axes, and the positions of its parts in units of 1/96 inch from the top left.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "report/figures/figure.h"

namespace mixity {

struct AxisRange {
  double low, high;  // low < high; both above 0 on a logarithmic axis
};

/// The range of an axis of the figure. An end that the axis does not state is slightly beyond the points and their
/// bars. Null if there is none.
std::optional<AxisRange> axis_range(const Figure& figure, bool x);

/// The smallest of 1, 2, 2.5 or 5 times a power of ten that divides `width` into at most `most` steps.
double tick_step(double width, int most);

/// Labelled positions of a logarithmic axis of at most two decades: 1, 2, 5 or, if those are fewer than three, every
/// digit. Empty if these are also fewer than three, and for more than two decades, where powers of ten are labelled.
std::vector<double> digit_ticks(const AxisRange& range);

struct Tick {
  double value;
  std::string label;  // empty: a small tick
};

/// All ticks in ascending order, with at most about `most` steps between labels.
std::vector<Tick> axis_ticks(const AxisRange& range, bool logarithmic, int most);

inline constexpr double kFont = 13, kTick = 4;
inline constexpr double kSample = 20, kSampleGap = 8;  // samples of lines and symbols before the labels of the key

/// Maps the values of an axis to positions in the drawing.
struct AxisScale {
  bool logarithmic = false;
  double origin = 0, factor = 0, from = 0;
  std::vector<Tick> ticks{};

  double of(double value) const { return from + factor * ((logarithmic ? std::log(value) : value) - origin); }
};

/// `x` is where the sample begins, `y` the middle of the line.
struct KeyEntry {
  std::string label;
  Look look;
  std::string color;
  double x = 0, y = 0;
};

struct Layout {
  int width, height;
  double left, right, top, bottom;  // of the frame
  AxisScale x{}, y{};
  std::vector<KeyEntry> key{};
  double title_x = 0, title_y = 0;  // of the key
};

/// Lays out a wide figure for the width of a page or, if `narrow`, of a phone. By label_width no texts touch.
Layout lay_out(const Figure& figure, bool narrow);

}  // namespace mixity
