// mixity predict: areas at a list of tangential loads; of one model at one normal load, or of a fit with its band.
#include <iostream>

#include "cli/commands.h"
#include "cli/contact_flags.h"
#include "cli/exit_code.h"
#include "cli/fitted_contact.h"
#include "mechanics/states.h"

namespace mixity::cli {
namespace {

template <class Model>
void predict() {
  const Parameters<Model> p = parameters_from_flags<Model>();
  const OutputUnits units = output_units();
  const Load load = load_from("load", FLAGS_load, units);
  const std::vector<Load> shears = loads_from("shear", FLAGS_shear, units);
  for (const Load& shear : shears)
    if (!(shear.dimensionless >= 0 && shear.dimensionless <= kLargestLoad))
      throw UsageError("flag '--shear': every T must lie between 0 and 1e150");
  const LoadedContact<Model> contact(p, load.dimensionless);
  if (!contact.obstacle().empty()) throw UsageError(std::string(contact.obstacle()));

  std::cout << units.header("P", units.force) << ',' << units.header("T", units.force) << ','
            << units.header("y", units.force) << ',' << units.header("a", units.length) << ','
            << units.header("A", units.area()) << ',' << units.header("u", units.length) << ','
            << units.header("psi", units.angle()) << ",f,status\n";
  for (const Load& shear : shears) {
    std::cout << shortest(load.shown) << ',' << shortest(shear.shown) << ',';
    const Equilibrium equilibrium = contact.at(shear.dimensionless);
    if (equilibrium.status == EquilibriumStatus::ok) {
      const ContactState state = contact_state(load.dimensionless, shear.dimensionless, equilibrium.y);
      std::cout << shortest(state.y * units.force_scale) << ',' << shortest(state.a * units.length_scale) << ','
                << shortest(state.A * units.area_scale) << ',' << shortest(state.u * units.displacement_scale) << ','
                << shortest(state.psi) << ',' << shortest(state.f) << ',';
    } else {
      std::cout << ",,,,,,";
    }
    std::cout << to_string(equilibrium.status) << '\n';
  }
}

}  // namespace

int run_predict(const Arguments& arguments) {
  if (!arguments.empty()) {
    const FittedContact fitted("predict", arguments);
    const std::vector<Load> shears = fitted.loads_of("shear", FLAGS_shear);
    fitted.print_areas([&](const Load&) { return shears; });
    return fitted.exit_code();
  }
  require_model("model", FLAGS_model);
  with_model(FLAGS_model, [](auto model) { predict<decltype(model)>(); });
  return kFine;
}

}  // namespace mixity::cli
