#include "report/fit_table.h"

#include <algorithm>

#include "analysis/judgement.h"
#include "analysis/readable.h"
#include "analysis/readers_units.h"
#include "base/number_text.h"
#include "base/phrases.h"
#include "mechanics/contact_model.h"
#include "report/fit_text.h"

namespace mixity {
namespace {

std::string parameter_text(const FittedParameter& fitted) {
  const FittedParameter parameter = readable(fitted);
  std::string text = parameter.name + " = ";
  if (!parameter.value) return text + "not determined";
  const auto& interval = parameter.interval;
  const double width = interval && interval->low && interval->high ? *interval->high - *interval->low
                                                                   : 4 * parameter.stderr_.value_or(0);
  text +=
      parameter.stderr_ ? with_error(*parameter.value, *parameter.stderr_, " ± ") : resolved(*parameter.value, width);
  if (interval)
    text += " (" + ends_text(*interval, width, "open", " bound") + ")";
  else if (parameter.held)
    text += " (held)";
  return text + unit_text(parameter.unit);
}

const ComparedModel* compared(const Analysis& result, const std::string& model) {
  for (const ComparedModel& entry : result.comparison)
    if (entry.model == model) return &entry;
  return nullptr;
}

/// The paper's fit has no standard error, so five digits are shown.
std::vector<std::string> paper_lines(const PaperFit& paper) {
  std::vector<std::string> lines;
  for (const FittedParameter& parameter : paper.parameters)
    lines.push_back(parameter.name + " = " + (parameter.value ? rounded(*parameter.value, 5) : "not determined"));
  if (paper.r2) lines.push_back("R² = " + r2_text(*paper.r2));
  if (paper.status != FitStatus::ok && paper.status != FitStatus::not_identifiable)
    lines.push_back(in_words(paper.status));
  return lines;
}

}  // namespace

std::string weight_text(double weight) { return weight < 1e-4 ? "< 0.0001" : rounded(weight, 3); }

FitTable fit_table(const Analysis& result) {
  using Cell = FitTable::Cell;
  FitTable table;
  table.rows.resize(result.fits.size());
  // a column that is empty for every fit is left out
  const auto column = [&](const std::string& heading, const std::string& short_heading, const auto& cell_of) {
    std::vector<Cell> cells;
    for (const FitResult& fit : result.fits) cells.push_back(cell_of(fit));
    if (std::all_of(cells.begin(), cells.end(), [](const Cell& cell) { return cell.lines.empty(); })) return;
    table.headings.push_back(heading);
    table.short_headings.push_back(short_heading);
    for (std::size_t i = 0; i < cells.size(); ++i) table.rows[i].push_back(std::move(cells[i]));
  };
  const auto r2 = [](const std::optional<double>& value) { return value ? Cell{{r2_text(*value)}} : Cell{}; };
  const auto area = [](const FitResult& fit) { return fit.area && fit.area->predicted > 0 ? &*fit.area : nullptr; };
  const std::string unit = unit_text(result.data.display.area);
  std::string percent;
  for (const FitResult& fit : result.fits)
    for (const FittedParameter& parameter : fit.parameters)
      if (parameter.interval) percent = " (" + rounded(100 * parameter.interval->confidence, 4) + " % interval)";

  column("Model", "Model", [](const FitResult& fit) { return Cell{{fit.model, fit.model_name}}; });
  column("Parameters" + percent, "Parameters" + percent, [](const FitResult& fit) {
    Cell cell;
    for (const FittedParameter& parameter : fit.parameters) cell.lines.push_back(parameter_text(parameter));
    return cell;
  });
  column("Status", "Status", [](const FitResult& fit) {
    return Cell{{in_words(fit.status)}, fit.status != FitStatus::ok};
  });
  column("R² in the fitted space", "R² fit", [&](const FitResult& fit) { return r2(fit.r2); });
  column("The paper's fit: ln(Gc/GIc) against psi", "Paper's fit",
         [](const FitResult& fit) { return fit.paper ? Cell{paper_lines(*fit.paper)} : Cell{}; });
  column("R² of A(T)", "R² A(T)", [&](const FitResult& fit) { return area(fit) ? r2(area(fit)->r2) : Cell{}; });
  column("RMS error of A(T)", "RMS A(T)", [&](const FitResult& fit) {
    if (!area(fit)) return Cell{};
    Cell cell{{area_error_text(area(fit)->rmse, result.data) + unit}};
    if (const std::size_t n = area(fit)->unpredicted; n > 0)
      cell.lines.push_back("without " + std::to_string(n) + " past the fold");
    return cell;
  });
  column("AICc weight", "AICc weight", [&](const FitResult& fit) {
    const ComparedModel* entry = compared(result, fit.model);
    return entry && entry->weight ? Cell{{weight_text(*entry->weight)}} : Cell{};
  });
  column("RMS error on left-out loads", "RMS left out", [&](const FitResult& fit) {
    const ComparedModel* entry = compared(result, fit.model);
    return entry && entry->left_out ? Cell{{area_error_text(entry->left_out->rmse_area, result.data) + unit}} : Cell{};
  });
  column("Published", "Published", [&](const FitResult& fit) {
    Cell cell;
    for (const Agreement& agreement : compare(fit, result.request)) {
      cell.lines.push_back(agreement.published.name + " = " + shortest(agreement.published.value) +
                           (agreement.agrees ? " agrees" : " DOES NOT AGREE"));
      cell.alert |= !agreement.agrees;
    }
    return cell;
  });
  return table;
}

std::string table_text(const Analysis& result) {
  if (const auto shown = in_readers_units(result)) return table_text(*shown);
  FitTable table = fit_table(result);
  std::vector<std::vector<std::string>> lines{table.short_headings};
  for (auto& row : table.rows) {
    row[0].lines.resize(1);  // the key without the name
    const std::size_t first = lines.size();
    for (std::size_t k = 0; k < row.size(); ++k)
      for (std::size_t i = 0; i < row[k].lines.size(); ++i) {
        if (first + i == lines.size()) lines.emplace_back(row.size());
        lines[first + i][k] = row[k].lines[i];
      }
  }
  return aligned(lines);
}

std::string with_powers(std::string text) {
  for (const auto& [plain, power] : {std::pair("^2", "²"), std::pair("^3", "³")})
    for (std::size_t at = 0; (at = text.find(plain, at)) != std::string::npos;) text.replace(at, 2, power);
  return text;
}

std::vector<std::string> findings(const Analysis& result) {
  std::vector<std::string> sentences;
  std::vector<const ComparedModel*> by_error, by_weight;
  for (const ComparedModel& entry : result.comparison) {
    if (entry.left_out) by_error.push_back(&entry);
    if (entry.weight) by_weight.push_back(&entry);
  }
  std::stable_sort(by_error.begin(), by_error.end(), [](const ComparedModel* one, const ComparedModel* other) {
    return one->left_out->rmse_area < other->left_out->rmse_area;
  });
  std::stable_sort(by_weight.begin(), by_weight.end(),
                   [](const ComparedModel* one, const ComparedModel* other) { return *one->weight > *other->weight; });
  const std::string no_winner = no_best_model(result);
  if (!no_winner.empty()) sentences.push_back("Here " + no_winner + ".");
  const Preferences preferred = preferences(result.comparison);
  if (no_winner.empty() && by_error.size() > 1 && by_error[0]->left_out->rmse_area > 0) {
    const double least = by_error[0]->left_out->rmse_area;
    const std::vector<std::string>& best = preferred.left_out;
    std::vector<std::string> others;
    for (std::size_t i = best.size(); i < by_error.size(); ++i)
      others.push_back(by_error[i]->model + " errs " + rounded(by_error[i]->left_out->rmse_area / least, 2) +
                       " times as much");
    sentences.push_back(
        (best.size() > 1 ? "Models " + joined(best, " and ") + " predict" : "Model " + best[0] + " predicts") +
        " the areas at loads left out of the fit best (RMS error " + area_error_text(least, result.data) +
        unit_text(result.data.display.area) + ")" + joined(others, ", ", "; ") + ".");
  }
  if (no_winner.empty() && by_weight.size() > 1) {
    const double weight = *by_weight[0]->weight;
    const std::vector<std::string>& tied = preferred.aicc;
    sentences.push_back(weight > 0.95 ? "AICc prefers model " + by_weight[0]->model + " (weight " +
                                            (weight > 0.9999 ? "> 0.9999" : rounded(weight, 3)) + ")."
                        : tied.size() > 1 ? "AICc finds models " + joined(tied, " and ") + " equal (weight " +
                                                rounded(weight, 2) + " each)."
                                          : "AICc does not decide between the models (weight of " +
                                                by_weight[0]->model + " " + rounded(weight, 2) + ").");
  }
  for (const FitResult& fit : result.fits)
    if (fit.status != FitStatus::ok && fit.outdone_by.empty())
      sentences.push_back("Model " + fit.model + ", " + in_words(fit.status) + ": " +
                          fit.message.text(result.request.words) + ".");
  for (const Message& note : result.data.notes) sentences.push_back("Note: " + note.text(result.request.words) + ".");
  return sentences;
}

std::vector<std::string> assumptions(const Analysis& result) {
  const Dataset& data = result.data;
  const FitOptions& options = result.request.options;
  const Objective objective = objective_of(result);
  std::vector<std::string> list;
  if (data.has_loads)
    list.emplace_back(std::string(std::any_of(result.fits.begin(), result.fits.end(),
                                              [](const FitResult& fit) { return is_elliptic(fit.model); })
                                      ? "A circular or, where the model says so, elliptic contact of a sphere"
                                      : "A circular contact of a sphere") +
                      " on a half-space, without slip and in equilibrium at every point; linear "
                      "elasticity, short-range adhesion (JKR), nu = 1/2 for the tangential displacement.");
  if (data.has_loads)
    list.push_back("Mode III at the edge: " + mode_III_text(data.metadata) +
                   (data.metadata.mode_III == ModeIII::averaged
                        ? ", as in Johnson (1996) and Waters & Guduru (2010)."
                        : ", so that the energy release rate is the same all round (Papangelo & Ciavarella 2019)."));
  else
    list.emplace_back("Phase angle and toughness are taken as the file gives them; no area is predicted.");
  if (data.contact)
    list.push_back("R = " + rounded(data.contact->radius * 1e3, 6) +
                   " mm, E* = " + rounded(data.contact->modulus * 1e-6, 6) +
                   " MPa (plane strain) and G_Ic = " + rounded(data.contact->toughness * 1e3, 6) + " mJ/m² are exact" +
                   (options.free.empty() && data.metadata.standard_errors.empty()
                        ? "."
                        : ", but for what was freed or stated with a standard error."));
  else if (data.has_loads)
    list.emplace_back("The file is dimensionless: P and T over R G_Ic, A times (xi/R)^2.");
  if (objective == Objective::toughness) {
    list.push_back(std::string("Residuals are differences of ") +
                   (scale_of(options) == Scale::log ? "ln(Gc/GIc)" : "Gc/GIc") + " at the point's phase angle, " +
                   (options.weighted ? "weighted by each point's standard error." : "all with the same weight."));
    if (data.has_loads)
      list.emplace_back(
          "Gc/GIc and psi are computed from the same area, so that their errors are correlated; R² in "
          "this space is close to 1 for almost any model.");
  }
  if (objective == Objective::curve)
    list.push_back(std::string("Residuals are distances of the points from the ") +
                   (data.has_energies ? "law in the plane of G_I and G_II" : "curve in T and A") +
                   (data.has_energies && data.errors.empty() ? "; no standard errors are stated, and both count alike."
                                                             : ", in standard errors."));
  const auto with_paper = std::find_if(result.fits.begin(), result.fits.end(), [](const auto& f) { return f.paper; });
  if (with_paper != result.fits.end())
    list.emplace_back(
        "The paper's fit, every point with the same weight, stands beside it: Gc/GIc and psi are computed from the "
        "same area, so that its R² is close to 1 for almost any model.");
  const auto with_errors = std::find_if(result.fits.begin(), result.fits.end(), [](const auto& f) { return f.errors; });
  if (with_errors != result.fits.end()) {
    const StandardErrors& errors = *with_errors->errors;
    if (const std::string text = estimated_errors(errors, data.display); !text.empty())
      list.push_back("Standard errors: " + text + ".");
    if (const std::string text = correlation_text(*with_errors); !text.empty())
      list.push_back("The noise is autocorrelated: " + text + ".");
    for (const std::string& raised : raised_errors(errors))
      list.push_back("A distance needs errors in both axes: " + raised + ".");
  }
  return list;
}

std::vector<std::pair<std::string, std::string>> fit_settings(const Analysis& result) {
  const FitOptions& options = result.request.options;
  const Objective objective = objective_of(result);
  std::vector<std::pair<std::string, std::string>> settings{{"objective", std::string(to_string(objective))}};
  if (objective == Objective::toughness) settings.emplace_back("scale", to_string(scale_of(options)));
  settings.emplace_back("weighted", options.weighted || objective != Objective::toughness ? "yes" : "no");
  std::vector<std::string> held, freed;
  for (const HeldParameter& one : options.hold)
    held.push_back(one.name + (one.value ? " = " + shortest(*one.value) : ""));
  if (!held.empty()) settings.emplace_back("held", joined(held));
  for (const Constant constant : options.free) freed.emplace_back(kConstantNames[constant]);
  if (!freed.empty()) settings.emplace_back("freed constants", joined(freed));
  if (options.loss != Loss::none) settings.emplace_back("loss", to_string(options.loss));
  settings.emplace_back(
      "intervals", options.intervals ? "profile likelihood, " + rounded(100 * options.confidence, 4) + " %" : "none");
  if (options.bootstrap.replicates > 0)
    settings.emplace_back("bootstrap", std::to_string(options.bootstrap.replicates) + " replicates of " +
                                           (options.bootstrap.resample == Resample::points ? "points" : "runs") +
                                           ", seed " + std::to_string(options.bootstrap.seed));
  if (!result.request.source.empty()) settings.emplace_back("published by", result.request.source);
  return settings;
}

}  // namespace mixity
