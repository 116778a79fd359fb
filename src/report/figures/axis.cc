#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "base/number_text.h"
#include "report/figures/layout.h"

namespace mixity {
namespace {

constexpr double kMargin = 0.04;  // of the span of the points, so that no symbol is cut

/// The range of the points and bars of a figure along one axis.
AxisRange span_of(const Figure& figure, bool x) {
  AxisRange span{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  const auto include = [&](double value) {
    span.low = std::min(span.low, value);
    span.high = std::max(span.high, value);
  };
  for (const Series& series : figure.series) {
    for (const auto& point : series.points) include(x ? point.first : point.second);
    for (const Bars& bars : series.bars) {
      include(x ? bars.x_low : bars.y_low);
      include(x ? bars.x_high : bars.y_high);
    }
  }
  return span;
}

/// 0.0025 or, for large and small values, 2.5×10^{−7}. `decimals`: number of decimals; -1: as many as the value needs.
std::string tick_label(double value, int decimals = -1) {
  char fixed[32];
  std::string text = rounded(value, 6);
  const std::size_t e = text.find('e');
  if (e != std::string::npos) {
    const std::string digits = text.substr(0, e);
    text = (digits == "1" ? "" : digits + "×") + "10^{" + std::to_string(std::stoi(text.substr(e + 1))) + '}';
  } else if (decimals >= 0) {
    text.assign(fixed, std::to_chars(fixed, fixed + sizeof fixed, value, std::chars_format::fixed, decimals).ptr);
  }
  for (std::size_t at = 0; (at = text.find('-', at)) != std::string::npos;) text.replace(at, 1, "−");
  return text;
}

std::vector<Tick> linear_ticks(const AxisRange& range, int most) {
  std::vector<Tick> ticks;
  const double step = tick_step(range.high - range.low, most), least = 1e-6 * step;
  int decimals = 0;
  for (double scaled = step; decimals < 9 && std::abs(scaled - std::round(scaled)) > 1e-6 * scaled; scaled *= 10)
    ++decimals;
  for (double i = std::ceil((range.low - least) / step); i * step <= range.high + least; ++i) {
    const double value = i * step + 0.0;  // no -0
    ticks.push_back({value, tick_label(value, decimals)});
  }
  return ticks;
}

std::vector<Tick> logarithmic_ticks(const AxisRange& range, int most) {
  const bool decades = range.high > 100 * range.low;
  const std::vector<double> labelled = digit_ticks(range);
  if (!decades && labelled.empty()) return linear_ticks(range, most);
  std::vector<Tick> ticks;
  const int first = static_cast<int>(std::floor(std::log10(range.low))),
            last = static_cast<int>(std::ceil(std::log10(range.high)));
  const int step = 1 + (last - first) / (most + 1);  // in decades
  for (int power = first; power <= last; ++power)
    for (int digit = 1; digit < (step == 1 ? 10 : 2); ++digit) {
      const double value = digit * std::pow(10.0, power);
      if (value < range.low * (1 - 1e-9) || value > range.high * (1 + 1e-9)) continue;
      const bool named = decades ? digit == 1 && power % step == 0
                                 : std::find(labelled.begin(), labelled.end(), value) != labelled.end();
      ticks.push_back({value, !named ? "" : decades ? "10^{" + tick_label(power) + '}' : tick_label(value)});
    }
  return ticks;
}

}  // namespace

std::optional<AxisRange> axis_range(const Figure& figure, bool x) {
  const Axis& axis = x ? figure.x : figure.y;
  const AxisRange span = span_of(figure, x);
  double low = axis.low.value_or(span.low), high = axis.high.value_or(span.high);
  if (!std::isfinite(low) || !std::isfinite(high) || (axis.logarithmic && !(low > 0))) return std::nullopt;
  const bool no_length = high - low <= 1e-9 * std::max(std::abs(low), std::abs(high));
  const double margin = no_length ? std::max(0.1 * std::abs(low), 1e-3) : kMargin * (high - low);
  if (!axis.low || no_length) low = axis.logarithmic ? low / 1.3 : low - margin;
  if (!axis.high || no_length) high = axis.logarithmic ? high * 1.3 : high + margin;
  return AxisRange{low, high};
}

double tick_step(double width, int most) {
  const double power = std::pow(10.0, std::floor(std::log10(width / most)));
  for (const double digit : {1.0, 2.0, 2.5, 5.0})
    if (width <= digit * power * most) return digit * power;
  return 10 * power;
}

std::vector<double> digit_ticks(const AxisRange& range) {
  if (range.high > 100 * range.low) return {};
  for (const auto& digits : {std::vector<int>{1, 2, 5}, std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8, 9}}) {
    std::vector<double> ticks;
    for (int power = static_cast<int>(std::floor(std::log10(range.low))); power <= std::log10(range.high); ++power)
      for (const int digit : digits) {
        const double value = digit * std::pow(10.0, power);
        if (value >= range.low && value <= range.high) ticks.push_back(value);
      }
    if (ticks.size() >= 3) return ticks;
  }
  return {};
}

std::vector<Tick> axis_ticks(const AxisRange& range, bool logarithmic, int most) {
  return logarithmic ? logarithmic_ticks(range, most) : linear_ticks(range, most);
}

}  // namespace mixity
