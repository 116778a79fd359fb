#include "report/figures/figure.h"

#include <array>
#include <utility>

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

namespace {

struct ModelStyle {
  Look line, symbol;
  std::size_t color;
};

/// The paper's models keep the paper's lines. Laws of the literature have one each; a law of the user's has one by its
/// name, the same in every figure. An ellipse looks like its circle.
ModelStyle style_of(std::string_view key) {
  using enum Look;
  static constexpr std::array<std::pair<std::string_view, ModelStyle>, 8> kKnown{
      {{"a", {dash_dot, triangles, 1}},
       {"b", {dashed, squares, 2}},
       {"c", {solid, circles, 0}},
       {"bk", {dash_dots, diamonds, 3}},
       {"power", {dashed, diamonds, 4}},
       {"linear", {solid, squares, 6}},
       {"quadratic", {dash_dot, circles, 5}},
       {"hutchinson_suo", {dash_dots, triangles, 2}}}};
  static constexpr std::array kOthers{ModelStyle{solid, diamonds, 3},   ModelStyle{dashed, squares, 6},
                                      ModelStyle{dash_dot, circles, 4}, ModelStyle{dash_dots, triangles, 5},
                                      ModelStyle{dashed, triangles, 3}, ModelStyle{dash_dot, diamonds, 6},
                                      ModelStyle{dash_dots, squares, 4}};
  key = key.substr(0, key.find("-ellipse"));
  for (const auto& [name, style] : kKnown)
    if (key == name) return style;
  std::size_t sum = 0;
  for (const char c : key) sum = 31 * sum + static_cast<unsigned char>(c);
  return kOthers[sum % kOthers.size()];
}

}  // namespace

Look model_line(std::string_view key) { return style_of(key).line; }

Look model_symbol(std::string_view key) { return style_of(key).symbol; }

std::string model_color(std::string_view key) { return color(style_of(key).color); }

}  // namespace mixity
