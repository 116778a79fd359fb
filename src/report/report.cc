#include "report/report.h"

#include <deque>
#include <iterator>
#include <optional>

#include "analysis/readers_units.h"
#include "analysis/run.h"
#include "base/files.h"
#include "report/fit_csv.h"

namespace mixity {
namespace {

void append(std::vector<OutputFile>& files, std::vector<OutputFile> more) {
  files.insert(files.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

std::size_t bytes_of_drawings(const std::vector<OutputFile>& files) {
  std::size_t bytes = 0;
  for (const OutputFile& file : files)
    if (file.path.ends_with(".svg")) bytes += file.content.size();
  return bytes;
}

/// Each data set in units for readers.
class ShownData {
 public:
  explicit ShownData(const std::vector<ReportedData>& data) : data_(data) {
    for (const ReportedData& one : data) {
      auto result = in_readers_units(one.result);
      if (result) results_.push_back(std::move(*result));
      changed_.push_back(result ? std::optional(with_result(results_.back(), one)) : std::nullopt);
    }
  }
  const ReportedData& of(std::size_t i) const { return changed_[i] ? *changed_[i] : data_[i]; }

 private:
  static ReportedData with_result(const Analysis& result, const ReportedData& data) {
    return {result,           data.stem,  figured_models(result), data.sahli,
            data.sahli_model, data.peaks, data.predicted_peaks,   answer_of(result)};
  }

  const std::vector<ReportedData>& data_;
  std::deque<Analysis> results_;  // whose addresses are kept
  std::deque<std::optional<ReportedData>> changed_;
};

}  // namespace

ReportFiles report_files(const std::vector<Analysis>& results, const std::vector<ReportedData>& data,
                         const std::string& folder, const ReportSettings& settings) {
  ReportContent content{settings, {}};
  const ShownData shown(data);
  const double share = 0.9 / static_cast<double>(data.size());  // of the time
  for (const ReportedData& one : data) {
    const double before = share * static_cast<double>(content.entries.size());
    const ReportedData& for_readers = shown.of(content.entries.size());
    content.entries.push_back({&one, &for_readers, data_figures(for_readers)});
    std::vector<Figure> figures;
    for (const FigureGroup& group : content.entries.back().figures.groups)
      figures.insert(figures.end(), group.figures.begin(), group.figures.end());
    const Progress drawing = stretch(settings.progress, before + 0.3 * share, before + share);
    DrawnFigures drawn = draw_figures(figures, folder + "/figures", one.result.request.formats, drawing);
    append(content.drawn.files, std::move(drawn.files));
    content.drawn.endings.merge(drawn.endings);
    if (content.drawn.missing.empty()) content.drawn.missing = drawn.missing;
    if (drawing) drawing(1);
  }
  std::vector<OutputFile> files = std::move(content.drawn.files);
  content.figures_inside = bytes_of_drawings(files) <= settings.most_inside;
  if (!content.figures_inside)
    for (const ReportEntry& entry : content.entries)
      for (const FigureGroup& group : entry.figures.groups)
        append(files, draw_for_phones(group.figures, folder + "/figures"));
  files.push_back({folder + "/fits.csv", fits_csv(results)});
  files.push_back({folder + "/residuals.csv", residuals_table(results)});
  files.push_back({folder + "/curves.csv", curves_table(results)});
  files.push_back({folder + "/results.json", report_json(content)});
  files.push_back({folder + "/summary.md", summary_markdown(content)});
  if (!settings.explorer.empty())
    files.push_back({folder + "/explorer.html", explorer_page(read_file(settings.explorer), content)});
  files.push_back({folder + "/report.html", report_page(content)});
  return {std::move(files), content.drawn.missing};
}

WrittenReport write_report(const std::vector<Analysis>& results, const std::vector<ReportedData>& data,
                           const std::string& folder, const ReportSettings& settings) {
  OutputRules rules = settings.outputs;
  rules.renewed.push_back(folder + "/figures");
  for (const Analysis& one : results) {
    const std::vector<std::string> read = files_read(one);
    rules.inputs.insert(rules.inputs.end(), read.begin(), read.end());
  }
  const ReportFiles report = report_files(results, data, folder, settings);
  write_files(report.files, rules);
  if (settings.progress) settings.progress(1);
  return {report.files.back().path, report.missing};
}

}  // namespace mixity
