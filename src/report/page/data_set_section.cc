#include "report/page/data_set_section.h"

#include <map>

#include "base/number_text.h"
#include "base/phrases.h"
#include "base/text.h"
#include "report/data_text.h"
#include "report/figures/svg_text.h"
#include "report/fit_table.h"
#include "report/fit_text.h"
#include "report/page/document.h"
#include "report/page/sentence.h"

namespace mixity {
namespace {

std::string provenance_banner(const Metadata& metadata) {
  const Provenance provenance = metadata.provenance;
  const std::string meaning(meaning_of(provenance));
  return element("p",
                 text_element("strong", "Provenance: " + std::string(to_string(provenance)) + ".") +
                     (meaning.empty() ? "" : " " + meaning),
                 {{"class", provenance == Provenance::measured ? "soft" : "banner"}});
}

std::string source_of_data(const Dataset& data) {
  const std::string counts = row_counts(data);
  std::string text = element("p", counts + ". File: " + text_element("code", data.shown_path()), {{"class", "soft"}});
  if (!data.metadata.source.empty()) text += text_element("p", "Source: " + data.metadata.source, "soft");
  if (!data.metadata.note.empty()) text += text_element("p", data.metadata.note, "soft");
  return text;
}

/// Parts of the variance as one bar with a key below it.
std::string budget_bar(const Answer& answer) {
  if (answer.budget.empty()) return {};
  std::string bar, key;
  std::size_t number = 0;
  for (const auto& [name, share] : answer.budget) {
    const std::string paint = "--part:var(--color-" + std::to_string(1 + number++ % 7) + ")";
    bar += element("span", "", {{"style", paint + ";flex:" + rounded(share, 4)}});
    const std::string percent = rounded(100 * share, share < 0.1 ? 1 : 2) + " %";
    key += element("span", xml_escaped(name + " " + percent), {{"style", paint}}) + " ";
  }
  return element("div",
                 text_element("p", "Where the variance comes from", "soft") +
                     element("div", bar, {{"class", "bar"}, {"aria-hidden", "true"}}) +
                     element("p", key, {{"class", "key"}}),
                 {{"class", "budget"}});
}

std::string jumps_table(const Answer& answer, const Dataset& data) {
  const auto rows = jump_table(answer, data);
  if (rows.empty()) return {};
  std::string body;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    std::string cells;
    for (const std::string& cell : rows[i]) cells += text_element("td", cell);
    body += element("tr", cells);
  }
  return table_of("jumps", rows.front(), body, "Where the contact jumps under a tangential load, ± one standard error");
}

/// The first screen of a data set. `figure`: markup of the figure beside the result; empty: none.
std::string answer_section(const Answer& answer, const Dataset& data, const std::string& figure) {
  if (!answer.fit) return text_element("p", "No fit has a value: see All models.", "alert");
  std::string words =
      element("p", sentence(answer.result), {{"class", "result"}}) + element("p", sentence(answer.model));
  if (!answer.interval.empty()) words += element("p", sentence(answer.interval));
  if (!answer.doubt.empty()) words += element("p", sentence(answer.doubt) + ".", {{"class", "alert"}});
  words += budget_bar(answer) + jumps_table(answer, data);
  const std::string box = element("div", element("div", words) + figure, {{"class", "answer"}});
  return answer.cannot_say.empty()
             ? box
             : box + text_element("h3", "What these data cannot say") + list_of(answer.cannot_say);
}

std::string table_of_fits(const Analysis& result) {
  std::string text;
  for (const std::string& one : findings(result)) text += element("p", sentence(one));
  return text + table_of_cells(fit_table(result));
}

std::string budgets(const Analysis& result) {
  std::string text;
  if (result.unsheared) text += element("p", sentence(unsheared_sentence(*result.unsheared)) + ".");
  for (const FitResult& fit : result.fits) {
    const std::vector<std::string> lines = budget_and_consistency(fit, result);
    if (!lines.empty()) text += text_element("h4", "Model " + fit.model) + list_of(lines);
  }
  return text;
}

std::string excluded_points(const Analysis& result) {
  std::vector<std::string> lines;
  for (const Excluded& point : result.data.excluded)
    lines.push_back(result.data.line_text(point.line) + ": " + std::string(point.reason));
  std::map<std::pair<std::size_t, std::string_view>, std::vector<std::string>> models;  // by line and reason
  for (const FitResult& fit : result.fits)
    for (const Excluded& point : fit.excluded) models[{point.line, point.reason}].push_back(fit.model);
  for (const auto& [point, without] : models)
    lines.push_back(
        result.data.line_text(point.first) +
        (without.size() == 1 ? ", model " + without.front() + " only: " : ", models " + joined(without) + ": ") +
        std::string(point.second));
  return lines.empty() ? text_element("p", "None.") : list_of(lines);
}

/// A(T) of the best model; f(psi) without loads. Null if no fit has values.
const Figure* leading_figure(const ReportEntry& entry) {
  const FitResult* const fit = entry.shown->answer.fit;
  if (!fit) return nullptr;
  const std::string& stem = entry.shown->stem;
  for (const std::string& name : {stem + "_area_" + fit->model, stem + "_toughness"})
    for (const FigureGroup& group : entry.figures.groups)
      for (const Figure& figure : group.figures)
        if (figure.name == name) return &figure;
  return nullptr;
}

/// Whether a figure is about one model alone, and not about the one that the page begins with: paper has no room for
/// it.
bool of_another_model(const Figure& figure, const ReportEntry& entry) {
  const FitResult* const best = entry.shown->answer.fit;
  for (const FitResult& fit : entry.shown->result.fits)
    for (const char* const kind : {"_area_", "_profile_", "_runs_", "_regimes_", "_axes_", "_couplings_"})
      if (const std::string name = entry.shown->stem + kind + fit.model;
          figure.name == name || figure.name.starts_with(name + "_"))
        return best && fit.model != best->model;
  return false;
}

/// A data set that a reader opens; the line to click shows its name and result.
std::string closed_set(const ReportEntry& entry, const std::string& content) {
  const Answer& answer = entry.shown->answer;
  std::string line = text_element("h2", entry.shown->result.data.title());
  if (answer.fit)
    line +=
        " " + element("span", sentence(answer.result) + ",") + " " + text_element("span", "model " + answer.fit->model);
  if (!answer.fit || answer.fit->status != FitStatus::ok)
    line += " " + text_element("span", answer.fit ? std::string(to_string(answer.fit->status)) : "no fit has a value",
                               "alert");
  // a link with the name as its anchor opens the set, because the anchor is inside
  return element("details", element("summary", line) + element("div", content, {{"id", entry.shown->stem}}),
                 {{"class", "set"}});
}

}  // namespace

