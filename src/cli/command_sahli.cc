// mixity sahli: A = A0 - alpha T^2 for each loading run, and alpha against A0.
#include <iostream>

#include "base/input_error.h"
#include "cli/commands.h"
#include "cli/contact_flags.h"
#include "cli/flag_words.h"
#include "fitting/fit.h"
#include "fitting/sahli.h"
#include "report/sahli_text.h"

DEFINE_string(upto, "0.5", "use points up to this fraction of the largest T of each run");

namespace mixity::cli {
namespace {

/// Parameters for the prediction: from the flags if given, else from a fit of the model to the data.
std::vector<double> prediction_parameters(const Dataset& data, const std::string& model, std::string& described) {
  std::vector<double> values;
  if (is_set("lambda") || is_set("parameters")) {
    const ParameterValues p = parameters_from_flags(model_from(model));
    values.assign(p.begin(), p.end());
    described = "model " + model + " with the given parameters";
    return values;
  }
  const FitResult fit = fit_model(data, model);
  for (const FittedParameter& parameter : fit.parameters) {
    if (!parameter.value) return {};
    values.push_back(*parameter.value);
    described += (described.empty() ? "" : ", ") + parameter.name + " = " + rounded(*parameter.value, 5);
  }
  described =
      "model " + model + " fitted to these data: " + described + " (" + std::string(to_string(fit.status)) + ")";
  return values;
}

}  // namespace

int run_sahli(const Arguments& arguments) {
  if (arguments.size() != 1) throw UsageError("sahli needs one data CSV (see mixity help sahli)");
  const double upto = number_from("upto", 0, 1);
  if (!(upto > 0)) throw UsageError("flag '--upto' must be above 0");
  const std::string model = FLAGS_model.empty() ? "c" : FLAGS_model;
  require_model("model", model);
  const Dataset data = load_dataset(arguments[0], data_overrides());
  if (!data.has_loads)
    throw InputError(data.path, "holds " + std::string(data.has_energies ? "(G_I, G_II)" : "(psi, Gc)") +
                                    " points; A = A0 - alpha T^2 needs P, T and A");
  std::string described;
  const std::vector<double> parameters = prediction_parameters(data, model, described);
  const SahliResult result = fit_sahli(data, upto, parameters.empty() ? "" : model, parameters);
  std::cout << (FLAGS_format == "csv" ? sahli_csv(data, result) : sahli_text(data, result, described, in_flags));
  return result.runs.empty() ? kFitNotOk : kFine;
}

}  // namespace mixity::cli
