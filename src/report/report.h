// A report: one page, the figures by themselves, and tables, in a folder.
#pragma once

#include <string>
#include <vector>

#include "analysis/answer.h"
#include "analysis/reported_data.h"
#include "report/figures/data_figures.h"
#include "report/figures/drawn_figures.h"

namespace mixity {

struct ReportSettings {
  std::string command;  // that makes this report again
  Progress progress{};
  std::string explorer{};  // path of the explorer's page, to be written beside with the data; empty: none
};

/// One data set with its figures.
struct ReportEntry {
  const ReportedData* data;
  DataFigures figures;
  Answer answer{};
};

struct ReportContent {
  ReportSettings settings;
  std::vector<ReportEntry> entries;
  DrawnFigures drawn{};  // all figures
};

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
