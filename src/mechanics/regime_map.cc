#include "mechanics/regime_map.h"

#include <algorithm>
#include <cmath>
#include <list>
#include <stdexcept>

namespace mixity {
namespace {

constexpr int kLines = 96;  // minimum
constexpr std::size_t kMostLines = 400;
constexpr double kFinest = 1.0 / 2048;  // of an axis: less than a pixel
constexpr double kLeap = 0.03;          // of the loads: how far a boundary may move between lines

/// A region that grows line by line, stored as its lower and upper boundary.
struct Growing {
  std::optional<Regime> regime;
  std::vector<std::pair<double, double>> lower{}, upper{};  // as in RegimeRegion
  RegimeExtent last{};
  bool open = true;

  void add(double line, const RegimeExtent& extent) {
    lower.emplace_back(extent.from, line);
    upper.emplace_back(extent.to, line);
    last = extent;
  }
};

/// Adds an extent to a line, merging it with the last one if the regime is the same.
void append(std::vector<RegimeExtent>& line, const RegimeExtent& extent) {
  if (!line.empty() && line.back().regime == extent.regime)
    line.back().to = extent.to;
  else
    line.push_back(extent);
}

bool overlap(const RegimeExtent& one, const RegimeExtent& other) { return one.from < other.to && other.from < one.to; }

}  // namespace

const char* regime_text(Regime regime) {
  constexpr const char* kTexts[]{"shrinks, never to Hertz", "shrinks to Hertz", "jumps", "slides first"};
  return kTexts[static_cast<std::size_t>(regime) - 1];
}

std::vector<RegimeRegion> connected_regions(const std::vector<double>& coordinates,
                                            const std::vector<std::vector<RegimeExtent>>& lines) {
  std::list<Growing> all;
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    const double before = i > 0 ? 0.5 * (coordinates[i - 1] + coordinates[i]) : coordinates[0];
    std::vector<Growing*> grown;
    for (const RegimeExtent& extent : lines[i]) {
      const auto found = std::find_if(all.begin(), all.end(), [&](const Growing& region) {
        return region.open && region.regime == extent.regime && overlap(region.last, extent) &&
               std::find(grown.begin(), grown.end(), &region) == grown.end();
      });
      Growing& region = found != all.end() ? *found : all.emplace_back(Growing{extent.regime});
      if (found == all.end() && i > 0) region.add(before, extent);  // it begins between two lines
      region.add(coordinates[i], extent);
      grown.push_back(&region);
    }
    for (Growing& region : all)
      if (region.open && std::find(grown.begin(), grown.end(), &region) == grown.end()) {
        region.open = false;
        region.add(before, region.last);
      }
  }
  std::vector<RegimeRegion> regions;
  for (Growing& region : all) {
    region.lower.insert(region.lower.end(), region.upper.rbegin(), region.upper.rend());
    regions.push_back({region.regime, std::move(region.lower)});
  }
  return regions;
}

RegimeMap::RegimeMap(const ContactModel& model, std::span<const double> parameters, const RegimeMapFrame& frame,
                     std::optional<double> tau0)
    : model_(model), parameters_(parameters.begin(), parameters.end()), frame_(frame), tau0_(tau0) {
  if (frame.parameter >= parameters.size() || model.parameters().size() != parameters.size() ||
      !(frame.low < frame.high) || !(frame.P_low < frame.P_high) || (frame.logarithmic && !(frame.low > 0)))
    throw std::invalid_argument("no map: a model, its parameters and two rising ends of each axis are wanted");
}

double RegimeMap::value_at(double part) const {
  const auto& [parameter, low, high, logarithmic, P_low, P_high] = frame_;
  if (part >= 1) return high;
  return logarithmic ? low * std::pow(high / low, part) : low + (high - low) * part;
}

