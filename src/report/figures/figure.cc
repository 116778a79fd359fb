#include "report/figures/figure.h"

#include <array>

namespace mixity {

Series band(const std::string& label, const std::string& color, Points low, const Points& high) {
  low.insert(low.end(), high.rbegin(), high.rend());
  return {label, Look::band, color, std::move(low)};
}

std::string color(std::size_t i) {
  static constexpr std::array kColors{"#000000", "#d55e00", "#0072b2", "#009e73",
                                      "#cc79a7", "#e69f00", "#56b4e9", "#7f7f7f"};
  return kColors[i % kColors.size()];
}

Look model_line(std::string_view key) {
  return key == "a" ? Look::dash_dot : key == "b" ? Look::dashed : key == "c" ? Look::solid : Look::dash_dots;
}

Look model_symbol(std::string_view key) {
  return key == "a" ? Look::triangles : key == "b" ? Look::squares : key == "c" ? Look::circles : Look::diamonds;
}

std::string model_color(std::string_view key) { return color(key == "a" ? 1 : key == "b" ? 2 : key == "c" ? 0 : 3); }

}  // namespace mixity
