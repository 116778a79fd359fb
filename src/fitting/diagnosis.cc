#include <algorithm>
#include <iterator>
#include <optional>

#include "base/number_text.h"
#include "base/phrases.h"
#include "dataset/exclusion.h"
#include "fitting/cause_fits.h"
#include "fitting/causes.h"
#include "fitting/circularity.h"
#include "fitting/heavy_points.h"
#include "fitting/pull_off_course.h"
#include "statistics/distributions.h"

namespace mixity {
namespace {

std::string lambda_text(const FitResult& fit) {
  for (const FittedParameter& one : fit.parameters)
    if (!one.held && one.value && !one.prior) return one.name + " = " + rounded(*one.value, 4);
  return {};
}

FittedParameter first_free(const FitResult& fit) {
  for (const FittedParameter& one : fit.parameters)
    if (!one.held) return one;
  return {};
}

std::string before_and_after(const FitResult& fit, const FitResult& after) {
  const double before = per_freedom(fit), now = per_freedom(after);
  // of thousands of points a fall by a thousandth is significant
  const auto text = [&](double misfit) {
    return resolved(misfit, std::clamp(std::abs(before - now), 1e-6 * before, 0.1 * before));
  };
  return fit.known_errors ? "chi^2 per degree of freedom falls from " + text(before) + " to " + text(now)
                          : "the squares of the residuals fall to " + rounded(100 * now / before, 2) + "%";
}

Message explained_text(const Cause& cause, const FitResult& fit) {
  return cause.size + ", " + before_and_after(fit, cause.fit) + " and " + lambda_text(cause.fit) + "; " + cause.remedy;
}

std::vector<Explanation> explanations_of(const std::vector<Cause>& list) {
  std::vector<Explanation> explanations;
  const auto least =
      std::min_element(list.begin(), list.end(), [](const Cause& x, const Cause& y) { return x.misfit < y.misfit; });
  for (const Cause& one : list)
    explanations.push_back({one.name, one.run, one.size, one.remedy, first_free(one.fit), one.misfit - least->misfit});
  return explanations;
}

/// The experiment that would decide between the causes.
std::string deciding_experiment(const std::vector<Cause>& list) {
  std::vector<std::string> constants;
  for (const Cause& one : list) {
    if (one.kind != Cause::Kind::constant || one.name.ends_with("_drift"))
      return "repeating the first load at the end would decide, since it separates a drift from a dependence on the "
             "load";
    constants.push_back(one.name);
  }
  return "a separate measurement of " + joined(constants, " or ") + " would decide";
}

/// All causes that do about as well, with their values.
Message all_text(const std::vector<Cause>& list, const FitResult& fit) {
  if (list.size() == 1) return explained_text(list.front(), fit);
  Message text = std::to_string(list.size()) + " causes explain the points about as well: ";
  for (std::size_t i = 0; i < list.size(); ++i)
    text +=
        Message(i == 0 ? "" : "; or ") + list[i].size + " (" + lambda_text(list[i].fit) + "; " + list[i].remedy + ")";
  return text + "; " + deciding_experiment(list);
}

/// `whole`: the fit of all points tried, `used`: their number. The cut's points are those of the data of `of`.
Message sliding_text(const Case& of, const FitResult& whole, const Cut& cut, std::size_t used) {
  const std::size_t all = of.fit.used.size();
  return (used == all ? "" : "of one point in " + std::to_string((all + used - 1) / used) + ", ") +
         std::to_string(cut.points) + " points lie past the onset of sliding, the first in " +
         of.data.line_text(of.data.points[cut.first].line) + ": cut the runs there" +
         cut_at(cut.onsets, of.data, of.fit) + "; without them " + lambda_text(cut.fit) + " and " +
         before_and_after(whole, cut.fit);
}

/// The reason if a few points with far smaller errors than the others explain the failure; else null.
std::optional<Message> of_heavy_points(const Case& of) {
  if (!of.fit.consistency || !of.fit.consistency->heavy || !is_found(of.fit)) return std::nullopt;
  const HeavyPoints& heavy = *of.fit.consistency->heavy;
  Points others;
  std::set_difference(of.fit.used.begin(), of.fit.used.end(), heavy.points.begin(), heavy.points.end(),
                      std::back_inserter(others));
  const FitResult without = of.refit(of.data, of.options, others, &of.fit.parameters);
  if (!is_found(without) || !explains(of.data, without)) return std::nullopt;
  const bool one = heavy.points.size() == 1;
  Message text = text_of(heavy, of.data) + ": check " + (one ? "it" : "them") + "; without " + (one ? "it " : "them ") +
                 before_and_after(of.fit, without);
  if (const std::string values = lambda_text(without); !values.empty()) text += " and " + values;
  if (const std::string lines = lines_text(of.data, heavy.points); !lines.empty())
    text += Message("; ") + Remedy::set("exclude", lines);
  return text;
}

bool sliding_is_tried(const Case& of, const Points& points) {
  constexpr std::size_t kSome = 50;
  if (!of.data.has_loads || of.to_beat) return false;
  if (points.size() < 2 * kSome) return true;
  const std::optional<Cut> cut = before_sliding(of, thinned_from_ends(of.data, points, kSome), 1);
  return cut && explains(of.data, cut->fit);
}

/// The fit without the ends of the runs if it explains the points; of many points a sample is tried first.
std::optional<FitResult> explained_without_ends(const Case& of, const FitResult& whole, const Points& points) {
  const auto explained = [&](const FitResult& without) { return is_found(without) && explains(of.data, without); };
  if (worth_a_sample(points) && !explained(without_ends(of, whole, thinned(points, kTriedFirst)))) return std::nullopt;
  FitResult without = without_ends(of, whole, points);
  return explained(without) ? std::optional(std::move(without)) : std::nullopt;
}

/// Where nothing but score tests of constants fails, none clearly, and neighbours correlate: the fits with such a
/// constant free, if the likelihood ratio shows for none that it should be; else none. A score test takes the errors as
/// known, whose sizes and correlation a long memory tells poorly; these fits estimate their own.
std::vector<Cause> contradicting_fits(const Case& of) {
  const FitResult& fit = of.fit;
  const bool correlate = fit.errors && fit.errors->correlations.any();
  if (fit.known_errors || !correlate || !failed_test(of.data, fit, false).empty()) return {};
  std::vector<Cause> list;
  for (const ExactConstant& one : fit.budget->exact) {
    const double tests = fit.budget->independent;
    if (!one.score || !one.score->matters() || !asks_to_be_free(*one.score, tests)) continue;
    if (one.score->p_value * tests < kHardly) return {};
    Cause cause = with_free(of, constant_named(one.constant).value(), fit.used.list());
    if (!is_found(cause.fit)) return {};
    cause.misfit = misfit(cause.fit);
    if (chi_squared_p_value(std::max(misfit(fit) - cause.misfit, 0.0), 1) * tests < kChance) return {};
    describe(of, cause);
    list.push_back(std::move(cause));
  }
  return list;
}

/// That the interval includes the fits with these constants, as one may be wrong.
Diagnosis including(const std::vector<Cause>& list, const ExactConstant& worst) {
  const bool other = list.front().name != worst.constant || list.size() > 1;
  Message text = worst.constant + (other ? " or another constant" : "") +
                 " may be wrong (p = " + rounded(p_value_of(worst), 2) + "): the interval includes ";
  for (const Cause& one : list)
    text += Message(&one == &list.front() ? "" : " and ") + "the fit with " + one.name + " = " + one.value + " (" +
            lambda_text(one.fit) + "; " + one.remedy + ")";
  return {std::move(text), {}, explanations_of(list), true};
}

}  // namespace

Diagnosis diagnose(const Dataset& data, const FitResult& fit, const FitOptions& options, const Refit& refit,
                   std::optional<double> to_beat) {
  const Message failed = failed_test(data, fit);
  const bool pinned = fit.consistency && fit.consistency->pinned;
  if (failed.empty() || fit.loss_scale > 0 || pinned || axes_leave_fit(fit)) return {failed, {}, {}};
  const Case of{data, fit, options, refit, to_beat};
  if (auto heavy = of_heavy_points(of)) return {std::move(*heavy), {}, {}};
  if (!fit.budget) return {failed, {}, {}};
  constexpr std::size_t kEnough = 5000;  // points to distinguish causes
  const Points points = thinned(fit.used, kEnough);
  const bool all_points = points.size() == fit.used.size();
  // A part of many points stands for all as a data set of its own: what a refit costs depends on its data.
  std::optional<Dataset> of_part;
  FitOptions with = options;
  if (!all_points && !options.errors) {
    of_part = part_of(data, points);
    with.of_whole = fit.errors;
  }
  const Case some{of_part ? *of_part : data, fit, with, refit, to_beat};
  const Points tried = of_part ? PointIndices(points.size()).list() : points;
  const FitResult whole = all_points ? fit : refit(some.data, with, tried, &fit.parameters);
  if (!is_found(whole)) return {failed, {}, {}};
  if (all_points && !to_beat)
    if (const std::vector<Cause> list = contradicting_fits(of); !list.empty())
      return including(list, *wrong_constant(fit));
  std::vector<Cause> found = causes(some, tried, misfit(whole), kAboutAsWell);
  std::erase_if(found, [&](const Cause& one) { return !(misfit(whole) - one.misfit > kAboutAsWell); });
  // A cut of the runs would only leave pull-off loads less to contradict.
  const bool may_slide = !pull_off_departs(fit);
  const auto sliding = [&](double chance) -> std::optional<Diagnosis> {
    auto cut = sliding_is_tried(some, tried) ? before_sliding(some, tried, kFew) : std::nullopt;
    if (!cut || !explains(some.data, cut->fit, chance)) return std::nullopt;
    if (of_part) {
      cut->first = points[cut->first];
      for (std::size_t& onset : cut->onsets) onset = points[onset];
    }
    return Diagnosis{sliding_text(of, whole, *cut, points.size()), {}, {}};
  };
  if (!found.empty()) {
    // A cause that fails a test itself stands back where a cut of the runs fails none.
    if (may_slide && !explains(some.data, found.front().fit, kChance))
      if (auto slides = sliding(kChance)) return std::move(*slides);
    Diagnosis diagnosis{all_text(found, whole), {}, {}};
    if (all_points) diagnosis.explained = comparable_squares(found.front().fit);
    diagnosis.explanations = explanations_of(found);
    return diagnosis;
  }
  if (!may_slide) return {failed, {}, {}};
  if (auto slides = sliding(kHardly)) return std::move(*slides);
  if (!to_beat && data.has_loads && fit.consistency && fit.consistency->residuals.ends_p < kChance)
    if (const auto without = explained_without_ends(some, whole, tried))
      return {"the model describes the points but for the last tenth of each run; without it " + lambda_text(*without),
              {},
              {}};
  if (!wrong_constant(fit) && !runs_differ(fit, kChance)) return {failed, {}, {}};
  return {
      "no single constant or difference between runs explains the points: the model is wrong, or there are several "
      "causes",
      {},
      {}};
}

Diagnosis second_thought(const Dataset& data, const FitResult& fit, const FitOptions& options, const Refit& refit) {
  const auto cause = shape_instead_of_memory({data, fit, options, refit});
  if (!cause) return {};
  Explanation memory{"memory", "", "autocorrelated noise", Message(), first_free(fit), 0};
  Explanation shape{
      cause->name, cause->run, cause->size, cause->remedy, first_free(cause->fit), cause->misfit - misfit(fit)};
  return {cause->size + " (" + lambda_text(cause->fit) + "; " + cause->remedy +
              "), or the noise of T is autocorrelated (" + lambda_text(fit) +
              "): both explain the points about as well; a separate measurement of the shape would decide",
          comparable_squares(cause->fit),
          {std::move(shape), std::move(memory)}};
}

Diagnosis included(const Dataset& data, const FitResult& fit, const FitOptions& options, const Refit& refit) {
  const std::vector<Cause> list = beside_the_fit({data, fit, options, refit});
  if (list.empty()) return {};
  return including(list, *nearly_wrong_constant(fit));
}

}  // namespace mixity
