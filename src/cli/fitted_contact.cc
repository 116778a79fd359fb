#include "cli/fitted_contact.h"

#include <algorithm>
#include <iostream>

#include "analysis/judgement.h"
#include "analysis/run.h"
#include "base/input_error.h"
#include "base/number_text.h"
#include "cli/contact_flags.h"
#include "cli/fit_flags.h"
#include "cli/flag_words.h"
#include "cli/flags.h"
#include "mechanics/states.h"

namespace mixity::cli {
namespace {

Analysis fitted(const std::string& command, const Arguments& arguments) {
  if (is_set("approach"))
    throw UsageError("--approach needs --model in place of data; approaches of data are stated by --loads=\"3, 8 um\"");
  if (arguments.size() != 1) throw UsageError(command + " takes one data CSV or fit definition");
  const std::string& path = arguments[0];
  for (const char* flag : {"lambda", "parameters", "units"})
    if (is_set(flag))
      throw UsageError("flag '--" + std::string(flag) + "' describes a single contact without data; " + path +
                       " is fitted");
  if (is_set("model")) require_model("model", FLAGS_model);
  Analysis result = run(request_for(path, is_set("model") ? std::optional(FLAGS_model) : std::nullopt));
  const Dataset& data = result.data;
  if (!data.has_loads) throw InputError(data.path, "holds no loads and areas, which this is about");
  return result;
}

}  // namespace

FittedContact::FittedContact(const std::string& command, const Arguments& arguments)
    : result_(fitted(command, arguments)), best_(by_merit(result_).front()) {
  // --load is that of the data where they state none
  const std::vector<Message>& notes = data().notes;
  if (is_set("load") && std::find(notes.begin(), notes.end(), kLoadNotUsed) != notes.end()) {
    loads_ = loads_of(flag_of_loads("loads"));
    if (loads_.size() != 1) throw not_one_number("load");
    return;
  }
  if (is_set("loads")) {
    loads_ = loads_of("loads");
    return;
  }
  std::vector<double> of_runs = data().curve_loads;
  std::sort(of_runs.begin(), of_runs.end(), std::greater<>());
  of_runs.erase(std::unique(of_runs.begin(), of_runs.end()), of_runs.end());
  for (const double load : of_runs) loads_.push_back({load, as_decimal(load * data().held_scale())});
}

std::vector<Load> FittedContact::loads_of(const std::string& flag) const {
  std::vector<Load> loads;
  const Dataset& of = data();
  const bool held = flag.starts_with("load") && of.holds_approach();
  const double scale = held ? of.held_scale() : of.display.force_scale;
  const double unit = !of.contact ? 1  // of the data, in SI
                                  : (held ? of.contact->displacement_unit() : of.contact->force_unit()) / scale;
  for (const Quantity& load : quantities_from(flag)) {
    const bool bare = load.unit.text.empty();
    if (!bare && (!of.contact || load.unit.dimension != (held ? dimension::length : dimension::force)))
      throw UsageError("flag '--" + flag + "' must be " +
                       (of.contact ? held ? "approaches such as \"3, 8 um\"" : "forces such as \"3, 8 mN\""
                                   : "numbers: the data are dimensionless"));
    // 4 mN are shown as exactly 4 mN
    const double shown = bare || load.unit.text == (held ? of.held_unit() : of.display.force)
                             ? load.value
                             : as_decimal(load.si() / unit);
    loads.push_back({shown / scale, shown});
  }
  return loads;
}

FoldsPrediction FittedContact::folds(const Load& P, const std::vector<Control>& controls) const {
  return predict_folds_of(data(), fit(), result_.request.options, P.dimensionless, controls);
}

std::vector<Load> FittedContact::shears_to_the_jump(const Load& P, std::size_t points) const {
  double last = 0;
  for (const Point& point : data().points) last = std::max(last, point.shear());
  if (const auto jump = predict_jump_of(data(), fit(), result_.request.options, P.dimensionless)) last = *jump->T.value;
  std::vector<Load> shears;
  for (std::size_t i = 0; i < points; ++i) {
    const double T = last * static_cast<double>(i) / static_cast<double>(points - 1);
    shears.push_back({T, T * data().display.force_scale});
  }
  return shears;
}

void FittedContact::print_areas(const std::function<std::vector<Load>(const Load& P)>& shears) const {
  const DisplayUnits& units = data().display;
  std::cout << bracketed(data().held_name(), data().held_unit()) << ',' << bracketed("T", units.force) << ','
            << bracketed("A", units.area) << ',' << bracketed("A_stderr", units.area) << ",status";
  const bool elliptic = ContactModel::find(fit().model).value().is_elliptic();
  const std::string length = units.area.empty() ? "" : "mm";
  const double length_scale = data().contact ? data().contact->length_unit() / 1e-3 : 1;
  for (const char* name : {"a", "a_stderr", "b", "b_stderr"})
    if (elliptic) std::cout << ',' << bracketed(name, length);
  std::cout << '\n';
  for (const Load& load : loads_) {
    const std::vector<Load> at = shears(load);
    const std::vector<double> P(at.size(), load.dimensionless);
    std::vector<double> T;
    for (const Load& shear : at) T.push_back(shear.dimensionless);
    const std::vector<AreaPrediction> areas = predict_areas_of(data(), fit(), result_.request.options, P, T);
    for (std::size_t i = 0; i < areas.size(); ++i) {
      const AreaPrediction& area = areas[i];
      std::cout << shortest(load.shown) << ',' << shortest(at[i].shown) << ',';
      if (area.status == EquilibriumStatus::ok) std::cout << shortest(area.A * units.area_scale);
      std::cout << ',';
      if (area.standard_error) std::cout << shortest(*area.standard_error * units.area_scale);
      std::cout << ',' << to_string(area.status);
      for (const Derived& axis : {area.a, area.b})
        for (const std::optional<double>& number : {axis.value, axis.standard_error})
          if (elliptic) std::cout << ',' << (number ? shortest(*number * length_scale) : "");
      std::cout << '\n';
    }
  }
}

int FittedContact::exit_code() const {
  if (fit().status == FitStatus::ok) return kFine;
  warn(data().shown_path() + ": model " + fit().model + " is " + std::string(to_string(fit().status)) +
       (fit().message.empty() ? "" : ": " + fit().message.text(in_flags)));
  return kFitNotOk;
}

}  // namespace mixity::cli