std::string data_set_section(const ReportContent& content, const ReportEntry& entry) {
  const Analysis& result = entry.shown->result;
  const auto drawn = [&](const Figure& figure, bool beside_text) {
    return figure_element(figure, content.drawn.endings.at(figure.name),
                          {"figures/", beside_text, !content.figures_inside, !of_another_model(figure, entry)});
  };
  const Figure* const leading = leading_figure(entry);
  std::string text = provenance_banner(result.data.metadata) +
                     answer_section(entry.shown->answer, result.data, leading ? drawn(*leading, true) : "") +
                     folded_section(result.fits.size() > 1 ? "All models" : "The fit", table_of_fits(result)) +
                     folded_section("Error budget and consistency", budgets(result));
  for (const FigureGroup& group : entry.figures.groups) {
    std::string figures;
    for (const Figure& figure : group.figures)
      if (&figure != leading) figures += drawn(figure, false);
    if (!figures.empty()) text += folded_section(group.title, element("div", figures, {{"class", "figures"}}));
  }
  text += folded_section("Points left out", excluded_points(result)) +
          folded_section("Data, assumptions and settings", source_of_data(result.data) + list_of(assumptions(result)) +
                                                               definitions_of(fit_settings(result)));
  std::vector<std::string> reasons;
  for (const MissingFigure& figure : entry.figures.left_out) reasons.push_back(figure.what + ": " + figure.why);
  if (!reasons.empty()) text += folded_section("Figures left out", list_of(reasons));
  // the page's own heading names the set if it is the only one
  if (content.entries.size() == 1) return element("section", text, {{"id", entry.shown->stem}});
  if (!content.figures_inside) return element("section", closed_set(entry, text));
  return element("section", element("h2", xml_escaped(result.data.title()), {{"id", entry.shown->stem}}) + text);
}

}  // namespace mixity
