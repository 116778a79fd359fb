#include "report/figures/layout.h"

#include <algorithm>

#include "report/figures/svg_text.h"

namespace mixity {
namespace {

constexpr double kLine = 18, kEdge = 8;

std::vector<KeyEntry> key_entries(const Figure& figure) {
  std::vector<KeyEntry> key;
  for (const Series& series : figure.series)
    if (!series.label.empty() && !series.points.empty()) key.push_back({series.label, series.look, series.color});
  for (const auto& [label, look] : figure.key) key.push_back({label, look, color(0)});
  return key;
}

double width_of(const KeyEntry& entry) { return kSample + kSampleGap + label_width(entry.label, kFont); }

/// Places the key in lines above the frame, whose left is set; sets the frame's top. If there are several lines,
/// entries begin at equal steps, so that most of them are aligned.
void key_above(Layout& layout, const std::string& title) {
  if (layout.key.empty()) return;
  constexpr double kGap = 14;
  double whole = title.empty() ? 0 : label_width(title, kFont) + kGap;
  for (const KeyEntry& entry : layout.key) whole += width_of(entry) + kGap;
  const bool one_line = layout.left + whole < layout.width;
  const double left = one_line ? layout.left : kGap, step = one_line ? 1 : 30;
  double x = left, line = layout.top + 2;
  const auto after = [&](double width) { return step * std::ceil((width + (one_line ? kGap : 6)) / step); };
  layout.title_x = left;
  layout.title_y = line;
  if (!title.empty()) x += after(label_width(title, kFont));
  for (KeyEntry& entry : layout.key) {
    const double width = width_of(entry);
    if (x > left && x + width > layout.width - 6) {
      x = left;
      line += kLine;
    }
    entry.x = x;
    entry.y = line;
    x += after(width);
  }
  layout.top = line + kLine;
}

/// Places the key as a column that starts at the frame's top.
void key_column(Layout& layout, const std::string& title, double x) {
  double line = layout.top + 0.5 * kFont;
  layout.title_x = x;
  layout.title_y = line;
  if (!title.empty()) line += kLine;
  const double room = layout.bottom - line,
               step = std::min(kLine, room / static_cast<double>(std::max<std::size_t>(layout.key.size(), 1)));
  for (KeyEntry& entry : layout.key) {
    entry.x = x;
    entry.y = line;
    line += step;
  }
}

void fit(AxisScale& scale, const AxisRange& range, double first, double last) {
  const double low = scale.logarithmic ? std::log(range.low) : range.low,
               high = scale.logarithmic ? std::log(range.high) : range.high;
  scale.origin = low;
  scale.factor = (last - first) / (high - low);
  scale.from = first;
}

/// Where the frame has to end for the labels of x to stay in the drawing.
double right_for_labels(const Layout& layout) {
  double right = layout.right;
  for (const Tick& tick : layout.x.ticks) {
    const double share = (layout.x.of(tick.value) - layout.left) / (layout.right - layout.left);
    const double room = layout.width - 1 - 0.5 * label_width(tick.label, kFont) - layout.left;
    if (!tick.label.empty() && share > 0) right = std::min(right, layout.left + room / share);
  }
  return right;
}

/// Whether neighbouring labels would touch.
bool crowded(const AxisScale& scale) {
  double end = -1e9;
  for (const Tick& tick : scale.ticks) {
    if (tick.label.empty()) continue;
    const double half = 0.5 * label_width(tick.label, kFont), middle = scale.of(tick.value);
    if (middle - half < end + 4) return true;
    end = middle + half;
  }
  return false;
}

}  // namespace

Layout lay_out(const Figure& figure, bool narrow) {
  const bool wide = figure.wide && !narrow;
  Layout layout{wide ? 890 : 430, wide ? 400 : figure.wide ? 460 : 305, 0, 0, 12, 0};
  layout.key = key_entries(figure);
  double column = label_width(figure.key_title, kFont);
  for (const KeyEntry& entry : layout.key) column = std::max(column, width_of(entry));
  const bool inside = figure.key_place == KeyPlace::top_left,
             beside = figure.key_place == KeyPlace::beside && wide && column < 0.4 * layout.width;
  layout.right = layout.width - (beside ? column + 3 * kEdge : 18);
  layout.bottom = layout.height - kTick - 2 * kLine - 5;
  const auto x = axis_range(figure, true), y = axis_range(figure, false);
  layout.x.logarithmic = figure.x.logarithmic;
  layout.y.logarithmic = figure.y.logarithmic;
  double labels = 0;
  if (y) layout.y.ticks = axis_ticks(*y, figure.y.logarithmic, 6);
  for (const Tick& tick : layout.y.ticks) labels = std::max(labels, label_width(tick.label, kFont));
  layout.left = kLine + kEdge + labels + 6 + kTick;
  if (!beside && !inside) key_above(layout, figure.key_title);
  if (y) fit(layout.y, *y, layout.bottom, layout.top);
  for (int most = wide ? 10 : 6; x && most > 0; --most) {
    layout.x.ticks = axis_ticks(*x, figure.x.logarithmic, most);
    fit(layout.x, *x, layout.left, layout.right);
    if (!crowded(layout.x)) break;
  }
  if (x) {
    layout.right = right_for_labels(layout);
    fit(layout.x, *x, layout.left, layout.right);
  }
  if (beside || inside) key_column(layout, figure.key_title, beside ? layout.right + 2 * kEdge : layout.left + kEdge);
  return layout;
}

}  // namespace mixity
