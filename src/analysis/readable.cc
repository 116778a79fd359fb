#include "analysis/readable.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace mixity {

FittedParameter readable(FittedParameter parameter) {
  if (parameter.unit.empty()) return parameter;
  const double size = parameter.value.value_or(std::sqrt(std::abs(parameter.lower * parameter.upper)));
  const ReadableUnit shown = readable_unit(size, parameter.unit);
  const auto scale = [&](std::optional<double>& value) {
    if (value) *value *= shown.factor;
  };
  scale(parameter.value);
  scale(parameter.stderr_);
  parameter.lower *= shown.factor;
  parameter.upper *= shown.factor;
  if (parameter.interval) {
    scale(parameter.interval->low);
    scale(parameter.interval->high);
  }
  if (parameter.bootstrap)
    for (double* value : {&parameter.bootstrap->low, &parameter.bootstrap->high,
                          &parameter.bootstrap->standard_deviation, &parameter.bootstrap->bias})
      *value *= shown.factor;
  if (parameter.prior) {
    parameter.prior->mean *= shown.factor;
    parameter.prior->standard_error *= shown.factor;
  }
  if (parameter.profile)
    for (auto& point : parameter.profile->points) point.first *= shown.factor;
  parameter.unit = shown.unit;
  return parameter;
}

std::string in_words(FitStatus status) {
  std::string text(to_string(status));
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

std::string parameter_symbol(const std::string& name) {
  return name == "lambda"       ? "λ"
         : name == "lambda_II"  ? "λ_{II}"
         : name == "lambda_III" ? "λ_{III}"
         : name == "eta"        ? "η"
                                : plain(name);
}

std::string parameter_in_text(const std::string& name) {
  return name.starts_with("lambda") ? "λ" + name.substr(6) : name == "eta" ? "η" : name;
}

std::string plain(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (std::string_view("_^{}@&~\\").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

}  // namespace mixity
