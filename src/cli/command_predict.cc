// mixity predict: areas at a list of tangential loads, of one model at one normal load, or of a fit with its band.
#include <cmath>
#include <iostream>
#include <optional>

#include "cli/commands.h"
#include "cli/contact_flags.h"
#include "cli/fitted_contact.h"
#include "cli/flag_values.h"
#include "mechanics/ellipse_pressure.h"
#include "mechanics/held_approach.h"

namespace mixity::cli {
namespace {

struct Shears {
  std::vector<Load> shown;
  std::vector<double> T{};  // in the equations of the models

  explicit Shears(const OutputUnits& units) : shown(loads_from("shear", units)) {
    for (const Load& shear : shown) {
      const double weighted = units.shear_weight * shear.dimensionless;
      if (!(weighted >= 0 && weighted <= kLargestLoad))
        throw UsageError("flag '--shear': every T must lie between 0 and 1e150");
      T.push_back(weighted);
    }
  }
};

/// A row of the prediction; P is empty where it is not held and there is no equilibrium.
void print_state(const OutputUnits& units, std::optional<double> P, double T, EquilibriumStatus status,
                 const ContactState& state) {
  std::cout << (P ? shortest(*P) : "") << ',' << shortest(T) << ',';
  if (status == EquilibriumStatus::ok)
    print_numbers({state.y * units.force_scale, state.a * units.length_scale, state.A * units.area_scale,
                   state.u * units.slip_scale(), state.psi, state.f});
  else
    std::cout << ",,,,,";
  std::cout << ',' << to_string(status) << '\n';
}

constexpr const char* kColumns = "P,T,y,a,A,u,psi,f,status";

void predict(const ContactModel& model) {
  const ParameterValues p = parameters_from_flags(model);
  const OutputUnits units = output_units();
  const Load load = load_from(flag_of_loads("load"), units);
  const Shears shears(units);
  require_contact(model, p, load.dimensionless);
  const std::vector<Equilibrium> found = model.equilibria(p, load.dimensionless, shears.T).at;
  std::cout << units.headings(kColumns) << '\n';
  for (std::size_t i = 0; i < found.size(); ++i) {
    const bool ok = found[i].status == EquilibriumStatus::ok;
    print_state(units, load.shown, shears.shown[i].shown, found[i].status,
                ok ? contact_state(load.dimensionless, shears.T[i], found[i].y) : ContactState{});
  }
}

/// The approach is held in place of the load (mechanics/held_approach.h).
void predict_under_approach(const ContactModel& model) {
  const ParameterValues p = parameters_from_flags(model);
  const OutputUnits units = output_units();
  const HeldApproach held = held_approach_from_flags(units);
  const Shears shears(units);
  require_contact(model, p);
  const ApproachStates found = under_held_approach(model, p, held, shears.T);
  if (!found.at.empty() && found.at[0].status == EquilibriumStatus::invalid)
    throw UsageError("flag '--approach' or '--normal_stiffness' is out of range");
  std::cout << units.headings(kColumns) << '\n';
  for (std::size_t i = 0; i < found.at.size(); ++i) {
    const auto& [status, P, a] = found.at[i];
    const bool ok = status == EquilibriumStatus::ok;
    print_state(units, ok ? std::optional(P * units.force_scale) : std::nullopt, shears.shown[i].shown, status,
                ok ? contact_state(P, shears.T[i], edge_load(a, P)) : ContactState{});
  }
  if (!found.end) return;
  const std::string unit = units.force.empty() ? "" : " " + units.force;
  warn((found.end->fold ? "the contact jumps at T = " : "the edge load falls to 0 at T = ") +
       rounded(found.end->T * units.shear_scale(), 6) + unit + ", P = " + rounded(found.end->P * units.force_scale, 6) +
       unit);
}

/// The semi-axes of an ellipse (mechanics/ellipse.h).
void predict_ellipse(const ContactModel& model) {
  if (!is_set("poisson_ratio")) throw UsageError("--shape=ellipse needs --poisson_ratio, which mode III depends on");
  const double nu = number_from("poisson_ratio", 0, 0.5);
  const EndParameterValues ends = end_parameters_from_flags(model);
  const EndParameters p{ends.mode_II, ends.mode_III, nu};
  const OutputUnits units = output_units(true);
  const Load load = load_from(flag_of_loads("load"), units);
  const Shears shears_given(units);
  const std::vector<Load>& shears = shears_given.shown;
  const std::vector<double>& T = shears_given.T;
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
                     T[i] * ellipse_compliance(std::log(state.a / state.b), nu).value / std::sqrt(state.a * state.b) *
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
  const auto later = model.ellipse_end(p, load.dimensionless, {Control::Kind::displacement});
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
  if (model.is_elliptic())
    throw UsageError("--model=" + FLAGS_model + ": states of ellipses are predicted by --model=" +
                     std::string(model.circle().info().key) + " --shape=ellipse");
  if (is_elliptic())
    predict_ellipse(model);
  else if (is_set("approach"))
    predict_under_approach(model);
  else
    predict(model);
  return kFine;
}

}  // namespace mixity::cli
