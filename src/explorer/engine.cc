// The engine as called by the page's script: texts in, JSON out. An exception becomes {"error": SENTENCE, "options":
// [recommended ones], "buttons": (field_words.h)}.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "analysis/answer.h"
#include "analysis/contact_shape.h"
#include "analysis/fit_definition.h"
#include "analysis/laws.h"
#include "analysis/result.h"
#include "analysis/run.h"
#include "analysis/settings.h"
#include "explorer/drawing.h"
#include "explorer/experiment.h"
#include "explorer/field_words.h"
#include "explorer/log.h"
#include "mechanics/laws/known_laws.h"
#include "mechanics/regime_map.h"
#include "report/fit_csv.h"
#include "report/fit_json.h"

namespace mixity::explorer {
namespace {

std::string guarded(const std::function<Json()>& work) {
  const auto text = [](const Json& told) { return told.dump(-1, ' ', false, Json::error_handler_t::replace); };
  try {
    return text(work());
  } catch (const InputError& error) {
    return text({{"error", error.text(in_fields)},
                 {"options", error.message().options()},
                 {"buttons", buttons_of(error.message())}});
  } catch (const std::exception& error) {
    return text({{"error", error.what()}});
  }
}

double* at(std::uintptr_t address) { return reinterpret_cast<double*>(address); }

/// Areas at n loads T, both arrays of doubles in the module's memory; NaN where there is no equilibrium.
void areas_at(const std::string& model, const std::vector<double>& parameters, double P, std::uintptr_t T,
              std::uintptr_t A, std::size_t n) {
  std::vector<EquilibriumStatus> status(n);
  model_of(model).areas_at(parameters, P, {at(T), n}, {at(A), n}, status);
}

/// Writes a file for `read`, `cut` and `fit`: data, or the TOML beside it. Contents are passed as Uint8Array, because
/// JavaScript strings would be converted to UTF-8.
void write_file(const std::string& name, const std::string& content) {
  std::ofstream(name, std::ios::binary) << content;
}

using Names = std::vector<std::string>;

Names names_in(const std::string& list) { return Json::parse(list).get<Names>(); }

Overrides constants_in(const std::string& constants) {
  const Json stated = Json::parse(constants);
  Overrides overrides;
  for (const auto& [key, text] : stated.items()) overrides.emplace_back(key, text.get<std::string>());
  return overrides;
}

/// Constants of the experiment and options as texts by name: {"radius": "9.42 mm"}, {"models": "c", "peaks": file}.
FitRequest request_of(const Names& names, const std::string& constants, const std::string& options) {
  const Json chosen = Json::parse(options);
  FitRequest request;
  request.data_path = names.at(0);
  if (names.size() > 1)
    for (const std::string& name : names) request.runs.push_back({name});
  request.words = in_fields;
  for (const auto& [key, text] : chosen.items())
    if (key == "peaks")
      request.peaks_path = text.get<std::string>();
    else if (const std::string problem = set_option(request, key, text.get<std::string>()); !problem.empty())
      throw InputError(key, problem);
  request.constants = constants_in(constants);
  take_shape(request);
  return request;
}

/// How written files are read, one or several that make one data set (experiment.h). {"log": true} for logs, which
/// `cut` takes, unless `as_points`.
std::string read_files(const std::string& list, const std::string& constants, bool as_points) {
  return guarded([&] {
    const Names names = names_in(list);
    const FitRequest request = request_of(names, constants, "{}");
    if (!as_points && are_logs(names, request.constants)) return Json{{"log", true}};
    return as_read(names.size() > 1 ? load_pooled(request.runs, request.constants)
                                    : load_dataset(names[0], request.constants));
  });
}

/// The loading runs of written logs (log.h).
std::string cut_files(const std::string& list, const std::string& stem, const std::string& constants) {
  return guarded([&] {
    Overrides stated = constants_in(constants);
    take_ellipse(stated);  // which concerns fits alone
    return cut_logs(names_in(list), stem, stated);
  });
}

/// Fits written files; calls `progress` with the part that is done. {"fits": schema mixity-fit-1, "answer", "advice",
/// "parameters", "drawn": (experiment.h), "definition": "fits/NAME.toml", "used": CSV}.
std::string fit_files(const std::string& list, const std::string& constants, const std::string& options,
                      emscripten::val progress) {
  return guarded([&] {
    const Analysis result = run(request_of(names_in(list), constants, options), [&](double part) { progress(part); });
    return Json{{"fits", fits_document({&result, 1})},
                {"answer", as_told(answer_of(result), result.data)},
                {"advice", as_advised(result)},
                {"parameters", as_listed(result)},
                {"drawn", as_drawn(result)},
                {"definition", fit_definition_text(result.request, result.data, "fit.toml")},
                {"used", used_csv(result.data)}};
  });
}

/// Defines a law in the syntax of the flag --law in place of the last one, which stays if this one is wrong. {"model":
/// key, "shown", "parameters": [{"name", "lower", "upper", "start"}], "warnings": [text]}.
std::string define(const std::string& text) {
  return guarded([&] {
    std::vector<std::shared_ptr<const UserLaw>> former;
    for (const std::string& key : law_keys()) former.push_back(find_law(key));
    forget_laws();
    DefinedLaw defined;
    try {
      defined = define_law_text("law", text);
    } catch (...) {
      LawError none;  // they were defined before
      for (const auto& law : former) add_law(law, none);
      throw;
    }
    const LawDefinition& law = defined.law->definition();
    const auto parameter = [](const LawParameter& one) {
      return Json{{"name", one.name}, {"lower", one.lower}, {"upper", one.upper}, {"start", one.start}};
    };
    return Json{{"model", law.key},
                {"shown", defined.law->shown()},
                {"parameters", list_of(law.parameters, parameter)},
                {"warnings", defined.warnings}};
  });
}

/// Reads a written fit definition: {"data": [name]} and the fields of request_fields. Forgets all laws before and
/// after, since typed laws may have the keys of its laws.
std::string read_definition(const std::string& name) {
  return guarded([&] {
    struct Forgetting {
      Forgetting() { forget_laws(); }
      ~Forgetting() { forget_laws(); }
    } before_and_after;
    const FitRequest request = read_fit_definition(name);
    const auto name_of = [](const std::string& path) { return std::filesystem::path(path).filename().string(); };
    Json data = Json::array();
    if (request.runs.empty()) data.push_back(name_of(request.data_path));
    for (const RunFile& run : request.runs) {
      if (!run.name.empty() || !run.load.empty() || !run.sphere.empty())
        throw InputError(name,
                         "states names, loads or spheres of runs, which only the program takes: mixity fit " + name);
      data.push_back(name_of(run.path));
    }
    Json told{{"data", data}};
    told.update(request_fields(request, request.constants));
    return told;
  });
}

std::string draw(const std::string& request) {
  return guarded([&] { return drawn_models(Json::parse(request)); });
}

RegimeMap map_for(const Json& request) {
  return {model_of(request.at("model")),
          request.at("parameters").get<std::vector<double>>(),
          {request.at("axis"), request.at("low"), request.at("high"), request.at("logarithmic"), request.at("P_low"),
           request.at("P_high")}};
}

/// A map of regimes for {"model", "parameters": [value], "axis": index of the parameter, "low", "high": its ends,
/// "logarithmic", "P_low", "P_high"}, loads dimensionless: {"regions": [{"regime", "outline": [[P, parameter]]}]}.
std::string map_of(const std::string& request) {
  return guarded([&] {
    RegimeMap map = map_for(Json::parse(request));
    while (map.add_line()) continue;
    return Json{{"regions", list_of(map.regions(false), [](const RegimeRegion& region) {
                   return Json{{"regime", region.regime ? regime_text(*region.regime) : "no unique equilibrium"},
                               {"outline", region.outline}};
                 })}};
  });
}

}  // namespace

EMSCRIPTEN_BINDINGS(mixity) {
  emscripten::register_vector<double>("Doubles");
  emscripten::function("areas", &areas_at);
  emscripten::function("write", &write_file);
  emscripten::function("read", &read_files);
  emscripten::function("cut", &cut_files);
  emscripten::function("fit", &fit_files);
  emscripten::function("definition", &read_definition);
  emscripten::function("define", &define);
  emscripten::function("draw", &draw);
  emscripten::function("map", &map_of);
  emscripten::function(
      "version", +[] { return std::string(MIXITY_VERSION); });
}

}  // namespace mixity::explorer
