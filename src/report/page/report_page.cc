#include <map>
#include <pugixml.hpp>

#include "base/phrases.h"
#include "base/text.h"
#include "report/data_text.h"
#include "report/fit_table.h"
#include "report/fit_text.h"
#include "report/page/answer_section.h"
#include "report/page/document.h"
#include "report/report.h"

namespace mixity {
namespace {

class Page {
 public:
  explicit Page(const ReportContent& content) : content_(content) {}

  std::string text() {
    PageDocument document(title());
    pugi::xml_node body = document.body();
    pugi::xml_node header = add(body, "header");
    add(header, "h1", title());
    add(header, "p", "Mode-mixity fits by mixity " MIXITY_VERSION, "soft");
    if (content_.entries.size() > 1) {
      pugi::xml_node nav = add(header, "nav");
      for (const ReportEntry& entry : content_.entries)
        add_link(nav, "#" + entry.data->stem, entry.data->result.data.name);
    }
    if (!content_.settings.explorer.empty()) {
      pugi::xml_node ask = add(header, "p", {}, "files");
      add_link(ask, "explorer.html", "Ask these data in the browser");
      add_text(ask, ": other constants, other loads, points left out, a file of your own.");
    }
    if (!content_.drawn.missing.empty()) add(header, "p", content_.drawn.missing, "banner");
    pugi::xml_node main = add(body, "main");
    for (const ReportEntry& entry : content_.entries) add_data_set(main, entry);
    add_reproduction(add(body, "footer"));
    return document.text();
  }

 private:
  std::string title() const {
    std::vector<std::string> names;
    for (const ReportEntry& entry : content_.entries) names.push_back(entry.data->result.data.name);
    return joined(names);
  }

  void add_data_set(pugi::xml_node main, const ReportEntry& entry) {
    const Analysis& result = entry.data->result;
    const Dataset& data = result.data;
    pugi::xml_node section = add(main, "section");
    pugi::xml_node heading = add(section, "h2", data.name, &entry == &content_.entries.front() ? "first" : nullptr);
    heading.append_attribute("id").set_value(entry.data->stem.c_str());
    add_provenance(section, data);
    const Figure* const leading = leading_figure(entry);
    add_answer(section, entry.data->answer, data, [&](pugi::xml_node parent) {
      if (leading) add_figure(parent, *leading, true);
    });
    add_fits(add_folded(section, result.fits.size() > 1 ? "All models" : "The fit"), result);
    add_budgets(add_folded(section, "Error budget and consistency"), result);
    for (const FigureGroup& group : entry.figures.groups) {
      pugi::xml_node figures;
      for (const Figure& figure : group.figures) {
        if (&figure == leading) continue;
        if (!figures) figures = add(add_folded(section, group.title), "div", {}, "figures");
        add_figure(figures, figure);
      }
    }
    add_excluded(add_folded(section, "Points left out"), result);
    pugi::xml_node made = add_folded(section, "Data, assumptions and settings");
    add_source(made, data);
    add_list(made, assumptions(result));
    add_definitions(made, fit_settings(result));
    if (entry.figures.left_out.empty()) return;
    std::vector<std::string> reasons;
    for (const MissingFigure& figure : entry.figures.left_out) reasons.push_back(figure.what + ": " + figure.why);
    add_list(add_folded(section, "Figures left out"), reasons);
  }

  /// A(T) of the best model; without loads the toughness.
  static const Figure* leading_figure(const ReportEntry& entry) {
    const FitResult* const fit = entry.data->answer.fit;
    if (!fit) return nullptr;
    const std::string& stem = entry.data->stem;
    for (const std::string& name : {stem + "_area_" + fit->model, stem + "_toughness"})
      for (const FigureGroup& group : entry.figures.groups)
        for (const Figure& figure : group.figures)
          if (figure.name == name) return &figure;
    return nullptr;
  }

