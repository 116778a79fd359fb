#include <algorithm>
#include <cmath>
#include <optional>

#include "base/number_text.h"
#include "base/units.h"
#include "fitting/consistency.h"
#include "fitting/predicted_area.h"
#include "fitting/stated_constants.h"
#include "statistics/distributions.h"

namespace mixity {
namespace {

using Points = std::vector<std::size_t>;

double per_freedom(const FitResult& fit) {
  return fit.sum_of_squares / static_cast<double>(fit.used.size() - fit.free_parameters);
}

bool found(const FitResult& fit) {
  return has_all_values(fit) && fit.status != FitStatus::not_converged && fit.used.size() > fit.free_parameters;
}

std::string with_unit(double value, const std::string& unit) {
  const ReadableUnit shown = readable_unit(value, unit);
  return rounded(value * shown.factor, 4) + (unit.empty() ? "" : " " + shown.unit);
}

/// Of many points every so many-th.
Points thinned(const Points& points, std::size_t enough) {
  const std::size_t step = points.size() / enough + 1;
  Points some;
  for (std::size_t i = 0; i < points.size(); i += step) some.push_back(points[i]);
  return some;
}

/// The fit with one more constant free.
struct Freed {
  Constant constant;
  FitResult fit;
};

/// The constants of the fit that are taken as exact and that the data tell something of.
std::vector<Constant> exact_constants(const FitResult& fit) {
  std::vector<Constant> list;
  for (const ExactConstant& one : fit.budget->exact) {
    const auto name = std::find(kConstantNames.begin(), kConstantNames.end(), one.constant);
    if (one.score) list.push_back(kAllConstants[static_cast<std::size_t>(name - kConstantNames.begin())]);
  }
  return list;
}

/// Those of the constants with which a fit is found.
std::vector<Freed> freed_one_by_one(const std::vector<Constant>& constants, const FitResult& fit,
                                    const FitOptions& options, const Points& points, const Refit& refit) {
  std::vector<Freed> list;
  for (const Constant constant : constants) {
    FitOptions freed = options;
    freed.free.push_back(constant);
    if (FitResult with = refit(freed, points, &fit.parameters); found(with))
      list.push_back({constant, std::move(with)});
  }
  return list;
}

/// The fit of the points before the onset of sliding, and of how many behind it.
struct Cut {
  FitResult fit;
  std::size_t points, first;  // how many were left out; the first of them in the file
};

/// Where the rest of a run is far off, but for a few: the index in the run, or its size. `off`: one per point.
std::size_t onset(const std::vector<bool>& off) {
  double sum = 0, most = 0;
  std::size_t at = off.size();
  for (std::size_t i = off.size(); i-- > 0;) {
    sum += off[i] ? 1 : -1.5;
    if (sum > most) {
      most = sum;
      at = i;
    }
  }
  return at;
}

/// That which lowers chi^2 most; of two that act alike the first.
const Freed* best_of(const std::vector<Freed>& list) {
  const Freed* best = nullptr;
  for (const Freed& one : list)
    if (!best || one.fit.sum_of_squares < (1 - 1e-6) * best->fit.sum_of_squares) best = &one;
  return best;
}

constexpr std::size_t kFew = 3;  // points that noise may have put behind an onset

/// Fits what lies before the onset: the first half of each run, and then as far on as the points agree with that. Fewer
/// points than `few` behind it are noise.
std::optional<Cut> before_sliding(const Dataset& data, const FitResult& fit, const FitOptions& options,
                                  const Points& points, std::size_t few, const Refit& refit) {
  constexpr double kFar = 4;  // standard errors of a residual
  constexpr int kRounds = 8;
  std::vector<Points> runs(data.curves.size());
  for (const std::size_t i : points) runs[data.points[i].curve].push_back(i);
  Points before;
  for (Points& run : runs) {
    if (run.empty()) continue;
    if (data.points[run.back()].shear() < data.points[run.front()].shear()) std::reverse(run.begin(), run.end());
    double largest = 0;
    for (const std::size_t i : run) largest = std::max(largest, data.points[i].shear());
    for (const std::size_t i : run) {
      if (data.points[i].shear() > 0.5 * largest) break;
      before.push_back(i);
    }
  }
  std::vector<FittedParameter> near;
  for (int round = 0; round < kRounds && before.size() > fit.free_parameters + kFew; ++round) {
    FitResult start = refit(options, before, near.empty() ? nullptr : &near);
    if (!found(start)) return std::nullopt;
    near = start.parameters;
    FitOptions as_found = options;
    as_found.hold.clear();
    for (const FittedParameter& one : start.parameters) as_found.hold.push_back({one.name, one.value});
    as_found.constants = with_fitted(options.constants.value_or(stated_constants(data)), data, start.parameters);
    as_found.free.clear();
    const FitResult all = refit(as_found, points, nullptr);
    if (all.residuals.empty()) return std::nullopt;
    std::vector<bool> off(data.points.size(), false);
    for (std::size_t k = 0; k < all.used.size(); ++k)
      off[all.used[k]] = std::abs(all.residuals[k]) > kFar * residual_unit(start);
    Points next;
    std::size_t left_out = 0, first = data.points.size();
    for (const Points& run : runs) {
      std::vector<bool> of_run;
      for (const std::size_t i : run) of_run.push_back(off[i]);
      const std::size_t end = onset(of_run);
      next.insert(next.end(), run.begin(), run.begin() + static_cast<std::ptrdiff_t>(end));
      left_out += run.size() - end;
      if (end < run.size()) first = std::min(first, run[end]);
    }
    if (left_out < few) return std::nullopt;
    if (next == before) return Cut{std::move(start), left_out, first};
    before = std::move(next);
  }
  return std::nullopt;
}

/// The fit without what lies above nine tenths of each run's largest shear.
FitResult without_ends(const Dataset& data, const FitResult& whole, const FitOptions& options, const Points& points,
                       const Refit& refit) {
  std::vector<double> largest(data.curves.size());
  for (const std::size_t i : points)
    largest[data.points[i].curve] = std::max(largest[data.points[i].curve], data.points[i].shear());
  Points before = points;
  std::erase_if(before, [&](std::size_t i) { return data.points[i].shear() > 0.9 * largest[data.points[i].curve]; });
  return refit(options, before, &whole.parameters);
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

/// Whether nothing is left to explain.
bool explains(const Dataset& data, const FitResult& fit) {
  constexpr double kHardly = 1e-5;  // an explanation need not be perfect
  if (fit.residuals.empty()) return false;
  const Consistency left = test_consistency(data, fit);
  return left.chi2_p.value_or(1) > kHardly && !is_far(left.residuals) && left.residuals.runs_p > kHardly &&
         left.residuals.correlation_p > kHardly && left.residuals.trend_p > kHardly && left.residuals.ends_p > kHardly;
}

/// Whether chi^2 falls by more than chance makes it, when the best of so many constants is free.
bool is_better(const FitResult& fit, const FitResult& freed, double constants) {
  const double fall = (fit.sum_of_squares - freed.sum_of_squares) / (fit.known_errors ? 1 : per_freedom(freed));
  return fall > 0 && chi_squared_p_value(fall, 1) * constants < kChance;
}

std::string alike(Constant constant) {
  if (constant == kModulus) return " (or area_scale, which acts like it)";
  if (constant == kAreaScale) return " (or modulus, which acts like it)";
  return {};
}

Message constant_text(const Freed& freed, const FitResult& fit) {
  const FittedParameter& constant =
      *std::find_if(freed.fit.parameters.begin(), freed.fit.parameters.end(),
                    [&](const FittedParameter& one) { return one.name == kConstantNames[freed.constant]; });
  return constant.name + alike(freed.constant) + " looks wrong: at " + with_unit(*constant.value, constant.unit) +
         ", " + before_and_after(fit, freed.fit) + " and " + lambda_text(freed.fit) +
         "; check it, state its standard error, or " + Remedy::set("free", constant.name);
}

/// What may be the cause. A cause that explains all points explains some of them as well, but for one case in ten
/// thousand, and a wrong model is told by a few: what does not explain these need not be tried on all.
struct Suspects {
  std::vector<Constant> constants;
  bool sliding;
};

Suspects suspects(const Dataset& data, const FitResult& fit, const FitOptions& options, const Points& points,
                  const Refit& refit, bool left_behind) {
  constexpr std::size_t kSome = 50;
  Suspects all{exact_constants(fit), data.has_loads && !left_behind};
  const Points some = thinned(points, kSome);
  if (points.size() < 2 * kSome) return all;
  if (const FitResult whole = refit(options, some, &fit.parameters); !found(whole) || explains(data, whole)) return all;
  const std::vector<Freed> tried = freed_one_by_one(all.constants, fit, options, some, refit);
  Suspects left{{}, false};
  for (const Freed& one : tried)
    if (explains(data, one.fit)) left.constants.push_back(one.constant);
  if (left.constants.empty() && !tried.empty() && !left_behind) left.constants.push_back(best_of(tried)->constant);
  if (!all.sliding) return left;
  const std::optional<Cut> cut = before_sliding(data, fit, options, some, 1, refit);
  left.sliding = cut && explains(data, cut->fit);
  return left;
}

}  // namespace

Diagnosis diagnose(const Dataset& data, const FitResult& fit, const FitOptions& options, const Refit& refit,
                   bool left_behind) {
  const Message failed = failed_test(fit);
  if (failed.empty() || !fit.budget || fit.loss_scale > 0) return {failed};
  constexpr std::size_t kEnough = 5000;  // to tell one cause from another
  const Points points = thinned(fit.used, kEnough);
  const FitResult whole = points.size() == fit.used.size() ? fit : refit(options, points, &fit.parameters);
  if (!found(whole)) return {failed};
  const Suspects tried = suspects(data, fit, options, points, refit, left_behind);
  const std::vector<Freed> list = freed_one_by_one(tried.constants, fit, options, points, refit);
  const Freed* const freed = best_of(list);
  if (freed && explains(data, freed->fit) && is_better(whole, freed->fit, fit.budget->independent))
    return {constant_text(*freed, whole),
            points.size() == fit.used.size() ? std::optional(freed->fit.sum_of_squares) : std::nullopt};
  if (left_behind) return {failed};
  const std::optional<Cut> cut =
      tried.sliding ? before_sliding(data, fit, options, points, kFew, refit) : std::optional<Cut>();
  if (cut && explains(data, cut->fit))
    return {(points.size() == fit.used.size()
                 ? ""
                 : "of every " + std::to_string(fit.used.size() / points.size()) + "th point ") +
            std::to_string(cut->points) + " points lie past the onset of sliding, the first in " +
            data.line_text(data.points[cut->first].line) + ": cut the runs there; without them " +
            lambda_text(cut->fit) + " and " + before_and_after(whole, cut->fit)};
  if (data.has_loads && fit.consistency && fit.consistency->residuals.ends_p < kChance)
    if (const FitResult without = without_ends(data, whole, options, points, refit);
        found(without) && explains(data, without))
      return {failed + " without the last tenth of each run " + lambda_text(without)};
  if (!wrong_constant(fit) || !freed) return {failed};
  return {"the model or more than one constant is wrong: freeing " + std::string(kConstantNames[freed->constant]) +
          " helps most (" + before_and_after(whole, freed->fit) + ") and does not explain the rest"};
}

}  // namespace mixity