/// Beyond the critical load the regime changes only at P = 0, since Hertz contacts exist for P > 0 alone.
RegimeMap::Line RegimeMap::line(double part) const {
  std::vector<double> p = parameters_;
  p[frame_.parameter] = value_at(part);
  const auto critical = model_.critical_load(p);
  if (!critical) return {{std::nullopt, frame_.P_low, frame_.P_high}};
  const double end = std::clamp(*critical, frame_.P_low, frame_.P_high), pressed = std::clamp(0.0, end, frame_.P_high);
  const double least = 1e-9 * (frame_.P_high - frame_.P_low);
  Line found;
  const auto add = [&](double from, double to, bool jumps) {
    if (to - from <= least) return;
    std::optional<Regime> regime = Regime::jump;
    if (!jumps) {
      const auto report = model_.regime(p, 0.5 * (from + to));
      regime = report ? std::optional(report->regime) : std::nullopt;
    }
    append(found, {regime, from, to});
  };
  add(frame_.P_low, end, true);
  add(end, pressed, false);
  add(pressed, frame_.P_high, false);
  return tau0_ ? with_strength(p, found) : found;
}

/// T - tau0 A rises along the stable branch, because A falls: the branch reaches the strength if its end does.
bool RegimeMap::slides_first(std::span<const double> p, double P) const {
  const double end = model_.first_stable_end(p, P);
  if (std::isinf(end)) return true;
  const Equilibrium state = model_.equilibria(p, P, std::span(&end, 1)).at.front();
  return state.status == EquilibriumStatus::ok && end >= *tau0_ * area_from_edge_load(state.y, P);
}

RegimeMap::Line RegimeMap::with_strength(std::span<const double> p, const Line& fracture) const {
  constexpr double kStep = 1.0 / 12;  // of the loads
  const double whole = frame_.P_high - frame_.P_low;
  Line found;
  for (const RegimeExtent& extent : fracture) {
    const double length = extent.to - extent.from;
    const int steps = static_cast<int>(std::ceil(length / (kStep * whole)));
    const auto slides = [&](double P) { return extent.regime && slides_first(p, P); };
    const auto add = [&](double from, double to, bool slide) {
      append(found, {slide ? std::optional(Regime::strength) : extent.regime, from, to});
    };
    double begin = extent.from, before = extent.from + 1e-6 * length;
    bool slid = slides(before);
    for (int i = 1; i <= steps && extent.regime != Regime::asymptote; ++i) {
      const double next = extent.from + length * std::min(static_cast<double>(i) / steps, 1 - 1e-6);
      const bool slide = slides(next);
      if (slide != slid) {
        double low = before, high = next;
        while (high - low > kFinest * whole) {
          const double middle = 0.5 * (low + high);
          (slides(middle) == slid ? low : high) = middle;
        }
        add(begin, high, slid);
        begin = high;
      }
      before = next;
      slid = slide;
    }
    add(begin, extent.to, slid);
  }
  return found;
}

bool RegimeMap::differ(const Line& one, const Line& other) const {
  return !std::equal(one.begin(), one.end(), other.begin(), other.end(),
                     [&](const RegimeExtent& a, const RegimeExtent& b) {
                       return a.regime == b.regime && std::abs(a.to - b.to) <= kLeap * (frame_.P_high - frame_.P_low);
                     });
}

/// The place of the next line that is needed; null if there is none.
std::optional<double> RegimeMap::missing() const {
  if (lines_.size() <= kLines) return static_cast<double>(lines_.size()) / kLines;
  if (lines_.size() >= kMostLines) return std::nullopt;
  for (auto here = lines_.begin(), behind = std::next(here); behind != lines_.end(); here = behind++)
    if (behind->first - here->first > kFinest && differ(here->second, behind->second))
      return 0.5 * (here->first + behind->first);
  return std::nullopt;
}

bool RegimeMap::add_line() {
  const auto part = missing();
  if (part) lines_[*part] = line(*part);
  return part.has_value();
}

std::vector<RegimeRegion> RegimeMap::regions(bool slivers) const {
  std::vector<double> places;
  std::vector<Line> lines;
  for (const auto& [part, line] : lines_) {
    places.push_back(part);
    lines.push_back(line);
  }
  std::vector<RegimeRegion> regions = connected_regions(places, lines);
  if (!slivers)
    std::erase_if(regions, [](const RegimeRegion& region) {
      const auto [first, last] =
          std::minmax_element(region.outline.begin(), region.outline.end(),
                              [](const auto& one, const auto& other) { return one.second < other.second; });
      return last->second - first->second <= 2 * kFinest;
    });
  for (RegimeRegion& region : regions)
    for (auto& [load, part] : region.outline) part = value_at(part);
  return regions;
}

}  // namespace mixity
