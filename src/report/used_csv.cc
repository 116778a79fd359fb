#include "report/used_csv.h"

#include <algorithm>

#include "report/csv_table.h"

namespace mixity {

std::string used_csv(const Dataset& data) {
  const DisplayUnits& units = data.display;
  CsvTable<std::size_t> column;
  const auto measured = [&](const char* name, const std::string& unit, double Point::*value, double scale) {
    column.quantity(name, unit, [&data, value, scale](std::size_t i) { return data.points[i].*value * scale; });
  };
  const auto stated = [&](const char* name, const std::string& unit, double PointErrors::*value, double scale) {
    const auto is_stated = [&](const PointErrors& errors) { return errors.*value != kNotStated; };
    if (!data.errors.empty() && std::all_of(data.errors.begin(), data.errors.end(), is_stated))
      column.quantity(name, unit, [&data, value, scale](std::size_t i) { return data.errors[i].*value * scale; });
  };
  if (data.has_loads) {
    column("curve", [&](std::size_t i) { return "run " + std::to_string(data.points[i].curve + 1); });
    measured("P", units.force, &Point::P, units.force_scale);
    measured("T", units.force, &Point::T, units.force_scale);
    measured("A", units.area, &Point::A, units.area_scale);
    stated("sigma_T", units.force, &PointErrors::T, units.force_scale);
    stated("sigma_A", units.area, &PointErrors::A, units.area_scale);
  } else {
    column("psi [rad]", [&](std::size_t i) { return data.converted[i].psi(); });
    column("Gc_over_GIc", [&](std::size_t i) { return data.converted[i].ratio; });
  }
  for (std::size_t i = 0; i < data.points.size(); ++i) column.add(i);
  return column.text();
}

}  // namespace mixity
