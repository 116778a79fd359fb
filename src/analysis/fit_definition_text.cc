#include <algorithm>
#include <sstream>

#include "analysis/fit_definition.h"
#include "analysis/laws.h"
#include "analysis/settings.h"
#include "base/files.h"
#include "base/number_text.h"
#include "base/phrases.h"
#include "base/toml_file.h"
#include "mechanics/laws/known_laws.h"

namespace mixity {
namespace {

/// KEY = "text".
std::string stated(std::string_view key, const std::string& text) {
  return std::string(key) + " = " + toml_text(text) + '\n';
}

std::string stated_if_any(std::string_view key, const std::string& text) {
  return text.empty() ? "" : stated(key, text);
}

/// KEY = ["text", "text"].
std::string stated(std::string_view key, const std::vector<std::string>& texts) {
  return std::string(key) + " = [" + joined(texts_of(texts, [](const std::string& one) { return toml_text(one); })) +
         "]\n";
}

}  // namespace

std::string fit_definition_text(const FitRequest& request, const Dataset& data, const std::string& path) {
  const auto from_there = [&](const std::string& file) { return relative_to(path, file); };
  const bool told_apart = std::any_of(request.runs.begin(), request.runs.end(), [](const RunFile& run) {
    return !run.name.empty() || !run.load.empty() || !run.sphere.empty();
  });
  std::ostringstream out;
  std::vector<std::string> files, figures;
  for (const RunFile& run : request.runs) files.push_back(from_there(run.path));
  for (const std::string& figure : request.log_figures) figures.push_back(from_there(figure));
  if (request.runs.empty())
    out << stated("data", from_there(request.data_path));
  else if (!told_apart)
    out << stated("data", files);
  if (!request.peaks_path.empty()) out << stated("peaks", from_there(request.peaks_path));
  if (!figures.empty()) out << stated("log_figures", figures);
  for (const Setting& one : settings()) {
    const std::string text = one.write(request);
    // Defaults that depend on the data or on the version of this program are written, too.
    if (one.name == "models")
      out << stated(one.name, request.models);
    else if (one.name == "objective")
      out << stated(one.name, std::string(to_string(request.options.objective.value_or(default_objective(data)))));
    else if (request.stated.contains(one.name))
      out << (one.is_switch ? one.name + " = " + text + '\n' : stated(one.name, text));
  }
  out << stated_if_any("source", request.source);
  if (!request.constants.empty()) out << "\n[constants]\n";
  for (const auto& [name, value] : request.constants) out << stated(name, is_path(name) ? from_there(value) : value);
  if (told_apart)
    for (const RunFile& run : request.runs)
      out << "\n[[runs]]\n"
          << stated("file", from_there(run.path)) << stated_if_any("name", run.name) << stated_if_any("load", run.load)
          << stated_if_any("sphere", run.sphere);
  for (const std::string& model : request.models)
    if (const auto law = find_law(model); law && !is_shipped(*law)) out << '\n' << law_toml(law->definition());
  for (const auto& [model, numbers] : request.published) {
    if (std::find(request.models.begin(), request.models.end(), model) == request.models.end()) continue;
    out << "\n[published." << model << "]\n";
    for (const Published& one : numbers)
      out << (one.name.ends_with(')') ? toml_text(one.name) : one.name) << " = {value = " << shortest(one.value)
          << ", tolerance = " << shortest(one.tolerance) << "}\n";  // that of a series is no bare key
  }
  return out.str();
}

}  // namespace mixity
