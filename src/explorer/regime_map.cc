#include "explorer/regime_map.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "explorer/drawing.h"

namespace mixity::explorer {
namespace {

constexpr int kLines = 96;
constexpr std::size_t kMostLines = 400;
constexpr double kFinest = 1.0 / 2048;  // of the axis: less than a pixel
constexpr double kLeap = 0.03;          // of the loads: by which a boundary may move from line to line

}  // namespace

RegimeMap::RegimeMap(const Json& request)
    : model_(model_of(request.at("model"))),
      parameters_(request.at("parameters").get<std::vector<double>>()),
      axis_(request.at("axis")),
      low_(request.at("low")),
      high_(request.at("high")),
      P_low_(request.at("P_low")),
      P_high_(request.at("P_high")),
      logarithmic_(request.at("logarithmic")) {
  if (axis_ >= parameters_.size() || model_.parameters().size() != parameters_.size() || !(low_ < high_) ||
      !(P_low_ < P_high_) || (logarithmic_ && !(low_ > 0)))
    throw std::invalid_argument("no map: a model, its parameters and two rising ends of each axis are wanted");
}

double RegimeMap::value_at(double part) const {
  if (part >= 1) return high_;
  return logarithmic_ ? low_ * std::pow(high_ / low_, part) : low_ + (high_ - low_) * part;
}

/// Along the loads: it jumps up to the critical one; what it does beyond changes at P = 0 alone, since Hertz is an area
/// of pressed contacts.
RegimeMap::Line RegimeMap::line(double part) const {
  std::vector<double> p = parameters_;
  p[axis_] = value_at(part);
  const auto critical = model_.critical_load(p);
  if (!critical) return {{std::nullopt, P_low_, P_high_}};
  const double end = std::clamp(*critical, P_low_, P_high_), pressed = std::clamp(0.0, end, P_high_);
  const double least = 1e-9 * (P_high_ - P_low_);
  Line found;
  const auto add = [&](double from, double to, bool jumps) {
    if (to - from <= least) return;
    std::optional<Regime> regime = Regime::jump;
    if (!jumps) {
      const auto report = model_.regime(p, 0.5 * (from + to));
      regime = report ? std::optional(report->regime) : std::nullopt;
    }
    if (!found.empty() && found.back().regime == regime)
      found.back().to = to;
    else
      found.push_back({regime, from, to});
  };
  add(P_low_, end, true);
  add(end, pressed, false);
  add(pressed, P_high_, false);
  return found;
}

bool RegimeMap::differ(const Line& one, const Line& other) const {
  return !std::equal(one.begin(), one.end(), other.begin(), other.end(),
                     [&](const RegimeExtent& a, const RegimeExtent& b) {
                       return a.regime == b.regime && std::abs(a.to - b.to) <= kLeap * (P_high_ - P_low_);
                     });
}

/// Where a line is wanted next; false: nowhere.
bool RegimeMap::next(double& part) const {
  if (lines_.size() <= kLines) {
    part = static_cast<double>(lines_.size()) / kLines;
    return true;
  }
  if (lines_.size() >= kMostLines) return false;
  for (auto here = lines_.begin(), behind = std::next(here); behind != lines_.end(); here = behind++)
    if (behind->first - here->first > kFinest && differ(here->second, behind->second)) {
      part = 0.5 * (here->first + behind->first);
      return true;
    }
  return false;
}

bool RegimeMap::go_on(double milliseconds) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  double part = 0;
  while (next(part)) {
    lines_[part] = line(part);
    if (std::chrono::duration<double, std::milli>(Clock::now() - begin).count() >= milliseconds) break;
  }
  return !next(part);
}

Json RegimeMap::regions() const {
  std::vector<double> places;
  std::vector<Line> lines;
  for (const auto& [part, line] : lines_) {
    places.push_back(part);
    lines.push_back(line);
  }
  Json all = Json::array();
  for (const RegimeRegion& region : connected_regions(places, lines)) {
    // what holds at one value alone, as at an end where nothing couples, has no area
    const auto ends = std::minmax_element(region.outline.begin(), region.outline.end());
    if (ends.second->first - ends.first->first <= 2 * kFinest) continue;
    Json outline = Json::array();
    for (const auto& [part, load] : region.outline) outline.push_back({load, value_at(part)});
    all.push_back(
        {{"regime", region.regime ? regime_text(*region.regime) : "no unique equilibrium"}, {"outline", outline}});
  }
  return all;
}

}  // namespace mixity::explorer
