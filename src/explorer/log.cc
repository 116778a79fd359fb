#include "explorer/log.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <utility>

#include "dataset/dataset.h"
#include "dataset/logs/recording.h"
#include "explorer/drawing.h"
#include "explorer/field_words.h"
#include "report/figures/log_figures.h"
#include "report/figures/svg.h"
#include "report/runs_files.h"

namespace mixity::explorer {
namespace {

bool looks_like_log(const std::string& name, const Overrides& constants) {
  try {
    return load_dataset(name, constants).like_a_log;
  } catch (const MissingConstants& error) {
    Overrides with_some = constants;  // how a file is read does not depend on them
    for (const std::string& missing : error.message().options())
      with_some.emplace_back(missing, missing == "radius" ? "1 mm" : missing == "modulus" ? "1 MPa" : "1 J/m^2");
    return load_dataset(name, with_some).like_a_log;
  }
}

bool is_recording(const std::string& name, const Overrides& constants) {
  Inputs inputs;
  Metadata metadata = metadata_of(name, constants, inputs);
  apply_overrides(constants, metadata);
  try {
    return !read_recordings(name, metadata, inputs, true).empty();
  } catch (const InputError&) {
    return false;
  }
}

Json cut(const CutTime& one) {
  return {{"time", one.time}, {"low", one.low}, {"high", one.high}, {"stated", one.stated}};
}

const char* look_of(Look look) {
  switch (look) {
    case Look::band:
      return "band";
    case Look::circles:
      return "circle";
    case Look::squares:
      return "rect";
    default:
      return "line";
  }
}

Json drawn(const Figure& figure) {
  const auto axis = [](const Axis& one) { return Json{one.label, one.low.value_or(0), one.high.value_or(1)}; };
  return {{"title", figure.title},
          {"x", axis(figure.x)},
          {"y", axis(figure.y)},
          {"series", list_of(figure.series,
                             [](const Series& one) {
                               return Json{{"label", one.label},
                                           {"look", look_of(one.look)},
                                           {"color", themed(one.color)},
                                           {"points", one.points}};
                             })},
          {"caption", figure.caption}};
}

}  // namespace

bool are_logs(const std::vector<std::string>& names, const Overrides& constants) {
  return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
    try {
      return looks_like_log(name, constants);
    } catch (const InputError&) {
      return is_recording(name, constants);
    }
  });
}

Json cut_logs(const std::vector<std::string>& names, const std::string& stem, const Overrides& constants) {
  const ReducedLogs logs = reduce_logs(names, constants, {});
  if (has_no_run(logs)) refuse_without_runs(names.front());
  const std::string runs = stem + "_runs", peaks = stem + "_peaks", cuts = stem + "_cuts.toml";
  const std::map<std::string, std::string> contents{{runs + ".csv", runs_csv(logs)},
                                                    {runs + ".toml", runs_toml(logs)},
                                                    {peaks + ".csv", peaks_csv(logs)},
                                                    {cuts, cuts_toml(logs)}};
  for (const auto& [name, content] : contents) std::ofstream(name, std::ios::binary) << content;
  Json found = Json::array(), figures = Json::array();
  for (const ReducedLog& log : logs)
    for (const LoadingRun& run : log.runs.runs)
      found.push_back({{"name", run.name},
                       {"P", run.P / log.force_factor},
                       {"T", *std::max_element(run.T.begin(), run.T.end()) / log.force_factor},
                       {"frames", run.T.size()},
                       {"shear", cut(run.shear)},
                       {"onset", run.onset ? cut(*run.onset) : Json()},
                       {"falls", run.cycles.size()}});
  const std::vector<Figure> all = log_figures(logs);
  for (std::size_t i = 0; i + 1 < all.size(); i += 2)
    figures.push_back({{"T", drawn(all[i])}, {"A", drawn(all[i + 1])}});
  return {
      {"data", runs + ".csv"},
      {"peaks", peaks + ".csv"},
      {"files", {{"runs", runs + ".csv"}, {"constants", runs + ".toml"}, {"peaks", peaks + ".csv"}, {"cuts", cuts}}},
      {"contents", contents},
      {"text", runs_text(logs, in_fields)},
      {"runs", found},
      {"units", {{"force", logs.front().force_unit}}},
      {"figures", figures}};
}

}  // namespace mixity::explorer
