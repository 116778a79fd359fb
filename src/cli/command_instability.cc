// mixity instability: every fold of the equilibrium curve, under load and displacement control and, if asked for,
// through a loading apparatus of given stiffness.
#include <iostream>

#include "cli/commands.h"
#include "cli/contact_flags.h"
#include "cli/exit_code.h"
#include "mechanics/equilibrium.h"
#include "report/instability_text.h"

namespace mixity::cli {

int run_instability(const Arguments& arguments) {
  require_flags_only("instability", arguments);
  require_model("model", FLAGS_model);
  with_model(FLAGS_model, [](auto model) {
    using Model = decltype(model);
    const Parameters<Model> p = parameters_from_flags<Model>();
    const double load = number_from("load", FLAGS_load, -1e150);
    const LoadedContact<Model> contact(p, load);
    if (!contact.obstacle().empty()) throw UsageError(std::string(contact.obstacle()));
    if (!contact.in_contact()) throw UsageError("flag '--load': no contact exists below the pull-off load -3 pi/2");

    std::vector<Control> controls{{Control::Kind::load}, {Control::Kind::displacement}};
    if (is_set("stiffness"))
      controls.push_back({Control::Kind::stiffness, number_from("stiffness", FLAGS_stiffness, 1e-150)});
    InstabilityReport report{std::string(Model::info.key), {}, load, {}};
    for (std::size_t i = 0; i < p.size(); ++i) report.parameters.emplace_back(Model::parameters[i].name, p[i]);
    const EquilibriumCurve<Model> curve(p, load);
    for (const Control& control : controls)
      for (const Fold& fold : find_folds(curve, control)) report.folds.push_back(fold);
    std::cout << (FLAGS_format == "json" ? to_json(report) : to_text(report));
  });
  return kFine;
}

}  // namespace mixity::cli
