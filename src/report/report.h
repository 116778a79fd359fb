// A report: a page, its figures and its tables in a folder.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "analysis/reported_data.h"
#include "base/files.h"
#include "report/figures/data_figures.h"
#include "report/figures/drawn_figures.h"

namespace mixity {

struct ReportSettings {
  std::string command;  // that makes this report again
  Progress progress{};
  std::string explorer{};  // path of the explorer's page, of which the report gets a copy with its data; empty: none
  OutputRules outputs{};   // inputs: those beside the inputs of the analyses; figures of former reports are removed
  std::size_t most_inside = 10'000'000;  // bytes of drawings that the page holds; more lie in files beside it
};

/// One data set with its figures.
struct ReportEntry {
  const ReportedData* data;
  DataFigures figures;
};

struct ReportContent {
  ReportSettings settings;
  std::vector<ReportEntry> entries;
  DrawnFigures drawn{};        // all figures
  bool figures_inside = true;  // the page holds the drawings; else it shows their files
};

// ---- The documents of a report ----

/// report.html: HTML5, well-formed as XML below its first line. It needs no other file if the figures are inside; else
/// it shows the files of those in sets that a reader opens. The same input gives the same bytes.
std::string report_page(const ReportContent& content);
/// explorer.html. `shell`: the explorer as tools/explorer makes it. Each data set is embedded as its file and its TOML,
/// byte for byte; one of several files as its points. Empty if the shell has no place for them.
std::string explorer_page(std::string shell, const ReportContent& content);
/// results.json, schema mixity-report-1. docs/results.schema.json describes each field.
std::string report_json(const ReportContent& content);
/// summary.md: the tables, for a lab book.
std::string summary_markdown(const ReportContent& content);

/// Name and version of this program and of the libraries on which numbers depend.
std::vector<std::pair<std::string, std::string>> versions();

struct ReportFiles {
  std::vector<OutputFile> files;  // report.html is the last
  std::string missing;            // what could not be drawn, and why; empty if nothing
};

/// What write_report writes. `data` refers to `results`, one each.
ReportFiles report_files(const std::vector<Analysis>& results, const std::vector<ReportedData>& data,
                         const std::string& folder, const ReportSettings& settings);

struct WrittenReport {
  std::string page;     // path of the HTML file
  std::string missing;  // what could not be drawn, and why; empty if nothing
};

/// Writes report.html, summary.md, results.json, fits.csv, residuals.csv, curves.csv, figures/ and, if there is one,
/// explorer.html into the folder, the page last. `data` refers to `results`, one each. Throws OutputError with the
/// files of the last report in place, also if a file of data would be written over.
WrittenReport write_report(const std::vector<Analysis>& results, const std::vector<ReportedData>& data,
                           const std::string& folder, const ReportSettings& settings);

}  // namespace mixity
