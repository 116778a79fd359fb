#include "report/fit_json.h"

#include "analysis/judgement.h"
#include "report/fit_statistics_json.h"

namespace mixity {
namespace {

Json parameters_json(const FitResult& fit) {
  Json parameters = Json::object();
  for (const FittedParameter& parameter : fit.parameters)
    parameters[parameter.name] = {{"value", number_or_null(parameter.value)},
                                  {"stderr", number_or_null(parameter.stderr_)},
                                  {"lower", parameter.lower},
                                  {"upper", parameter.upper},
                                  {"at_bound", parameter.at_bound},
                                  {"held", parameter.held},
                                  {"unit", parameter.unit},
                                  {"interval", interval_json(parameter.interval)},
                                  {"bootstrap", bootstrap_json(parameter, fit)},
                                  {"prior", prior_json(parameter)}};
  return parameters;
}

Json area_json(const FitResult& fit, const Dataset& data) {
  if (!fit.area) return {};
  const AreaGoodness& area = *fit.area;
  const bool any = area.predicted > 0;
  return {{"r2", number_or_null(area.r2)},
          {"rmse", any ? Json(area.rmse) : Json()},
          {"max_abs_residual", any ? Json(area.max_abs_residual) : Json()},
          {"unit", data.display.area},
          {"unpredicted", area.unpredicted},
          {"obstacle", area.obstacle.empty() ? Json() : Json(area.obstacle)}};
}

Json paper_json(const FitResult& fit) {
  if (!fit.paper) return {};
  Json parameters = Json::object();
  for (const FittedParameter& parameter : fit.paper->parameters)
    parameters[parameter.name] = number_or_null(parameter.value);
  return {{"status", to_string(fit.paper->status)},
          {"parameters", parameters},
          {"r2", number_or_null(fit.paper->r2)},
          {"points", fit.paper->points}};
}

Json fit_json(const FitResult& fit, const FitRequest& request, const Dataset& data) {
  Json published = Json::object();
  for (const Agreement& agreement : compare(fit, request))
    published[agreement.published.name] = {{"value", agreement.published.value},
                                           {"tolerance", agreement.published.tolerance},
                                           {"agrees", agreement.agrees}};
  return {{"model", fit.model},
          {"objective", to_string(fit.objective)},
          {"scale", to_string(fit.scale)},
          {"status", to_string(fit.status)},
          {"message", fit.message},
          {"parameters", parameters_json(fit)},
          {"used", fit.used.size()},
          {"excluded", excluded_json(fit.excluded, &data)},
          {"r2", number_or_null(fit.r2)},
          {"rmse", number_or_null(fit.rmse)},
          {"max_abs_residual", number_or_null(fit.max_abs_residual)},
          {"errors", errors_json(fit)},
          {"loss_scale", fit.loss_scale > 0 ? Json(fit.loss_scale) : Json()},
          {"correlations", correlations_json(fit)},
          {"influence", influence_json(fit, data)},
          {"area", area_json(fit, data)},
          {"paper", paper_json(fit)},
          {"evidence", evidence_json(fit)},
          {"budget", budget_json(fit)},
          {"consistency", consistency_json(fit, data)},
          {"outdone_by", fit.outdone_by.empty() ? Json() : Json(fit.outdone_by)},
          {"published", published}};
}

}  // namespace

Json excluded_json(const std::vector<Excluded>& excluded, const Dataset* data) {
  Json list = Json::array();
  for (const Excluded& point : excluded) {
    list.push_back({{"line", data ? data->line_in_file(point.line) : point.line}, {"reason", point.reason}});
    if (data && !data->files.empty()) list.back()["file"] = data->file_of(point.line);
  }
  return list;
}

Json dataset_json(const Analysis& result) {
  const Dataset& data = result.data;
  const bool reconstructed = data.metadata.provenance == Provenance::reconstructed;
  Json fits = Json::array();
  for (const FitResult& fit : result.fits) fits.push_back(fit_json(fit, result.request, data));
  return {{"path", data.path},
          {"name", data.name},
          {"provenance", to_string(data.metadata.provenance)},
          {"notice", reconstructed ? Json(kReconstructedNotice) : Json()},
          {"source", data.metadata.source},
          {"notes", data.notes},
          {"points", data.rows},
          {"used", data.points.size()},
          {"excluded", excluded_json(data.excluded, &data)},
          {"constants", constants_json(data)},
          {"unsheared", unsheared_json(result.unsheared)},
          {"fits", fits},
          {"comparison", comparison_json(result)},
          {"per_curve", per_curve_json(result)}};
}

std::string json_text(const Json& document) {
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string to_json(const std::vector<Analysis>& results, const Shard& shard) {
  Json datasets = Json::array();
  for (const Analysis& result : results) datasets.push_back(dataset_json(result));
  Json document{{"schema", "mixity-fit-1"}, {"version", MIXITY_VERSION}};
  if (!shard.part.empty()) {
    document["shard"] = shard.part;
    document["campaign"] = {{"files", shard.files}, {"flags", shard.flags}};
  }
  document["datasets"] = std::move(datasets);
  return json_text(document);
}

}  // namespace mixity
