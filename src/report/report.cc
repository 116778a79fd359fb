#include "report/report.h"

#include "base/files.h"
#include "report/fit_csv.h"
#include "report/page/explorer_page.h"
#include "report/page/report_page.h"
#include "report/report_json.h"
#include "report/summary_markdown.h"

namespace mixity {

WrittenReport write_report(const std::vector<Analysis>& results, const std::vector<ReportedData>& data,
                           const std::string& folder, const ReportSettings& settings) {
  ReportContent content{settings, {}};
  const auto advance = [&](double fraction) {
    if (settings.progress) settings.progress(fraction);
  };
  std::vector<std::string> inputs;
  for (const ReportedData& one : data)
    for (std::string& input : files_read(one.result.request)) inputs.push_back(std::move(input));
  for (const ReportedData& one : data) {
    content.entries.push_back({&one, data_figures(one), answer_of(one.result)});
    std::vector<Figure> figures;
    for (const FigureGroup& group : content.entries.back().figures.groups)
      figures.insert(figures.end(), group.figures.begin(), group.figures.end());
    const auto done = static_cast<double>(content.entries.size()), all = static_cast<double>(data.size());
    DrawnFigures drawn = draw_figures(figures, folder + "/figures", one.result.request.formats,
                                      stretch(settings.progress, 0.9 * (done - 0.7) / all, 0.9 * done / all));
    content.drawn.files.insert(content.drawn.files.end(), drawn.files.begin(), drawn.files.end());
    content.drawn.endings.merge(drawn.endings);
    if (content.drawn.missing.empty()) content.drawn.missing = drawn.missing;
    advance(0.9 * done / all);
  }
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