  static void add_provenance(pugi::xml_node section, const Dataset& data) {
    pugi::xml_node banner = add(section, "p", {}, data.metadata.provenance == Provenance::measured ? "soft" : "banner");
    add(banner, "strong", "Provenance: " + std::string(to_string(data.metadata.provenance)) + ". ");
    if (data.metadata.provenance == Provenance::reconstructed) add_text(banner, std::string(kReconstructedNotice));
    if (data.metadata.provenance == Provenance::unstated)
      add_text(banner, "Nothing says where these data come from; state it in the TOML beside the file.");
    if (data.metadata.provenance == Provenance::digitised)
      add_text(banner, "Read off a figure: errors of reading are part of the scatter.");
  }

  static void add_source(pugi::xml_node section, const Dataset& data) {
    const std::string counts =
        row_counts(data) + (data.has_loads ? ", in " + counted(data.curves.size(), "loading run") : std::string());
    pugi::xml_node where = add(section, "p", counts + ". File: ", "soft");
    add(where, "code", data.shown_path());
    if (!data.metadata.source.empty()) add(section, "p", "Source: " + data.metadata.source, "soft");
    if (!data.metadata.note.empty()) add(section, "p", data.metadata.note, "soft");
  }

  static void add_fits(pugi::xml_node section, const Analysis& result) {
    for (const std::string& sentence : findings(result)) add(section, "p", with_powers(sentence));
    const FitTable fits = fit_table(result);
    pugi::xml_node body = add_table(section, "fits", fits.headings);
    for (const auto& row : fits.rows) {
      pugi::xml_node line = add(body, "tr");
      for (std::size_t column = 0; column < row.size(); ++column) {
        pugi::xml_node cell = add(line, column == 0 ? "th" : "td", {}, row[column].alert ? "alert" : nullptr);
        if (column == 0) cell.append_attribute("scope").set_value("row");
        if (row[column].lines.empty()) continue;
        cell.append_attribute("data-label").set_value(fits.headings[column].c_str());
        for (const std::string& text : row[column].lines) add(cell, "div", with_powers(text));
      }
    }
  }

  /// What the errors are made of and whether the data are consistent.
  static void add_budgets(pugi::xml_node section, const Analysis& result) {
    if (result.unsheared) add(section, "p", with_powers(unsheared_sentence(*result.unsheared)) + ".");
    for (const FitResult& fit : result.fits) {
      std::vector<std::string> lines = budget_and_consistency(fit, result);
      if (lines.empty()) continue;
      for (std::string& line : lines) line = with_powers(line);
      add(section, "h4", "Model " + fit.model);
      add_list(section, lines);
    }
  }

  void add_figure(pugi::xml_node parent, const Figure& figure, bool beside = false) const {
    mixity::add_figure(parent, figure, content_.drawn.endings.at(figure.name), "figures/", beside);
  }

  static void add_excluded(pugi::xml_node section, const Analysis& result) {
    std::vector<std::string> lines;
    for (const Excluded& point : result.data.excluded)
      lines.push_back(result.data.line_text(point.line) + ": " + std::string(point.reason));
    std::map<std::pair<std::size_t, std::string_view>, std::vector<std::string>> models;  // of line and reason
    for (const FitResult& fit : result.fits)
      for (const Excluded& point : fit.excluded) models[{point.line, point.reason}].push_back(fit.model);
    for (const auto& [point, without] : models)
      lines.push_back(result.data.line_text(point.first) +
                      (without.size() == 1 ? ", model " + without.front() + " only: "
                                           : ", models " + joined(without) + ": ") +
                      std::string(point.second));
    if (lines.empty())
      add(section, "p", "None.");
    else
      add_list(section, lines);
  }

  void add_reproduction(pugi::xml_node footer) const {
    add(footer, "h2", "To make this report again");
    add(add(footer, "p"), "code", printable(content_.settings.command, std::string::npos));
    add_definitions(footer, versions());
    pugi::xml_node tables = add(footer, "p", "Beside this page: ", "files");
    for (const char* file : {"results.json", "fits.csv", "residuals.csv", "curves.csv", "summary.md"}) {
      add_link(tables, file, file);
      add_text(tables, " ");
    }
  }

  const ReportContent& content_;
};

}  // namespace

std::string report_page(const ReportContent& content) { return Page(content).text(); }

}  // namespace mixity
