#include "report/fit_csv.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>

#include "fitting/predicted_curves.h"
#include "report/csv_table.h"
#include "report/fit_fields.h"

namespace mixity {
namespace {

/// Columns of fits.csv: HEADING=PATH of a field in row_of, or HEADING alone where the path is the same.
constexpr std::string_view kColumns =
    "dataset provenance model objective scale status parameter value=own/value stderr=own/stderr lower=own/lower "
    "upper=own/upper at_bound=own/at_bound r2 rmse max_abs_residual area_r2=area/r2 area_rmse=area/rmse area_unit "
    "area_unpredicted=area/unpredicted notice unit=own/unit low=own/interval/low high=own/interval/high "
    "low_status=own/interval/low_status high_status=own/interval/high_status paper_value paper_status=paper/status "
    "paper_r2=paper/r2 prior_mean=own/prior/mean prior_standard_error=own/prior/standard_error variance_share pull "
    "log_evidence=posterior/log_evidence posterior_mean=posterior/mean "
    "posterior_standard_deviation=posterior/standard_deviation credible_low=posterior/low "
    "credible_high=posterior/high mode_III";

/// The fields of the fit (`row`), those of the parameter as "own", and those of the data set and the error budget.
Json row_of(const Dataset& data, const FitResult& fit, const FittedParameter& parameter, Json row) {
  std::optional<double> share, pull;
  if (fit.budget && fit.budget->parameter == parameter.name) share = fit.budget->scatter;
  for (const BudgetPart& part : fit.budget ? fit.budget->parts : std::vector<BudgetPart>{})
    if (part.constant == parameter.name) std::tie(share, pull) = std::tuple(part.share, part.pull);
  row.update({{"dataset", data.name},
              {"provenance", to_string(data.metadata.provenance)},
              {"mode_III", data.has_loads ? Json(to_string(data.metadata.mode_III)) : Json()},
              {"notice", json_of(notice_on(data))},
              {"area_unit", data.display.area},
              {"parameter", parameter.name},
              {"own", row["parameters"][parameter.name]},
              {"posterior", fit.evidence && fit.evidence->parameter == parameter.name ? row["evidence"] : Json()},
              {"paper_value", json_of(fit.paper ? fit.paper->value_of(parameter.name) : std::nullopt)},
              {"variance_share", json_of(share)},
              {"pull", json_of(pull)}});
  return row;
}

/// The value at a path such as "own/interval/low"; null where a part of the path is null.
const Json& at_path(const Json& row, std::string_view path) {
  const std::size_t end = std::min(path.find('/'), path.size());
  const Json& part = row.at(std::string(path.substr(0, end)));
  return part.is_null() || end == path.size() ? part : at_path(part, path.substr(end + 1));
}

std::string cell(const Json& value) {
  if (value.is_null()) return {};
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "1" : "0";
  return value.is_number_float() ? shortest(value.get<double>()) : value.dump();
}

struct ResidualRow {
  const Dataset* data;
  const FitResult* fit;
  std::size_t index;
  const Point& point() const { return data->points[fit->used[index]]; }
};

/// A row in the units of the file; P, T and A only for data with loads.
struct CurveRow {
  const Dataset* data;
  const FitResult* fit;
  std::size_t curve;
  std::optional<double> P, T, A;
  double psi, f;
};

/// A table of one data set has that set's columns, with units in the headings. A table of several, where `alone` is
/// null, has all columns, and additional ones for the data set's name and units.
template <class Row>
struct Table {
  Table(const Dataset* the_only_one, std::span<const Analysis> results) : alone(the_only_one) {
    for (const Analysis& one : results) any_approach |= one.data.holds_approach();
    if (!alone) column("dataset", [](auto& row) { return row.data->name; });
    column("provenance", [](auto& row) { return row.data->metadata.provenance; });
    column("model", [](auto& row) { return row.fit->model; });
  }
  /// The column of what is held: P, and where the approach is held delta.
  template <class Get>
  void held(Get get) {
    const auto only = [get](bool approach) {
      return [=](const Row& row) -> std::optional<double> {
        return row.data->holds_approach() == approach ? get(row) : std::nullopt;
      };
    };
    if (!alone || (alone->has_loads && !alone->holds_approach()))
      column.quantity("P", alone ? alone->display.force : "", only(false));
    if (!alone ? any_approach : alone->holds_approach())
      column.quantity("delta", alone ? alone->display.approach : "", only(true));
  }
  template <class Get>
  void of_loads(const std::string& name, std::string DisplayUnits::*unit, Get get) {
    if (!alone || alone->has_loads) column.quantity(name, alone ? alone->display.*unit : "", get);
  }
  /// Adds the last columns.
  void units() {
    if (alone) return;
    column("force_unit", [](auto& row) { return row.data->display.force; });
    column("area_unit", [](auto& row) { return row.data->display.area; });
  }

