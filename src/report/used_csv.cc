#include "report/used_csv.h"

#include <algorithm>
#include <functional>

#include "base/number_text.h"

namespace mixity {

std::string used_csv(const Dataset& data) {
  const DisplayUnits& units = data.display;
  std::vector<std::pair<std::string, std::function<std::string(std::size_t)>>> columns;
  const auto add = [&](const std::string& name, const std::string& unit, auto value) {
    columns.emplace_back(name + (unit.empty() ? "" : " [" + unit + "]"), value);
  };
  const auto stated = [&](double PointErrors::*error) {
    return !data.errors.empty() && std::all_of(data.errors.begin(), data.errors.end(),
                                               [&](const PointErrors& one) { return one.*error != kNotStated; });
  };
  const auto point = [&](double Point::*value, double scale) {
    return [&data, value, scale](std::size_t i) { return shortest(data.points[i].*value * scale); };
  };
  const auto error = [&](double PointErrors::*value, double scale) {
    return [&data, value, scale](std::size_t i) { return shortest(data.errors[i].*value * scale); };
  };
  if (data.has_loads) {
    columns.emplace_back("curve", [&](std::size_t i) { return "run " + std::to_string(data.points[i].curve + 1); });
    add("P", units.force, point(&Point::P, units.force_scale));
    add("T", units.force, point(&Point::T, units.force_scale));
    add("A", units.area, point(&Point::A, units.area_scale));
    if (stated(&PointErrors::T)) add("sigma_T", units.force, error(&PointErrors::T, units.force_scale));
    if (stated(&PointErrors::A)) add("sigma_A", units.area, error(&PointErrors::A, units.area_scale));
  } else {
    add("psi", "rad", [&](std::size_t i) { return shortest(data.converted[i].psi()); });
    add("Gc_over_GIc", "", [&](std::size_t i) { return shortest(data.converted[i].ratio); });
  }
  std::string text;
  for (const auto& [heading, value] : columns) text += (text.empty() ? "" : ",") + heading;
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    text += '\n';
    for (const auto& column : columns) text += (&column == columns.data() ? "" : ",") + column.second(i);
  }
  return text + '\n';
}

}  // namespace mixity
