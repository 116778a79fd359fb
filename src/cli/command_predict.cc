// mixity predict: areas at a list of tangential loads, of one model at one normal load, or of a fit with its band.
#include <iostream>

#include "cli/commands.h"
#include "cli/contact_flags.h"
#include "cli/fitted_contact.h"
#include "cli/flag_values.h"

namespace mixity::cli {
namespace {

struct Loads {
  OutputUnits units = output_units();
  Load load = load_from("load", units);
  std::vector<Load> shears = loads_from("shear", units);
  std::vector<double> T{};  // in the equations of the models

  Loads() {
    for (const Load& shear : shears) {
      const double weighted = units.shear_weight * shear.dimensionless;
      if (!(weighted >= 0 && weighted <= kLargestLoad))
        throw UsageError("flag '--shear': every T must lie between 0 and 1e150");
      T.push_back(weighted);
    }
  }
};

void predict(const ContactModel& model) {
  const ParameterValues p = parameters_from_flags(model);
  const auto [units, load, shears, T] = Loads();
  require_contact(model, p, load.dimensionless);
  const std::vector<Equilibrium> found = model.equilibria(p, load.dimensionless, T).at;

  std::cout << units.headings("P,T,y,a,A,u,psi,f,status") << '\n';
  for (std::size_t i = 0; i < shears.size(); ++i) {
    print_numbers({load.shown, shears[i].shown});
    std::cout << ',';
    if (found[i].status == EquilibriumStatus::ok) {
      const ContactState state = contact_state(load.dimensionless, T[i], found[i].y);
      print_numbers({state.y * units.force_scale, state.a * units.length_scale, state.A * units.area_scale,
                     state.u * units.slip_scale(), state.psi, state.f});
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
  const auto [mode_II, mode_III] = end_parameters_from_flags(model);
  const auto [units, load, shears, T] = Loads();
  for (const ParameterValues& p : {mode_II, mode_III}) require_contact(model, p, load.dimensionless);
  const Ellipses found = model.ellipses({mode_II, mode_III, nu}, load.dimensionless, T);
  if (!shears.empty() && found.at[0].status == EquilibriumStatus::invalid)
    throw UsageError("model " + std::string(model.info().key) +
                     " has no elliptic contact with these parameters: its shear term must grow with T from T = 0 on");

  std::cout << units.headings("P,T,a,b,A,psi_II,psi_III,status") << '\n';
  for (std::size_t i = 0; i < shears.size(); ++i) {
    const EllipseState& state = found.at[i];
    print_numbers({load.shown, shears[i].shown});
    std::cout << ',';
    if (state.status == EquilibriumStatus::ok)
      print_numbers({state.a * units.length_scale, state.b * units.length_scale,
                     pi<double>() * state.a * state.b * units.area_scale, state.psi_II, state.psi_III});
    else
      std::cout << ",,,,";
    const bool closed = found.end && found.end->kind != EllipseEnd::fold && T[i] > found.end->T;
    std::cout << ',' << (closed ? to_string(found.end->kind) : to_string(state.status)) << '\n';
  }
  if (!found.end) return;
  const std::string force = units.force.empty() ? "" : " " + units.force,
                    T_end = rounded(found.end->T * units.force_scale, 6) + force;
  warn(found.end->kind == EllipseEnd::fold
           ? "the contact jumps at T = " + T_end
           : "K_I falls to 0 at the ends of " + std::string(found.end->kind == EllipseEnd::closes_along ? "a" : "b") +
                 " at T = " + T_end + ": the edge closes or slips there, and the equations end");
}

}  // namespace

int run_predict(const Arguments& arguments) {
  if (!arguments.empty()) {
    if (is_elliptic()) throw UsageError("--shape=ellipse is not fitted yet: predict takes --model and its parameters");
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
