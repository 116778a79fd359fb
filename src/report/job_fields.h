// What a request says beside its data, as the fields of a page hold it.
#pragma once

#include <nlohmann/json.hpp>

#include "analysis/request.h"

namespace mixity {

/// {"constants": {name: text}, "options": {name: text}, "models": [key], "laws": {key: text of the law as it is
/// typed}}. Options without those that take long: a page fits at once.
nlohmann::ordered_json job_fields(const FitRequest& request, const Overrides& constants);

}  // namespace mixity
