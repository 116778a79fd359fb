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
  std::vector<std::string> inputs, paths;
  for (const ReportedData& one : data) {
    inputs.push_back(one.result.data.path);
    if (one.peaks) inputs.push_back(one.peaks->path);
  }
  for (const char* name : {"fits.csv", "residuals.csv", "curves.csv", "results.json", "summary.md", "report.html"})
    paths.push_back(folder + "/" + name);
  std::vector<Figure> figures;
  for (const ReportedData& one : data) {
    content.entries.push_back({&one, data_figures(one)});
    for (const FigureGroup& group : content.entries.back().figures.groups)
      figures.insert(figures.end(), group.figures.begin(), group.figures.end());
    advance(0.3 * static_cast<double>(content.entries.size()) / static_cast<double>(data.size()));
  }
  std::vector<std::string> outputs = paths;
  for (const Figure& figure : figures)
    for (const char* kind : {".svg", ".pdf", ".gp", ".dat"})
      outputs.push_back(folder + "/figures/" + figure.name + kind);
  spare_inputs(inputs, outputs);
  content.drawn = draw_figures(figures, folder + "/figures");
  advance(0.9);
  const std::vector<std::string> contents{fits_csv(results),    residuals_table(results),  curves_table(results),
                                          report_json(content), summary_markdown(content), report_page(content)};
  for (std::size_t i = 0; i < paths.size(); ++i) write_file(paths[i], contents[i]);
  advance(1);
  return {paths.back(), content.drawn.missing};
}

}  // namespace mixity
