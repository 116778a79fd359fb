#include "report/job_fields.h"

#include "analysis/laws.h"
#include "analysis/settings.h"

namespace mixity {

nlohmann::ordered_json job_fields(const FitRequest& request, const Overrides& constants) {
  using Json = nlohmann::ordered_json;
  Json stated = Json::object(), options = Json::object(), laws = Json::object();
  for (const auto& [name, text] : constants) stated[name] = text;
  for (const auto& [name, text] : stated_options(request))
    if (name != "models" && name != "bootstrap" && name != "influence" && name != "per" && name != "threads")
      options[name] = text;
  for (const std::string& model : request.models)
    if (const auto law = find_law(model)) laws[model] = law_text(law->definition());
  return {{"constants", stated}, {"options", options}, {"models", request.models}, {"laws", laws}};
}

}  // namespace mixity
