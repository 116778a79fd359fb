// mixity predict: areas at a list of tangential loads, of one model at one normal load, or of a fit with its band.
#include <cmath>
#include <iostream>

#include "cli/commands.h"
#include "cli/contact_flags.h"
#include "cli/fitted_contact.h"
#include "cli/flag_values.h"
#include "mechanics/ellipse_pressure.h"

namespace mixity::cli {
namespace {

struct Loads {
  OutputUnits units;
  Load load = load_from("load", units);
  std::vector<Load> shears = loads_from("shear", units);
  std::vector<double> T{};

  explicit Loads(bool of_ellipse) : units(output_units(of_ellipse)) {
    for (const Load& shear : shears) {
      if (!(shear.dimensionless >= 0 && shear.dimensionless <= kLargestLoad))
        throw UsageError("flag '--shear': every T must lie between 0 and 1e150");
      T.push_back(shear.dimensionless);
    }
  }
};

void predict(const ContactModel& model) {
  const ParameterValues p = parameters_from_flags(model);
  const auto [units, load, shears, T] = Loads(false);
  require_contact(model, p, load.dimensionless);
  const std::vector<Equilibrium> found = model.equilibria(p, load.dimensionless, T).at;

  std::cout << units.headings("P,T,y,a,A,u,psi,f,status") << '\n';
  for (std::size_t i = 0; i < shears.size(); ++i) {
    print_numbers({load.shown, shears[i].shown});
    std::cout << ',';
    if (found[i].status == EquilibriumStatus::ok) {
      const ContactState state = contact_state(load.dimensionless, T[i], found[i].y);
      print_numbers({state.y * units.force_scale, state.a * units.length_scale, state.A * units.area_scale,
                     state.u * units.displacement_scale, state.psi, state.f});
    } else {
      std::cout << ",,,,,";
    }
    std::cout << ',' << to_string(found[i].status) << '\n';
  }
}

/// The semi-axes of an ellipse (mechanics/ellipse.h).
void predict_ellipse(const ContactModel& model) {
  if (!is_set("poisson_ratio")) throw UsageError("--shape=ellipse needs --poisson_ratio, which mode III depends on");
  const double nu = number_from("poisson_ratio", 0, 0.5);
  const EndParameterValues ends = end_parameters_from_flags(model);
  const EndParameters p{ends.mode_II, ends.mode_III, nu};
  const Loads loads(true);
  const OutputUnits& units = loads.units;
  const Load& load = loads.load;
  const std::vector<Load>& shears = loads.shears;
  const std::vector<double>& T = loads.T;
  for (const ParameterValues& one : {ends.mode_II, ends.mode_III}) require_contact(model, one, load.dimensionless);
  const Ellipses found = model.ellipses(p, load.dimensionless, T);
  if (!shears.empty() && found.at[0].status == EquilibriumStatus::invalid)
    throw UsageError("model " + std::string(model.info().key) +
                     " has no elliptic contact with these parameters: its shear term must grow with T from T = 0 on");

  std::cout << units.headings("P,T,a,b,A,u,psi_II,psi_III,status") << '\n';
  for (std::size_t i = 0; i < shears.size(); ++i) {
    const EllipseState& state = found.at[i];
    print_numbers({load.shown, shears[i].shown});
    std::cout << ',';
    if (state.status == EquilibriumStatus::ok)
      print_numbers({state.a * units.length_scale, state.b * units.length_scale,
                     pi<double>() * state.a * state.b * units.area_scale,
                     T[i] * ellipse_compliance(std::log(state.a / state.b), nu) / std::sqrt(state.a * state.b) *
                         units.displacement_scale,
                     state.psi_II, state.psi_III});
    else
      std::cout << ",,,,,";
    const bool closed = found.end && found.end->kind != EllipseEnd::fold && T[i] > found.end->T;
    std::cout << ',' << (closed ? to_string(found.end->kind) : to_string(state.status)) << '\n';
  }
  if (!found.end) return;
  const auto shown = [](double value, const std::string& unit) {
    return rounded(value, 6) + (unit.empty() ? "" : " " + unit);
  };
  const auto at = [&](const EllipseBranchEnd& end) {
    return "T = " + shown(end.T * units.force_scale, units.force) +
           ", u = " + shown(end.u * units.displacement_scale, units.length);
  };
  if (found.end->kind != EllipseEnd::fold) {
    const std::string axis = found.end->kind == EllipseEnd::closes_along ? "a" : "b";
    warn("K_I falls to 0 at the ends of " + axis + " at " + at(*found.end) +
         ": the edge closes or slips there, and the equations end");
    return;
  }
  const auto later = model.ellipse_ends(p, load.dimensionless).displacement;
  warn("the contact jumps at " + at(*found.end) + (later ? "; under displacement control at " + at(*later) : ""));
}

}  // namespace

int run_predict(const Arguments& arguments) {
  if (!arguments.empty()) {
    const FittedContact fitted("predict", arguments);
    const std::vector<Load> shears = fitted.loads_of("shear");
    fitted.print_areas([&](const Load&) { return shears; });
    return fitted.exit_code();
  }
  const ContactModel model = model_from(FLAGS_model);
  is_elliptic() ? predict_ellipse(model) : predict(model);
  return kFine;
}

}  // namespace mixity::cli
