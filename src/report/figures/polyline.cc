#include "report/figures/polyline.h"

#include <algorithm>
#include <cmath>

namespace mixity {
namespace {

/// The parts where `inside`, a linear function of the point, is at least 0.
template <class Inside>
std::vector<Polyline> cut(const std::vector<Polyline>& lines, bool closed, const Inside& inside) {
  std::vector<Polyline> kept;
  for (const Polyline& line : lines) {
    kept.emplace_back();
    for (std::size_t i = 0; i < line.size(); ++i) {
      const double here = inside(line[i]);
      if (i > 0 || closed) {
        const auto& [x, y] = line[i > 0 ? i - 1 : line.size() - 1];
        const double before = inside({x, y});
        if ((before < 0) != (here < 0)) {
          const double part = before / (before - here);
          kept.back().emplace_back(x + part * (line[i].first - x), y + part * (line[i].second - y));
          if (here < 0 && !closed) kept.emplace_back();
        }
      }
      if (here >= 0) kept.back().push_back(line[i]);
    }
  }
  std::erase_if(kept, [](const Polyline& line) { return line.size() < 2; });
  return kept;
}

}  // namespace

std::vector<Polyline> cut_to_frame(const Polyline& line, bool closed, Point2 low, Point2 high) {
  std::vector<Polyline> lines(1);
  for (const Point2& point : line)
    if (std::isfinite(point.first) && std::isfinite(point.second)) lines[0].push_back(point);
  lines = cut(lines, closed, [&](const Point2& p) { return p.first - low.first; });
  lines = cut(lines, closed, [&](const Point2& p) { return high.first - p.first; });
  lines = cut(lines, closed, [&](const Point2& p) { return p.second - low.second; });
  return cut(lines, closed, [&](const Point2& p) { return high.second - p.second; });
}

Polyline simplified(const Polyline& line, double tolerance) {
  if (line.size() < 3) return line;
  std::vector<char> keep(line.size());
  keep.front() = keep.back() = 1;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, line.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    const auto [x, y] = line[first];
    const double dx = line[last].first - x, dy = line[last].second - y, squared = dx * dx + dy * dy;
    double most = tolerance * tolerance;
    std::size_t farthest = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double px = line[i].first - x, py = line[i].second - y;
      const double along = squared > 0 ? std::clamp((px * dx + py * dy) / squared, 0.0, 1.0) : 0;
      const double off_x = px - along * dx, off_y = py - along * dy, off = off_x * off_x + off_y * off_y;
      if (off > most) {
        most = off;
        farthest = i;
      }
    }
    if (farthest == first) continue;
    keep[farthest] = 1;
    open.emplace_back(first, farthest);
    open.emplace_back(farthest, last);
  }
  Polyline kept;
  for (std::size_t i = 0; i < line.size(); ++i)
    if (keep[i]) kept.push_back(line[i]);
  return kept;
}

}  // namespace mixity
