// mixity instability: every fold of the equilibrium curve under load control, displacement control and, if a stiffness
// is given, through a loading apparatus; for given parameters, or for a fit.
#include <iostream>

#include "cli/commands.h"
#include "cli/contact_flags.h"
#include "cli/fitted_contact.h"
#include "fitting/predicted_curves.h"
#include "report/instability_text.h"

DEFINE_string(stiffness, "",
              "stiffness k of the loading apparatus, such as \"1200 N/m\", or dimensionless; adds the folds under it");

namespace mixity::cli {
namespace {

const std::string kStiffness = "N/m";

/// Load, displacement, and the stiffness from the flag, dimensionless.
std::vector<Control> controls(const std::optional<Contact>& contact) {
  std::vector<Control> list{{Control::Kind::load}, {Control::Kind::displacement}};
  if (!is_set("stiffness")) return list;
  const double stiffness =
      positive_quantity("stiffness", kStiffness, contact ? std::optional(contact->stiffness_unit()) : std::nullopt);
  list.push_back({Control::Kind::stiffness, stiffness});
  return list;
}

InstabilityReport of_flags(const ContactModel& of_loads) {
  const bool approach = is_set("approach");
  const ParameterValues p = parameters_from_flags(of_loads);
  const OutputUnits shown = output_units(of_loads.is_elliptic());
  Load load{};
  ContactModel model = of_loads;
  if (approach) {
    const HeldApproach held = held_approach_from_flags(shown);
    load = {held.approach, held.approach * shown.displacement_scale};
    model = of_loads.at_held_approach(held.compliance);
  } else {
    load = load_from(flag_of_loads("load"), shown);
  }
  InstabilityReport report{std::string(model.info().key), {}};
  report.stated = shown.stated;
  if (approach) report.stated.control = NormalControl::approach;
  if (shown.contact)
    report.units = {shown.force,
                    shown.area(),
                    shown.length,
                    kStiffness,
                    shown.force_scale,
                    shown.area_scale,
                    shown.displacement_scale,
                    shown.contact->stiffness_unit(),
                    approach ? shown.length : ""};
  for (std::size_t i = 0; i < p.size(); ++i)
    report.parameters.push_back({std::string(model.parameters()[i].name), {p[i]}});
  InstabilityReport::AtLoad at{load.shown, {}};
  for (const Control& control : controls(shown.contact)) {
    if (const auto problem = model.problem(p, load.dimensionless); !problem.empty()) throw UsageError(problem);
    for (Fold fold : model.folds(p, load.dimensionless, control)) {
      fold.T /= shown.shear_weight;
      fold.u /= shown.shear_weight;
      at.predicted.folds.push_back(as_prediction(fold));
    }
    if (const auto end = model.closing(p, load.dimensionless, control))
      at.predicted.closings.push_back({control, end->kind, {end->T}, {end->u}, {pi<double>() * end->a * end->b}});
  }
  report.loads.push_back(std::move(at));
  return report;
}

InstabilityReport of_fit(const FittedContact& fitted) {
  const Dataset& data = fitted.data();
  const FitResult& fit = fitted.fit();
  InstabilityReport report{fit.model, {}, data.name + ", status " + std::string(to_string(fit.status))};
  if (data.contact)
    report.units = {data.display.force,
                    data.display.area,
                    "um",
                    kStiffness,
                    data.display.force_scale,
                    data.display.area_scale,
                    data.contact->displacement_unit() * 1e6,
                    data.contact->stiffness_unit(),
                    data.holds_approach() ? data.display.approach : ""};
  report.shear_strength = stated_strength(data);
  report.stated = data.metadata;
  for (const FittedParameter& one : fit.parameters)
    if (one.unit.empty() && one.value && !one.prior) report.parameters.push_back({one.name, {one.value, one.stderr_}});
  for (const Load& load : fitted.loads())
    report.loads.push_back({load.shown, fitted.folds(load, controls(data.contact))});
  return report;
}

void print(const InstabilityReport& report) {
  std::cout << (FLAGS_format == "json" ? to_json(report) : to_text(report));
}

}  // namespace

int run_instability(const Arguments& arguments) {
  if (!arguments.empty()) {
    const FittedContact fitted("instability", arguments);
    print(of_fit(fitted));
    return fitted.exit_code();
  }
  print(of_flags(shaped_model_from(FLAGS_model)));
  return kFine;
}

}  // namespace mixity::cli
