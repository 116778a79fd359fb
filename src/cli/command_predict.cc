// mixity predict: areas at a list of tangential loads, of one model at one normal load, or of a fit with its band.
#include <iostream>

#include "cli/commands.h"
#include "cli/contact_flags.h"
#include "cli/fitted_contact.h"

namespace mixity::cli {
namespace {

void predict(const ContactModel& model) {
  const ParameterValues p = parameters_from_flags(model);
  const OutputUnits units = output_units();
  const Load load = load_from("load", units);
  const std::vector<Load> shears = loads_from("shear", units);
  for (const Load& shear : shears)
    if (!(shear.dimensionless >= 0 && shear.dimensionless <= kLargestLoad))
      throw UsageError("flag '--shear': every T must lie between 0 and 1e150");
  require_contact(model, p, load.dimensionless);
  std::vector<double> T;
  for (const Load& shear : shears) T.push_back(shear.dimensionless);
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

}  // namespace

int run_predict(const Arguments& arguments) {
  if (!arguments.empty()) {
    const FittedContact fitted("predict", arguments);
    const std::vector<Load> shears = fitted.loads_of("shear");
    fitted.print_areas([&](const Load&) { return shears; });
    return fitted.exit_code();
  }
  predict(model_from(FLAGS_model));
  return kFine;
}

}  // namespace mixity::cli
