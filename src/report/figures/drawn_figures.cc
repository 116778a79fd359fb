#include "report/figures/drawn_figures.h"

#include "report/figures/gnuplot.h"
#include "report/figures/svg.h"

namespace mixity {

DrawnFigures draw_figures(const std::vector<Figure>& figures, const std::string& folder, const FigureFormats& formats,
                          const Progress& progress) {
  DrawnFigures drawn;
  const auto add = [&](const Figure& figure, const std::string& ending, std::string content) {
    drawn.files.push_back({folder + '/' + figure.name + ending, std::move(content)});
    drawn.endings[figure.name].push_back(ending);
  };
  std::vector<const Figure*> plotted;  // kept drawings have no data
  for (const Figure& figure : figures) {
    add(figure, ".svg", svg(figure, Medium::file));
    if (figure.drawn.empty()) plotted.push_back(&figure);
  }
  std::vector<std::string> endings;
  if (formats.pdf) endings.emplace_back(".pdf");
  if (formats.png) endings.emplace_back(".png");
  if (!endings.empty() && !plotted.empty()) {
    GnuplotFigures by_gnuplot = draw_by_gnuplot(plotted, endings, progress);
    drawn.missing = std::move(by_gnuplot.missing);
    for (std::size_t i = 0; i < plotted.size(); ++i)
      for (std::size_t k = 0; k < by_gnuplot.files[i].size(); ++k)
        add(*plotted[i], endings[k], std::move(by_gnuplot.files[i][k]));
  }
  if (formats.gnuplot)
    for (const Figure* figure : plotted) {
      add(*figure, ".dat", figure_data(*figure));
      add(*figure, ".gp", figure_script(*figure));
    }
  return drawn;
}

std::string narrow_file(const Figure& figure) { return figure.name + "_narrow.svg"; }

std::vector<OutputFile> draw_for_phones(const std::vector<Figure>& figures, const std::string& folder) {
  std::vector<OutputFile> files;
  for (const Figure& figure : figures)
    if (figure.wide) files.push_back({folder + '/' + narrow_file(figure), svg(figure, Medium::file, true)});
  return files;
}

}  // namespace mixity
