#include "report/report_json.h"

#include "analysis/answer.h"
#include "report/fit_statistics_json.h"
#include "report/fit_table.h"
#include "report/versions.h"

namespace mixity {
namespace {

Json sahli_json(const std::optional<SahliResult>& sahli) {
  if (!sahli) return {};
  Json runs = Json::array();
  for (const SahliRun& run : sahli->runs)
    runs.push_back({{"curve", run.curve},
                    {"P", run.P},
                    {"points", run.points},
                    {"A0", run.A0},
                    {"A0_stderr", number_or_null(run.A0_stderr)},
                    {"alpha", run.alpha},
                    {"alpha_stderr", number_or_null(run.alpha_stderr)},
                    {"alpha_predicted", number_or_null(run.alpha_predicted)}});
  Json law;
  if (sahli->power_law)
    law = {{"factor", sahli->power_law->factor},
           {"exponent", sahli->power_law->exponent},
           {"exponent_stderr", number_or_null(sahli->power_law->exponent_stderr)}};
  return {{"runs", runs}, {"power_law", law}};
}

Json peaks_json(const std::optional<PeakForces>& peaks, const std::vector<PredictedPeaks>& predicted) {
  if (!peaks) return {};
  Json rows = Json::array();
  for (const PeakForce& row : peaks->rows)
    rows.push_back({{"line", row.line},
                    {"P", row.P},
                    {"peak_stress", number_or_null(row.peak)},
                    {"minimum_stress", number_or_null(row.minimum)}});
  Json models = Json::array();
  for (const PredictedPeaks& one : predicted) {
    Json loads = Json::array();
    for (const PredictedPeak& load : one.loads)
      loads.push_back({{"P", load.P}, {"stress", load.stress}, {"low", load.low}, {"high", load.high}});
    models.push_back({{"model", one.model},
                      {"loads", loads},
                      {"ratio", number_or_null(one.ratio)},
                      {"ratio_error", number_or_null(one.ratio_error)}});
  }
  return {{"path", peaks->path},
          {"provenance", to_string(peaks->metadata.provenance)},
          {"force_unit", peaks->force_unit},
          {"stress_unit", peaks->stress_unit},
          {"rows", rows},
          {"predicted", models},
          {"excluded", excluded_json(peaks->excluded, nullptr)}};
}

Json answer_json(const Answer& answer) {
  if (!answer.fit) return {};
  Json jumps = Json::array();
  for (const PredictedJump& jump : answer.jumps)
    jumps.push_back({{"P", jump.P},
                     {"T", number_or_null(jump.T.value)},
                     {"T_stderr", number_or_null(jump.T.standard_error)},
                     {"A", number_or_null(jump.A.value)},
                     {"A_stderr", number_or_null(jump.A.standard_error)},
                     {"largest_T", jump.largest_T}});
  return {{"model", answer.fit->model}, {"result", answer.result}, {"jumps", jumps}, {"cannot_say", answer.cannot_say}};
}

/// `svg`: those of this entry's figures and further ones; moves on past them.
Json entry_json(const ReportEntry& entry, std::vector<std::string>::const_iterator& svg) {
  Json json = dataset_json(entry.data->result);
  Json settings = Json::object(), figures = Json::array(), left_out = Json::array();
  for (const auto& [name, value] : fit_settings(entry.data->result)) settings[name] = value;
  for (const FigureGroup& group : entry.figures.groups)
    for (const Figure& figure : group.figures) {
      Json files = Json::array();
      const bool drawn = !(svg++)->empty();
      for (const char* ending : {".dat", ".gp", ".svg", ".pdf", ".png"})
        if (!figure.drawn.empty() ? ending[1] == 's' : drawn || ending[1] == 'd' || ending[1] == 'g')
          files.push_back("figures/" + figure.name + ending);
      figures.push_back(
          {{"name", figure.name}, {"title", figure.title}, {"caption", figure.caption}, {"files", files}});
    }
  for (const MissingFigure& figure : entry.figures.left_out)
    left_out.push_back({{"figure", figure.what}, {"reason", figure.why}});
  json["answer"] = answer_json(entry.answer);
  json["settings"] = settings;
  json["findings"] = findings(entry.data->result);
  json["assumptions"] = assumptions(entry.data->result);
  json["sahli"] = sahli_json(entry.data->sahli);
  json["peaks"] = peaks_json(entry.data->peaks, entry.data->predicted_peaks);
  json["figures"] = figures;
  json["figures_left_out"] = left_out;
  return json;
}

}  // namespace

std::string report_json(const ReportContent& content) {
  Json datasets = Json::array(), made_with = Json::object();
  auto svg = content.drawn.svg.begin();
  for (const ReportEntry& entry : content.entries) datasets.push_back(entry_json(entry, svg));
  for (const auto& [name, version] : versions()) made_with[name] = version;
  return json_text({{"schema", "mixity-report-1"},
                    {"version", MIXITY_VERSION},
                    {"command", content.settings.command},
                    {"made_with", made_with},
                    {"missing", content.drawn.missing.empty() ? Json() : Json(content.drawn.missing)},
                    {"datasets", datasets}});
}

}  // namespace mixity
