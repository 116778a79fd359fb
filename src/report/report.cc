#include "report/report.h"

#include "base/output_file.h"
#include "dataset/table/csv.h"
#include "report/fit_csv.h"
#include "report/page/explorer_page.h"
#include "report/page/report_page.h"
#include "report/report_json.h"
#include "report/summary_markdown.h"

namespace mixity {

WrittenReport write_report(const std::vector<Analysis>& results, const std::vector<ReportedData>& data,
                           const std::string& folder, const ReportSettings& settings) {
  ReportContent content{settings, {}, {}};
  const auto advance = [&](double fraction) {
    if (settings.progress) settings.progress(fraction);
  };
  std::vector<std::string> inputs;
  for (const ReportedData& one : data)
    for (std::string& input : files_read(one.result.request)) inputs.push_back(std::move(input));
  std::vector<Figure> figures;
  for (const ReportedData& one : data) {
    content.entries.push_back({&one, data_figures(one), answer_of(one.result)});
    for (const FigureGroup& group : content.entries.back().figures.groups)
      figures.insert(figures.end(), group.figures.begin(), group.figures.end());
    advance(0.3 * static_cast<double>(content.entries.size()) / static_cast<double>(data.size()));
  }
  content.drawn = draw_figures(figures, folder + "/figures", stretch(settings.progress, 0.3, 0.9));
  advance(0.9);
  std::vector<OutputFile> files = content.drawn.files;
  files.push_back({folder + "/fits.csv", fits_csv(results)});
  files.push_back({folder + "/residuals.csv", residuals_table(results)});
  files.push_back({folder + "/curves.csv", curves_table(results)});
  files.push_back({folder + "/results.json", report_json(content)});
  files.push_back({folder + "/summary.md", summary_markdown(content)});
  if (!settings.explorer.empty())
    files.push_back({folder + "/explorer.html", explorer_page(read_file(settings.explorer), content)});
  files.push_back({folder + "/report.html", report_page(content)});
  write_files(files, inputs);
  advance(1);
  return {files.back().path, content.drawn.missing};
}

}  // namespace mixity
