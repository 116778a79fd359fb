// Where the parts of a figure lie in its drawing, in units of 1/96 inch from the top left.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "report/figures/axis.h"
#include "report/figures/figure.h"

namespace mixity {

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
