#include <algorithm>
#include <optional>

#include "base/number_text.h"
#include "base/units.h"
#include "fitting/explanations.h"

namespace mixity {
namespace {

/// Every n-th point if there are more than enough.
Points thinned(const Points& points, std::size_t enough) {
  const std::size_t step = points.size() / enough + 1;
  Points some;
  for (std::size_t i = 0; i < points.size(); i += step) some.push_back(points[i]);
  return some;
}

/// The constants of the fit that are taken as exact and that have a score test.
std::vector<Constant> exact_constants(const FitResult& fit) {
  std::vector<Constant> list;
  for (const ExactConstant& one : fit.budget->exact)
    for (const Constant c : kAllConstants)
      if (one.score && one.constant == kConstantNames[c]) list.push_back(c);
  return list;
}

std::string lambda_text(const FitResult& fit) {
  for (const FittedParameter& one : fit.parameters)
    if (!one.held && one.value && !one.prior) return one.name + " = " + rounded(*one.value, 4);
  return {};
}

std::string before_and_after(const FitResult& fit, const FitResult& after) {
  const double before = per_freedom(fit), now = per_freedom(after);
  return fit.known_errors ? "chi^2 per degree of freedom falls from " + rounded(before, 3) + " to " + rounded(now, 3)
                          : "the squares of the residuals fall to " + rounded(100 * now / before, 2) + "%";
}

Message constant_text(const Freed& freed, const FitResult& fit) {
  const FittedParameter& constant = *find_parameter(freed.fit.parameters, kConstantNames[freed.constant]);
  const ReadableUnit shown = readable_unit(*constant.value, constant.unit);
  const std::string value =
      rounded(*constant.value * shown.factor, 4) + (constant.unit.empty() ? "" : " " + shown.unit);
  const char* const alike = freed.constant == kModulus     ? " (or area_scale, which acts like it)"
                            : freed.constant == kAreaScale ? " (or modulus, which acts like it)"
                                                           : "";
  return constant.name + alike + " looks wrong: at " + value + ", " + before_and_after(fit, freed.fit) + " and " +
         lambda_text(freed.fit) + "; check it, state its standard error, or " + Remedy::set("free", constant.name);
}

/// `used`: how many points were tried.
Message sliding_text(const Case& of, const FitResult& whole, const Cut& cut, std::size_t used) {
  const std::size_t all = of.fit.used.size();
  return (used == all ? "" : "of every " + std::to_string(all / used) + "th point ") + std::to_string(cut.points) +
         " points lie past the onset of sliding, the first in " + of.data.line_text(of.data.points[cut.first].line) +
         ": cut the runs there; without them " + lambda_text(cut.fit) + " and " + before_and_after(whole, cut.fit);
}

/// What may be the cause.
struct Suspects {
  std::vector<Constant> constants;
  bool sliding;
};

/// Tries the causes on some of many points first: a cause that does not explain these does not explain all, except in
/// one case of ten thousand.
Suspects suspects(const Case& of, const Points& points) {
  constexpr std::size_t kSome = 50;
  Suspects all{exact_constants(of.fit), of.data.has_loads && !of.left_behind};
  if (points.size() < 2 * kSome) return all;
  const Points some = thinned(points, kSome);
  if (const FitResult whole = of.refit(of.options, some, &of.fit.parameters);
      !is_found(whole) || explains(of.data, whole))
    return all;
  const std::vector<Freed> tried = freed_one_by_one(of, all.constants, some);
  Suspects left{{}, false};
  for (const Freed& one : tried)
    if (explains(of.data, one.fit)) left.constants.push_back(one.constant);
  if (left.constants.empty() && !tried.empty() && !of.left_behind) left.constants.push_back(best_of(tried)->constant);
  if (!all.sliding) return left;
  const std::optional<Cut> cut = before_sliding(of, some, 1);
  left.sliding = cut && explains(of.data, cut->fit);
  return left;
}

}  // namespace

Diagnosis diagnose(const Dataset& data, const FitResult& fit, const FitOptions& options, const Refit& refit,
                   bool left_behind) {
  const Message failed = failed_test(fit);
  if (failed.empty() || !fit.budget || fit.loss_scale > 0) return {failed};
  constexpr std::size_t kEnough = 5000;  // points to distinguish causes
  const Case of{data, fit, options, refit, left_behind};
  const Points points = thinned(fit.used, kEnough);
  const bool all_points = points.size() == fit.used.size();
  const FitResult whole = all_points ? fit : refit(options, points, &fit.parameters);
  if (!is_found(whole)) return {failed};
  const Suspects tried = suspects(of, points);
  const std::vector<Freed> list = freed_one_by_one(of, tried.constants, points);
  const Freed* const freed = best_of(list);
  if (freed && explains(data, freed->fit) && is_better(whole, freed->fit, fit.budget->independent))
    return {constant_text(*freed, whole), all_points ? std::optional(comparable_squares(freed->fit)) : std::nullopt};
  if (left_behind) return {failed};
  const auto cut = tried.sliding ? before_sliding(of, points, kFew) : std::nullopt;
  if (cut && explains(data, cut->fit)) return {sliding_text(of, whole, *cut, points.size())};
  if (data.has_loads && fit.consistency && fit.consistency->residuals.ends_p < kChance)
    if (const FitResult without = without_ends(of, whole, points); is_found(without) && explains(data, without))
      return {failed + " without the last tenth of each run " + lambda_text(without)};
  if (!wrong_constant(fit) || !freed) return {failed};
  return {"the model or more than one constant is wrong: freeing " + std::string(kConstantNames[freed->constant]) +
          " helps most (" + before_and_after(whole, freed->fit) + ") and does not explain the rest"};
}

}  // namespace mixity
