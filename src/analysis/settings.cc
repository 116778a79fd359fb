#include "analysis/settings.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "analysis/laws.h"
#include "analysis/request.h"
#include "base/number_text.h"
#include "base/trim.h"

namespace mixity {
namespace {

using Complaint = std::string;  // empty: none

std::string in_quotes(std::string_view text) { return "'" + std::string(text) + "'"; }

Complaint must_be(std::string_view text, const std::string& what) {
  return "is " + in_quotes(text) + "; it must be " + what;
}

/// "a, b, c".
std::string listed(const auto& names, const char* last = ", ") {
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i)
    list += (i == 0 ? "" : i + 1 == names.size() ? last : ", ") + std::string(names[i]);
  return list;
}

/// Calls use(item) for each item between commas, until one has a problem.
Complaint for_each_item(std::string_view text, const auto& use) {
  std::vector<std::string> items;
  if (text.empty()) return "is empty";
  for (bool more = true; more;) {
    const std::size_t comma = text.find(',');
    const std::string item(trim(text.substr(0, comma)));
    if (item.empty()) return "has an empty entry, number " + std::to_string(items.size() + 1);
    if (std::find(items.begin(), items.end(), item) != items.end()) return "names " + in_quotes(item) + " twice";
    if (Complaint problem = use(item); !problem.empty()) return problem;
    items.push_back(item);
    more = comma != std::string_view::npos;
    if (more) text.remove_prefix(comma + 1);
  }
  return {};
}

template <class Value>
Complaint choose(std::string_view text, std::initializer_list<Value> values, Value& chosen) {
  std::vector<std::string_view> names;
  for (const Value value : values) {
    names.push_back(to_string(value));
    if (text == names.back()) {
      chosen = value;
      return {};
    }
  }
  return must_be(text, listed(names, " or "));
}

Complaint set_bool(std::string_view text, bool& value) {
  if (text != "true" && text != "false") return must_be(text, "true or false");
  value = text == "true";
  return {};
}

template <class Whole>
Complaint set_whole(std::string_view text, Whole most, Whole& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value > most)
    return must_be(text, "a whole number from 0 to " + std::to_string(most));
  return {};
}

/// Above 0 and below `below`.
Complaint set_number(std::string_view text, double below, double& value) {
  const auto number = parse_number(text);
  if (!number || !(*number > 0 && *number < below))
    return must_be(text, "a number above 0" + (std::isinf(below) ? "" : " and below " + shortest(below)));
  value = *number;
  return {};
}

Complaint set_error(std::string_view text, std::optional<StatedError>& error) {
  auto quantity = parse_quantity(text);
  if (!quantity || !(quantity->value >= 0)) return must_be(text, "a percentage or a quantity of 0 or more");
  error = std::move(quantity);
  return {};
}

Complaint set_models(std::string_view text, FitRequest& request) {
  request.models.clear();
  return for_each_item(text, [&](const std::string& model) -> Complaint {
    provide_law(model);
    if (!is_model(model))
      return "names the unknown model " + in_quotes(model) + " (known: " + listed(known_models()) + ")";
    request.models.push_back(model);
    return {};
  });
}

Complaint set_hold(std::string_view text, std::vector<HeldParameter>& hold) {
  hold.clear();
  return for_each_item(text, [&](const std::string& item) -> Complaint {
    const auto held = parse_held(item);
    if (!held) return "has " + in_quotes(item) + ", which is neither a parameter nor PARAMETER=NUMBER";
    if (std::any_of(hold.begin(), hold.end(), [&](const HeldParameter& other) { return other.name == held->name; }))
      return "names " + in_quotes(held->name) + " twice";
    hold.push_back(*held);
    return {};
  });
}

/// Parameters of the models may be named, too: they are free unless they are held.
Complaint set_free(std::string_view text, FitRequest& request) {
  request.options.free.clear();
  request.free_parameters.clear();
  return for_each_item(text, [&](const std::string& name) -> Complaint {
    const auto found = std::find(kConstantNames.begin(), kConstantNames.end(), name);
    if (found != kConstantNames.end())
      request.options.free.push_back(static_cast<Constant>(found - kConstantNames.begin()));
    else if (has_parameter(model_keys(), name))
      request.free_parameters.push_back(name);
    else
      return "names " + in_quotes(name) + ", which cannot be fitted (known: " + listed(kConstantNames) +
             ", model parameters)";
    return {};
  });
}

Complaint set_objective(std::string_view text, FitOptions& options) {
  if (text == "area") return "is 'area'; " + std::string(kNoAreaObjective);
  options.objective = parse_objective(text);
  return options.objective ? Complaint() : must_be(text, "toughness or curve");
}

