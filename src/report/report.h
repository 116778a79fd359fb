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
  std::string command;  // the command that makes this report again
  Progress progress{};
  std::string explorer{};  // path of the explorer's page, which is copied into the report with its data; empty: none
  OutputRules outputs{};   // inputs beside those of the analyses; figures of earlier reports are removed
  std::size_t most_inside = 10'000'000;  // bytes of drawings embedded in the page; beyond that they are separate files
};

/// One data set with its figures.
struct ReportEntry {
  const ReportedData* data;   // in the units of the file, for tables and JSON
  const ReportedData* shown;  // in units for readers, for texts and figures
  DataFigures figures;
};

struct ReportContent {
  ReportSettings settings;
  std::vector<ReportEntry> entries;
  DrawnFigures drawn{};        // of all figures
  bool figures_inside = true;  // the page embeds the drawings; else it refers to their files
};

// ---- The documents of a report ----

/// report.html: HTML5, well-formed as XML below its first line. With embedded figures it needs no other file; otherwise
/// it loads the figures of a data set when a reader opens it. The same input gives the same bytes.
std::string report_page(const ReportContent& content);
/// explorer.html. `shell`: the explorer built by tools/explorer. Each data set is embedded as its file and its TOML,
/// byte for byte, or, if it has several files, as its points. Empty if the shell has no place for them.
std::string explorer_page(std::string shell, const ReportContent& content);
/// results.json, schema mixity-report-1. docs/results.schema.json describes each field.
std::string report_json(const ReportContent& content);
/// summary.md: the tables, for a lab notebook.
std::string summary_markdown(const ReportContent& content);

/// Names and versions of this program and of libraries that affect numbers.
std::vector<std::pair<std::string, std::string>> versions();

struct ReportFiles {
  std::vector<OutputFile> files;  // report.html comes last
  std::string missing;            // what could not be drawn and why; empty if everything was
};

/// The files that write_report writes. `data` refers to `results`, one entry each.
ReportFiles report_files(const std::vector<Analysis>& results, const std::vector<ReportedData>& data,
                         const std::string& folder, const ReportSettings& settings);

struct WrittenReport {
  std::string page;     // path of the HTML file
  std::string missing;  // what could not be drawn and why; empty if everything was
};

/// Writes report.html, summary.md, results.json, fits.csv, residuals.csv, curves.csv, figures/ and, if requested,
/// explorer.html into the folder, the page last. `data` refers to `results`, one entry each. Throws OutputError and
/// leaves the files of the last report in place, also if a data file would be overwritten.
WrittenReport write_report(const std::vector<Analysis>& results, const std::vector<ReportedData>& data,
                           const std::string& folder, const ReportSettings& settings);

}  // namespace mixity
