// mixity map: the regime of a sheared contact over normal load and lambda.
#include <iostream>

#include "base/number_text.h"
#include "cli/commands.h"
#include "cli/contact_flags.h"

DEFINE_string(axis, "", "the parameter on the second axis of the map; by default the model's first");
DEFINE_string(lambda_range, "0,1", "smallest and largest lambda of the map");
DEFINE_string(grid, "41", "points of the map along each axis");
DEFINE_bool(boundaries, false, "print the exact boundaries between regimes instead of the grid");
DEFINE_string(tau0, "",
              "shear strength of the interface, such as \"0.43 MPa\", or dimensionless (tau0 xi/E*); the contact then "
              "slides at T = tau0 A");

namespace mixity::cli {
namespace {

struct Range {
  double low, high;
  std::size_t points = count_from("grid", 2, 10000);
  double at(std::size_t i) const {
    const double share = static_cast<double>(i) / static_cast<double>(points - 1);
    return i + 1 < points ? as_decimal(low + (high - low) * share) : high;
  }
};

/// The two ends of --load_range, in the output's unit.
Range load_range(const OutputUnits& units) {
  constexpr double kPullOff = -4.71238898038469, kLargest = 1e8;
  const bool given = is_set("load_range");
  const std::vector<Load> ends = loads_from("load_range", given ? units : OutputUnits{});
  if (ends.size() == 2 && ends[0].dimensionless >= kPullOff && ends[0].dimensionless < ends[1].dimensionless &&
      ends[1].dimensionless <= kLargest) {
    const double unit = given ? 1 : units.force_scale;
    return {ends[0].shown * unit, ends[1].shown * unit};
  }
  const auto shown = [&](double load) { return rounded(load * units.force_scale, 15) + unit_text(units.force); };
  throw must("load_range", "be two rising loads from " + shown(kPullOff) + " to " + shown(kLargest));
}

/// tau0 in units of E*/xi, times the weight of shears.
std::optional<double> strength(const OutputUnits& units) {
  if (!is_set("tau0")) return std::nullopt;
  return units.shear_weight *
         positive_quantity("tau0", "MPa", units.contact ? std::optional(units.contact->stress_unit()) : std::nullopt);
}

Range range_from(const std::string& flag, double lowest, double highest) {
  const std::vector<std::string> items = list_from(flag);
  const auto low = items.size() == 2 ? parse_number(items[0]) : std::nullopt;
  const auto high = items.size() == 2 ? parse_number(items[1]) : std::nullopt;
  if (!low || !high || !(*low >= lowest && *low < *high && *high <= highest))
    throw must(flag, "be two rising numbers from " + shortest(lowest) + " to " + shortest(highest));
  return {*low, *high};
}

std::string finite_or_empty(double value) { return std::isfinite(value) ? shortest(value) : std::string(); }

/// A grid over loads and the parameter with index `axis`; the others are from `p`.
void print_grid(const ContactModel& model, const Range& loads, ParameterValues p, std::size_t axis, const Range& values,
                std::optional<double> tau0, const OutputUnits& units) {
  std::cout << units.headings("P") << ',' << model.parameters()[axis].name << ','
            << units.headings("regime,fracture,T_end,jumps_to,T_strength,regime_name,fracture_name") << '\n';
  for (std::size_t i = 0; i < loads.points; ++i)
    for (std::size_t j = 0; j < values.points; ++j) {
      const double P = loads.at(i);
      p[axis] = values.at(j);
      std::cout << shortest(P) << ',' << shortest(p[axis]) << ',';
      const auto report = model.regime(p, P / units.force_scale, tau0);
      if (!report) {  // no unique equilibrium
        std::cout << ",,,,,,\n";
        continue;
      }
      std::cout << static_cast<int>(report->regime) << ',' << static_cast<int>(report->fracture) << ','
                << finite_or_empty(report->T_end * units.shear_scale()) << ','
                << (report->jumps_to ? to_string(*report->jumps_to) : "") << ','
                << (report->T_strength ? shortest(*report->T_strength * units.shear_scale()) : "") << ','
                << to_string(report->regime) << ',' << to_string(report->fracture) << '\n';
    }
}

/// Points of the boundaries between regimes inside the ranges.
void print_boundaries(std::span<const RegimeBoundary> boundaries, const Range& loads, const Range& lambdas,
                      const OutputUnits& units) {
  const auto inside = [](const Range& range, double x) { return x >= range.low && x <= range.high; };
  std::cout << units.headings("boundary,P,lambda") << '\n';
  for (const RegimeBoundary& line : boundaries)
    for (std::size_t i = 0; i < loads.points; ++i) {
      const double P = line.of_load ? loads.at(i) : line.at(lambdas.at(i)) * units.force_scale,
                   lambda = line.of_load ? line.at(P / units.force_scale) : lambdas.at(i);
      if (inside(loads, P) && inside(lambdas, lambda))
        std::cout << line.name << ',' << shortest(P) << ',' << shortest(lambda) << '\n';
    }
}

}  // namespace

int run_map(const Arguments& arguments) {
  require_flags_only("map", arguments);
  const ContactModel model = model_from(FLAGS_model);
  const std::string key(model.info().key);
  if (is_set("tau0") && FLAGS_boundaries) throw UsageError("flags '--tau0' and '--boundaries': give one of them");
  const OutputUnits units = output_units();
  const std::optional<double> tau0 = strength(units);
  const std::span<const ParameterInfo> infos = model.parameters();
  std::size_t axis = 0;
  if (is_set("axis"))
    while (axis < infos.size() && infos[axis].name != FLAGS_axis) ++axis;
  if (axis == infos.size()) throw refused("axis", "model " + key + " has no parameter '" + FLAGS_axis + "'");
  const ParameterValues others = parameters_from_flags(model, axis);
  const Range loads = load_range(units);
  const ParameterInfo& info = infos[axis];
  const bool usual = info.name == "lambda" || is_set("lambda_range");
  const Range values = usual ? range_from("lambda_range", info.lower, info.upper) : Range{info.lower, info.upper};
  const auto boundaries = model.regime_boundaries();
  if (FLAGS_boundaries && !boundaries) throw refused("boundaries", "those of model " + key + " have no closed form");
  if (FLAGS_boundaries)
    print_boundaries(*boundaries, loads, values, units);
  else
    print_grid(model, loads, others, axis, values, tau0, units);
  return kFine;
}

}  // namespace mixity::cli
