// mixity points: the points of a data set, converted to toughness ratio against phase angle.
#include <numbers>

#include "cli/commands.h"
#include "cli/flags.h"
#include "dataset/dataset.h"
#include "report/csv_table.h"

namespace mixity::cli {
namespace {

/// A row for each usable point. psi and Gc_over_GIc are empty where the area is no larger than that of Hertz.
std::string points_csv(const Dataset& data) {
  CsvTable<std::size_t> column;
  column("line", [&](std::size_t i) { return data.line_in_file(data.points[i].line); });
  if (data.has_loads) {
    const DisplayUnits& units = data.display;
    column("curve", [&](std::size_t i) { return data.curves[data.points[i].curve]; });
    column.quantity(data.held_name(), data.held_unit(),
                    [&](std::size_t i) { return as_decimal(data.points[i].P * data.held_scale()); });
    column.quantity("T", units.force, [&](std::size_t i) { return as_decimal(data.points[i].T * units.force_scale); });
    column.quantity("A", units.area, [&](std::size_t i) { return as_decimal(data.points[i].A * units.area_scale); });
  }
  const auto converted = [&](auto value) {
    return [&data, value](std::size_t i) {
      const auto point = data.toughness(i);
      return point ? std::optional(value(*point)) : std::nullopt;
    };
  };
  column("psi [deg]", converted([](const ToughnessPoint& point) { return point.psi() * 180 / std::numbers::pi; }));
  column("Gc_over_GIc", converted([](const ToughnessPoint& point) { return point.ratio; }));
  for (std::size_t i = 0; i < data.points.size(); ++i) column.add(i);
  return column.text();
}

}  // namespace

int run_points(const Arguments& arguments) {
  if (arguments.size() != 1) throw UsageError("points needs one data CSV (see mixity help points)");
  print_or_write(points_csv(load_dataset(arguments[0], data_overrides())));
  return kFine;
}

}  // namespace mixity::cli
