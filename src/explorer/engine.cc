// The engine as a page's script calls it: texts in, JSON out. What throws elsewhere is {"error": SENTENCE} here.
#include <emscripten/bind.h>

#include <cstdint>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "jobs/job.h"
#include "jobs/job_options.h"
#include "mechanics/any_model.h"
#include "report/answer.h"
#include "report/fit_json.h"

namespace mixity {
namespace {

using Json = nlohmann::ordered_json;

std::string guarded(const std::function<std::string()>& work) {
  try {
    return work();
  } catch (const std::exception& error) {
    return Json{{"error", error.what()}}.dump(-1, ' ', false, Json::error_handler_t::replace);
  }
}

std::vector<Values> all_values(const std::vector<double>& parameters) {
  std::vector<Values> all;
  for (const double& one : parameters) all.push_back({&one, 0});
  return all;
}

double* at(std::uintptr_t address) { return reinterpret_cast<double*>(address); }

/// Areas at n loads T, both arrays of doubles in the module's memory; NaN where there is no equilibrium.
void areas_at(const std::string& model, const std::vector<double>& parameters, double P, std::uintptr_t T,
              std::uintptr_t A, std::size_t n) {
  const std::vector<Values> all = all_values(parameters);
  std::vector<EquilibriumStatus> status(n);
  areas(model, all, {&P, 0}, {at(T), 1}, {at(A), n}, status);
}

/// Puts a file where `fit` finds it: the TOML beside a data file. Files are passed as Uint8Array: a text of JavaScript
/// would become UTF-8.
void write_file(const std::string& name, const std::string& content) {
  std::ofstream("/" + name, std::ios::binary) << content;
}

/// Fits a data file, whole as it was dropped on the page, with constants and options by their names.
/// {"fits": schema mixity-fit-1, "answer": {...}, "taken": [...], "reading": ...}.
std::string fit_file(const std::string& name, const std::string& content, const std::string& constants,
                     const std::string& options) {
  return guarded([&] {
    write_file(name, content);
    const Json chosen = Json::parse(options), stated = Json::parse(constants);
    FitJob job;
    job.data_path = "/" + name;
    for (const auto& [key, text] : chosen.items())
      if (const std::string problem = set_option(job, key, text.get<std::string>()); !problem.empty())
        throw InputError(key, problem);
    for (const auto& [key, text] : stated.items()) job.constants.emplace_back(key, text.get<std::string>());
    const JobResult result = run(job);
    const Answer answer = answer_of(result);
    Json told{{"fits", Json::parse(to_json({result}))},
              {"reading", result.data.reading},
              {"taken", result.data.taken},
              {"answer",
               {{"result", answer.result},
                {"model", answer.model},
                {"doubt", answer.doubt},
                {"cannot_say", answer.cannot_say}}}};
    return told.dump(-1, ' ', false, Json::error_handler_t::replace);
  });
}

}  // namespace

EMSCRIPTEN_BINDINGS(mixity) {
  emscripten::register_vector<double>("Doubles");
  emscripten::function("areas", &areas_at);
  emscripten::function("fit", &fit_file);
  emscripten::function("write", &write_file);
  emscripten::function(
      "version", +[] { return std::string(MIXITY_VERSION); });
}

}  // namespace mixity