Complaint set_excluded(std::string_view text, std::vector<LineRange>& lines) {
  lines.clear();
  return for_each_item(text, [&](const std::string& item) -> Complaint {
    const auto range = parse_lines(item);
    if (!range) return "has " + in_quotes(item) + ", which is neither a line of the file nor lines such as 40-58";
    lines.push_back(*range);
    return {};
  });
}

Complaint set_it(FitRequest& request, std::string_view name, std::string_view text) {
  constexpr std::size_t kMostReplicates = 10000000;
  FitOptions& options = request.options;
  if (name == "models") return set_models(text, request);
  if (name == "objective") return set_objective(text, options);
  if (name == "scale") return choose(text, {Scale::log, Scale::linear}, options.scale.emplace());
  if (name == "weighted") return set_bool(text, options.weighted);
  if (name == "sigma_T") return set_error(text, options.sigma_T);
  if (name == "sigma_A") return set_error(text, options.sigma_A);
  if (name == "loss") return choose(text, {Loss::none, Loss::huber, Loss::cauchy}, options.loss);
  if (name == "loss_scale")
    return set_number(text, std::numeric_limits<double>::infinity(), options.loss_scale.emplace());
  if (name == "hold") return set_hold(text, options.hold);
  if (name == "free") return set_free(text, request);
  if (name == "exclude") return set_excluded(text, request.exclusion.lines);
  if (name == "leave_out") {
    request.exclusion.runs.clear();
    return for_each_item(text,
                         [&](const std::string& run) { return request.exclusion.runs.push_back(run), Complaint(); });
  }
  if (name == "interval") {
    options.intervals = text == "profile";
    return text == "profile" || text == "none" ? Complaint() : must_be(text, "profile or none");
  }
  if (name == "confidence") return set_number(text, 1, options.confidence);
  if (name == "checks") return set_bool(text, options.checks);
  if (name == "lambda_prior") return choose(text, {RangePrior::uniform, RangePrior::log_uniform}, options.lambda_prior);
  if (name == "bootstrap") return set_whole(text, kMostReplicates, options.bootstrap.replicates);
  if (name == "resample") return choose(text, {Resample::points, Resample::curves}, options.bootstrap.resample);
  if (name == "seed")
    return set_whole<std::uint64_t>(text, std::numeric_limits<std::int64_t>::max(), options.bootstrap.seed);
  if (name == "threads") return set_whole(text, 4096U, options.bootstrap.threads);
  if (name == "influence") return set_bool(text, options.influence);
  if (name == "compare") return set_bool(text, request.compare);
  if (name == "per") {
    request.per_curve = text == "curve";
    return request.per_curve ? Complaint() : must_be(text, "curve");
  }
  throw std::invalid_argument("there is no option '" + std::string(name) + "'");
}

}  // namespace

std::string set_option(FitRequest& request, std::string_view name, std::string_view text) {
  Complaint problem = set_it(request, name, text);
  if (problem.empty()) request.stated.insert_or_assign(std::string(name), std::string(text));
  return problem;
}

std::optional<Contradiction> contradiction(const FitRequest& request) {
  const FitOptions& options = request.options;
  const auto curve = Objective::curve, toughness = Objective::toughness;
  for (const HeldParameter& held : options.hold) {
    if (!has_parameter(request.models, held.name))
      return Contradiction{"hold", "names " + in_quotes(held.name) + ", which no fitted model has"};
    if (std::find(request.free_parameters.begin(), request.free_parameters.end(), held.name) !=
        request.free_parameters.end())
      return Contradiction{"free", "names " + in_quotes(held.name) + ", which is to be held"};
  }
  for (const std::string& name : request.free_parameters)
    if (!has_parameter(request.models, name))
      return Contradiction{"free", "names " + in_quotes(name) + ", which no fitted model has"};
  if (options.scale && options.objective == curve) return Contradiction{"scale", "needs objective=toughness"};
  if (options.weighted && options.objective == curve)
    return Contradiction{"weighted", "needs objective=toughness; curve weighs the points anyway"};
  if ((options.sigma_T || options.sigma_A) && options.objective == toughness && !options.weighted)
    return Contradiction{options.sigma_A ? "sigma_A" : "sigma_T", "needs objective=curve, or weighted"};
  if (options.loss_scale && options.loss == Loss::none)
    return Contradiction{"loss_scale", "needs loss=huber or cauchy"};
  const bool resampled = options.bootstrap.replicates > 0;
  for (const char* name : {"resample", "seed"})
    if (request.stated.contains(name) && !resampled) return Contradiction{name, "needs bootstrap"};
  if (request.stated.contains("threads") && !resampled && !options.influence)
    return Contradiction{"threads", "needs bootstrap or influence"};
  if (request.stated.contains("confidence") && !options.intervals && !resampled)
    return Contradiction{"confidence", "needs interval=profile, or bootstrap"};
  return std::nullopt;
}

}  // namespace mixity
