#include "report/report.h"

#include "report/fit_csv.h"
#include "report/output_file.h"
#include "report/page/report_page.h"
#include "report/report_json.h"
#include "report/summary_markdown.h"

namespace mixity {

WrittenReport write_report(const std::vector<JobResult>& results, const std::vector<ReportedData>& data,
                           const std::string& folder, const ReportSettings& settings) {
  ReportContent content{settings, {}, {}};
  const auto advance = [&](double fraction) {
    if (settings.progress) settings.progress(fraction);
  };
  std::vector<Figure> figures;
  for (const ReportedData& one : data) {
    content.entries.push_back({&one, data_figures(one)});
    for (const FigureGroup& group : content.entries.back().figures.groups)
      figures.insert(figures.end(), group.figures.begin(), group.figures.end());
    advance(0.3 * static_cast<double>(content.entries.size()) / static_cast<double>(data.size()));
  }
  content.drawn = draw_figures(figures, folder + "/figures");
  advance(0.9);
  write_file(folder + "/fits.csv", fits_csv(results));
  write_file(folder + "/residuals.csv", residuals_table(results));
  write_file(folder + "/curves.csv", curves_table(results));
  write_file(folder + "/results.json", report_json(content));
  write_file(folder + "/summary.md", summary_markdown(content));
  write_file(folder + "/report.html", report_page(content));
  advance(1);
  return {folder + "/report.html", content.drawn.missing};
}

}  // namespace mixity
