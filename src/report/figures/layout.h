// The ranges and ticks of a figure's axes, and where its parts lie in the drawing, in units of 1/96 inch from the top
// left.
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

inline constexpr double kFont = 13, kTick = 4;
inline constexpr double kSample = 20, kSampleGap = 8;  // of the key: lines and symbols before the labels

/// From the values of an axis to its places.
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

/// Of a wide figure at the width of a page or, `narrow`, of a phone. No texts touch, as wide as label_width says.
Layout lay_out(const Figure& figure, bool narrow);

}  // namespace mixity
