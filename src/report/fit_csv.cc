#include "report/fit_csv.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fitting/predicted_curves.h"
#include "report/csv_table.h"

namespace mixity {
namespace {

constexpr std::size_t kCurvePoints = 101;

struct ResidualRow {
  const Dataset* data;
  const FitResult* fit;
  std::size_t index;
  const Point& point() const { return data->points[fit->used[index]]; }
};

/// In the units of the file; P, T and A of data with loads only.
struct CurveRow {
  const Dataset* data;
  const FitResult* fit;
  std::size_t curve;
  std::optional<double> P, T, A;
  double psi, f;
};

/// Columns of a table of one data set have its units in their headings and are those that it has. Tables of several,
/// where `alone` is null, have its name and its units in columns of their own.
template <class Row>
struct Table {
  const Dataset* alone;
  CsvTable<Row> column{};

  void begin() {
    if (!alone) column("dataset", [](auto& row) { return row.data->name; });
    column("provenance", [](auto& row) { return row.data->metadata.provenance; });
    column("model", [](auto& row) { return row.fit->model; });
  }
  template <class Get>
  void of_loads(const std::string& name, std::string DisplayUnits::*unit, Get get) {
    if (!alone || alone->has_loads) column.quantity(name, alone ? alone->display.*unit : "", get);
  }
  void end() {
    if (alone) return;
    column("force_unit", [](auto& row) { return row.data->display.force; });
    column("area_unit", [](auto& row) { return row.data->display.area; });
  }
};

Table<ResidualRow> residual_columns(const Dataset* alone) {
  Table<ResidualRow> table{alone};
  const auto toughness = [](auto get) {
    return [=](const ResidualRow& row) {
      const auto found = row.data->toughness(row.fit->used[row.index]);
      return found ? std::optional(get(*found)) : std::nullopt;
    };
  };
  const auto measured = [](auto member, auto scale) {
    return [=](const ResidualRow& row) {
      return row.data->has_loads ? std::optional(row.point().*member * row.data->display.*scale) : std::nullopt;
    };
  };
  table.begin();
  table.column("line", [](auto& row) { return row.data->line_in_file(row.point().line); });
  table.column("curve", [](auto& row) { return row.data->curves[row.point().curve]; });
  table.column("psi [rad]", toughness([](auto& found) { return found.psi(); }));
  table.column("Gc_over_GIc", toughness([](auto& found) { return found.ratio; }));
  table.column("residual", [](auto& row) { return row.fit->residuals[row.index]; });
  table.of_loads("P", &DisplayUnits::force, measured(&Point::P, &DisplayUnits::force_scale));
  table.of_loads("T", &DisplayUnits::force, measured(&Point::T, &DisplayUnits::force_scale));
  table.of_loads("A", &DisplayUnits::area, measured(&Point::A, &DisplayUnits::area_scale));
  table.of_loads("A_predicted", &DisplayUnits::area, [](const ResidualRow& row) {
    const auto predicted = row.fit->area ? row.fit->area->areas[row.index] : std::nullopt;
    return predicted ? std::optional(*predicted * row.data->display.area_scale) : std::nullopt;
  });
  table.end();
  return table;
}

Table<CurveRow> curve_columns(const Dataset* alone) {
  Table<CurveRow> table{alone};
  table.begin();
  if (!alone || alone->has_loads)
    table.column("curve", [](auto& row) { return row.P ? row.data->curves[row.curve] : std::string(); });
  table.of_loads("P", &DisplayUnits::force, &CurveRow::P);
  table.of_loads("T", &DisplayUnits::force, &CurveRow::T);
  table.of_loads("A", &DisplayUnits::area, &CurveRow::A);
  table.column("psi [rad]", &CurveRow::psi);
  table.column("f", &CurveRow::f);
  table.end();
  return table;
}

void add_residuals(CsvTable<ResidualRow>& table, const Analysis& result) {
  for (const FitResult& fit : result.fits)
    for (std::size_t i = 0; i < fit.residuals.size(); ++i) table.add({&result.data, &fit, i});
}

/// Stable A(T) from T = 0 to the instability, or to a fifth beyond the largest measured T, dense towards the fold.
void add_area_curve(CsvTable<CurveRow>& table, const Analysis& result, const FitResult& fit, std::size_t curve) {
  const Dataset& data = result.data;
  const DisplayUnits& units = data.display;
  for (const StableState& state : stable_states(data, result.request.options, fit, curve, kCurvePoints))
    table.add({&data, &fit, curve, data.curve_loads[curve] * units.force_scale, state.T * units.force_scale,
               state.A * units.area_scale, state.psi, state.f});
}

void add_curves(CsvTable<CurveRow>& table, const Analysis& result) {
  for (const FitResult& fit : result.fits) {
    if (!has_all_values(fit)) continue;
    if (!result.data.has_loads) {
      for (const auto& [psi, f] :
           drawn_toughness(result.data, fit, 0.5 * pi<double>(), std::numeric_limits<double>::max(), kCurvePoints - 1))
        table.add({&result.data, &fit, 0, {}, {}, {}, psi, f});
      continue;
    }
    for (std::size_t curve = 0; curve < result.data.curves.size(); ++curve) add_area_curve(table, result, fit, curve);
  }
}

}  // namespace

std::string residuals_csv(const Analysis& result) {
  auto table = residual_columns(&result.data);
  add_residuals(table.column, result);
  return table.column.text();
}

std::string curves_csv(const Analysis& result) {
  auto table = curve_columns(&result.data);
  add_curves(table.column, result);
  return table.column.text();
}

std::string residuals_table(const std::vector<Analysis>& results) {
  auto table = residual_columns(nullptr);
  for (const Analysis& result : results) add_residuals(table.column, result);
  return table.column.text();
}

std::string curves_table(const std::vector<Analysis>& results) {
  auto table = curve_columns(nullptr);
  for (const Analysis& result : results) add_curves(table.column, result);
  return table.column.text();
}

}  // namespace mixity
