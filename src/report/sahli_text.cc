#include "report/sahli_text.h"

#include <iomanip>
#include <sstream>

#include "base/number_text.h"
#include "report/csv_table.h"
#include "report/data_text.h"

namespace mixity {
namespace {

double alpha_scale(const DisplayUnits& units) { return units.area_scale / (units.force_scale * units.force_scale); }

std::string alpha_unit(const DisplayUnits& units) {
  return units.area.empty() ? "" : units.area + "/" + units.force + "^2";
}

std::string with_error_if_any(double value, const std::optional<double>& error, double scale, int digits) {
  return rounded(value * scale, digits) + (error ? " +/- " + rounded(*error * scale, 2) : "");
}

std::string power_law_text(const char* title, const std::optional<PowerLaw>& law) {
  if (!law) return {};
  return title + with_error_if_any(law->exponent, law->exponent_stderr, 1, 4) + ")\n";
}

}  // namespace

std::string sahli_text(const Dataset& data, const SahliResult& result, const std::string& predicted_by, Wording words) {
  const DisplayUnits& units = data.display;
  std::ostringstream out;
  out << data_heading(data) << '\n' << data_notes(data, words) << excluded_text(data, "mixity check lists them");
  out << "[[A = A0 - alpha T^2]]  " << bracketed(data.held_name(), data.held_unit()) << ", "
      << bracketed("A0", units.area) << ", " << bracketed("alpha", alpha_unit(units)) << '\n'
      << "    run             P         points  A0                      alpha                     predicted\n";
  for (const SahliRun& run : result.runs)
    out << "    " << std::left << std::setw(15) << run.curve << ' ' << std::setw(9)
        << rounded(run.P * data.held_scale(), 5) << ' ' << std::setw(7) << run.points << ' ' << std::setw(23)
        << with_error_if_any(run.A0, run.A0_stderr, units.area_scale, 5) << ' ' << std::setw(25)
        << with_error_if_any(run.alpha, run.alpha_stderr, alpha_scale(units), 5) << ' '
        << (run.alpha_predicted ? rounded(*run.alpha_predicted * alpha_scale(units), 5) : "-") << '\n';
  for (const std::string& name : result.skipped) out << "    " << name << ": all T used are equal, no parabola\n";
  out << "[[Power law]]\n"
      << power_law_text("    measured   alpha ~ A0^(", result.power_law)
      << power_law_text("    predicted  alpha ~ A0^(", result.predicted_power_law)
      << "    large A0   alpha ~ A0^(-5/4) in every model\n";
  if (!predicted_by.empty()) out << "    predicted by " << predicted_by << '\n';
  return out.str();
}

std::string sahli_csv(const Dataset& data, const SahliResult& result) {
  CsvTable<SahliRun> column;
  const auto shown = [&](const char* name, const std::string& unit, auto member, double scale) {
    column.quantity(name, unit, [=](const SahliRun& run) {
      const std::optional<double> value = run.*member;
      return value ? std::optional(*value * scale) : std::nullopt;
    });
  };
  const DisplayUnits& units = data.display;
  const double scale = alpha_scale(units);
  column("provenance", [&](auto&) { return data.metadata.provenance; });
  column("curve", &SahliRun::curve);
  shown(data.held_name(), data.held_unit(), &SahliRun::P, data.held_scale());
  column("points", &SahliRun::points);
  shown("A0", units.area, &SahliRun::A0, units.area_scale);
  shown("A0_stderr", units.area, &SahliRun::A0_stderr, units.area_scale);
  shown("alpha", alpha_unit(units), &SahliRun::alpha, scale);
  shown("alpha_stderr", alpha_unit(units), &SahliRun::alpha_stderr, scale);
  shown("alpha_predicted", alpha_unit(units), &SahliRun::alpha_predicted, scale);
  for (const SahliRun& run : result.runs) column.add(run);
  return column.text();
}

}  // namespace mixity