  const Dataset* alone;
  bool any_approach = false;  // of several data sets
  CsvTable<Row> column{};
};

std::string residuals(const Dataset* alone, std::span<const Analysis> results) {
  const auto toughness = [](auto get) {
    return [=](const ResidualRow& row) {
      const auto found = row.data->toughness(row.fit->used[row.index]);
      return found ? std::optional(get(*found)) : std::nullopt;
    };
  };
  const auto measured = [](auto member, auto scale) {
    return [=](const ResidualRow& row) {
      return row.data->has_loads ? std::optional(as_decimal(row.point().*member * row.data->display.*scale))
                                 : std::nullopt;
    };
  };
  Table<ResidualRow> table(alone, results);
  table.column("line", [](auto& row) { return row.data->line_in_file(row.point().line); });
  table.column("curve", [](auto& row) { return row.data->curves[row.point().curve]; });
  table.column("psi [rad]", toughness([](auto& found) { return found.psi(); }));
  table.column("Gc_over_GIc", toughness([](auto& found) { return found.ratio; }));
  table.column("residual", [](auto& row) { return row.fit->residuals[row.index]; });
  table.held([](const ResidualRow& row) {
    return row.data->has_loads ? std::optional(row.point().P * row.data->held_scale()) : std::nullopt;
  });
  table.of_loads("T", &DisplayUnits::force, measured(&Point::T, &DisplayUnits::force_scale));
  table.of_loads("A", &DisplayUnits::area, measured(&Point::A, &DisplayUnits::area_scale));
  table.of_loads("A_predicted", &DisplayUnits::area, [](const ResidualRow& row) {
    const bool predicted = row.fit->area && row.fit->area->predicts(row.index);
    return predicted ? std::optional(row.fit->area->areas[row.index] * row.data->display.area_scale) : std::nullopt;
  });
  const auto has_axes = [](const Analysis& one) {
    return !one.data.holds_approach() &&
           std::any_of(one.fits.begin(), one.fits.end(), [](const FitResult& fit) { return fit.axes > 0; });
  };
  const auto loads = [](const ResidualRow& row) { return row.data->holds_approach() && row.fit->axes > 0; };
  if (std::any_of(results.begin(), results.end(), [](const Analysis& one) { return !one.data.loads_beside.empty(); })) {
    table.of_loads("P_measured", &DisplayUnits::force, [loads](const ResidualRow& row) {
      return loads(row)
                 ? std::optional(row.data->loads_beside[row.fit->used[row.index]].q * row.data->display.force_scale)
                 : std::nullopt;
    });
    table.column("P_residual", [loads](auto& row) {
      return loads(row) ? std::optional(row.fit->axes_residuals[row.index]) : std::nullopt;
    });
  }
  if (std::any_of(results.begin(), results.end(), has_axes)) {
    table.column("a_over_b", [](auto& row) {
      return row.data->axes.empty() ? std::nullopt
                                    : std::optional(std::exp(row.data->axes[row.fit->used[row.index]].q));
    });
    table.column("axes_residual", [](auto& row) {
      return row.fit->axes == 0 ? std::nullopt : std::optional(row.fit->axes_residuals[row.index]);
    });
  }
  table.units();
  for (const Analysis& result : results)
    for (const FitResult& fit : result.fits)
      for (std::size_t i = 0; i < fit.residuals.size(); ++i) table.column.add({&result.data, &fit, i});
  return table.column.text();
}

void add_curves(CsvTable<CurveRow>& table, const Analysis& result, const FitResult& fit) {
  constexpr std::size_t kPoints = 101;
  const Dataset& data = result.data;
  const DisplayUnits& units = data.display;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (!data.has_loads)
    for (const auto& [psi, f] : drawn_toughness(data, fit, 0.5 * pi<double>(), kInfinity, kPoints - 1))
      if (f < kInfinity) table.add({&data, &fit, 0, {}, {}, {}, psi, f});
  for (std::size_t curve = 0; data.has_loads && curve < data.curves.size(); ++curve)
    for (const StableState& state : stable_states(data, result.request.options, fit, curve, kPoints))
      table.add({&data, &fit, curve, as_decimal(data.curve_loads[curve] * data.held_scale()),
                 state.T * units.force_scale, state.A * units.area_scale, state.psi, state.f});
}

std::string predicted_curves(const Dataset* alone, std::span<const Analysis> results) {
  Table<CurveRow> table(alone, results);
  if (!alone || alone->has_loads)
    table.column("curve", [](auto& row) { return row.P ? row.data->curves[row.curve] : std::string(); });
  table.held([](const CurveRow& row) { return row.P; });
  table.of_loads("T", &DisplayUnits::force, &CurveRow::T);
  table.of_loads("A", &DisplayUnits::area, &CurveRow::A);
  table.column("psi [rad]", &CurveRow::psi);
  table.column("f", &CurveRow::f);
  table.units();
  for (const Analysis& result : results)
    for (const FitResult& fit : result.fits)
      if (has_all_values(fit)) add_curves(table.column, result, fit);
  return table.column.text();
}

}  // namespace

std::string fits_csv(const std::vector<Analysis>& results) {
  CsvTable<Json> column;
  for (const std::string_view one : split(kColumns, ' ')) {
    const std::string_view path = one.substr(one.find('=') + 1);  // the whole text if there is no =
    column(std::string(one.substr(0, one.find('='))), [path](const Json& row) { return cell(at_path(row, path)); });
  }
  for (const Analysis& result : results)
    for (const FitResult& fit : result.fits) {
      const Json shown = json_of(fit, {&result});
      for (const FittedParameter& parameter : fit.parameters) column.add(row_of(result.data, fit, parameter, shown));
    }
  return column.text();
}

std::string residuals_csv(const Analysis& result) { return residuals(&result.data, {&result, 1}); }
std::string pull_off_csv(const Analysis& result) {
  constexpr int kDigits = 15;  // without the rounding of the units
  struct Row {
    const FitResult& fit;
    std::size_t index;
  };
  const Dataset& data = result.data;
  const DisplayUnits& units = data.display;
  CsvTable<Row> column;
  const auto reading = [&](const Row& row) -> const PullOffReading& { return data.pull_off[row.index]; };
  const auto of = [&](HeldShear held, double scale) {
    return [=](const Row& row) {
      const PullOffReading& one = reading(row);
      return one.held == held ? std::optional(one.shear * scale) : std::nullopt;
    };
  };
  column("model", [](const Row& row) { return row.fit.model; });
  column("line", [&](const Row& row) { return data.line_in_file(reading(row).line); });
  column.quantity("T", units.force, kDigits, of(HeldShear::load, units.force_scale));
  column.quantity("u", units.length, kDigits, of(HeldShear::displacement, units.length_scale));
  column.quantity("P_c", units.force, kDigits, [&](const Row& row) { return reading(row).P * units.force_scale; });
  column.quantity("P_c_predicted", units.force, kDigits,
                  [&](const Row& row) { return row.fit.pull_off_loads[row.index] * units.force_scale; });
  column.quantity("sigma_P", units.force, kDigits, [&](const Row& row) {
    return reading(row).error_of_load(row.fit.errors->pull_off) * units.force_scale;
  });
  column("residual", [](const Row& row) { return row.fit.pull_off_residuals[row.index]; });
  for (const FitResult& fit : result.fits)
    for (std::size_t i = 0; i < fit.pull_off_residuals.size(); ++i) column.add({fit, i});
  return column.text();
}

std::string curves_csv(const Analysis& result) { return predicted_curves(&result.data, {&result, 1}); }
std::string residuals_table(const std::vector<Analysis>& results) { return residuals(nullptr, results); }
std::string curves_table(const std::vector<Analysis>& results) { return predicted_curves(nullptr, results); }

std::string used_csv(const Dataset& data) {
  const DisplayUnits& units = data.display;
  CsvTable<std::size_t> column;
  const auto measured = [&](const char* name, const std::string& unit, double Point::*value, double scale) {
    column.quantity(name, unit,
                    [&data, value, scale](std::size_t i) { return as_decimal(data.points[i].*value * scale); });
  };
  const auto stated = [&](const char* name, const std::string& unit, double PointErrors::*value, double scale) {
    const auto is_stated = [&](const PointErrors& errors) { return errors.*value != kNotStated; };
    if (!data.errors.empty() && std::all_of(data.errors.begin(), data.errors.end(), is_stated))
      column.quantity(name, unit,
                      [&data, value, scale](std::size_t i) { return as_decimal(data.errors[i].*value * scale); });
  };
  if (data.has_loads) {
    column("curve", [&](std::size_t i) { return "run " + std::to_string(data.points[i].curve + 1); });
    measured(data.held_name(), data.held_unit(), &Point::P, data.held_scale());
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
