#include "report/figures/data_figures.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <numeric>

#include "base/inputs.h"
#include "base/phrases.h"
#include "report/figures/svg.h"

namespace mixity {
namespace {

constexpr std::size_t kMostLogs = 8, kMostPoints = 2000;

}  // namespace

std::vector<std::size_t> first_indices(std::size_t n) {
  std::vector<std::size_t> indices(n);
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  return indices;
}

std::vector<std::size_t> shown_points(const std::vector<std::size_t>& points, std::size_t series) {
  return spread(points, std::max<std::size_t>(kMostPoints / series, 2));
}

std::string shown_note(std::size_t shown, std::size_t all) {
  return shown < all ? " " + std::to_string(shown) + " of " + std::to_string(all) + " points are shown." : "";
}

std::vector<Figure> kept_log_figures(const ReportedData& reported, DataFigures& all) {
  std::vector<Figure> figures;
  const auto& paths = reported.result.request.log_figures;
  Inputs inputs;
  for (const std::size_t i : spread(first_indices(paths.size()), kMostLogs)) {
    const std::filesystem::path path = paths[i];
    const auto leave_out = [&](const std::string& why) {
      all.left_out.push_back({"the log's " + path.filename().string(), why});
    };
    std::error_code unread;
    if (!std::filesystem::is_regular_file(path, unread)) {
      leave_out("the file that the fit definition names is not there");
      continue;
    }
    auto [figure, reason, dropped] =
        kept_figure(inputs.read(path.string()), reported.stem + "_log_" + std::to_string(i + 1));
    if (figure)
      figures.push_back(std::move(*figure));
    else
      leave_out("the file that the fit definition names " + reason);
    if (!dropped.empty()) leave_out("of its drawing, what mixity's own drawings do not use: " + joined(dropped));
  }
  all.drawings = inputs.without_contents();
  return figures;
}

DataFigures data_figures(const ReportedData& reported) {
  DataFigures figures;
  const Analysis& result = reported.result;
  const Dataset& data = result.data;
  const bool any_value = std::any_of(result.fits.begin(), result.fits.end(), has_all_values);
  const std::string no_value = "no fit has a value";
  const std::string no_loads =
      "the data are " + std::string(data.has_energies ? "(G_I, G_II)" : "(psi, Gc)") + ": they have no loads and areas";
  const auto group = [&](const char* title) { figures.groups.push_back({title, {}}); };
  const auto keep = [&](std::vector<Figure> drawn) {
    std::move(drawn.begin(), drawn.end(), std::back_inserter(figures.groups.back().figures));
  };
  const auto keep_or_say_why = [&](std::vector<Figure> drawn, const char* what, const std::string& why) {
    if (drawn.empty()) figures.left_out.push_back({what, why});
    keep(std::move(drawn));
  };
  const auto load_reason = [&](const std::string& otherwise) {
    if (data.has_loads && data.points.empty()) return std::string("the data are pull-off loads: they have no areas");
    return !data.has_loads ? no_loads : !any_value ? no_value : otherwise;
  };

  group("Do the models describe the data?");
  keep_or_say_why(area_figures(reported), "contact area against tangential load", load_reason(no_value));
  keep(axes_figures(reported));
  keep(pull_off_figures(reported));
  keep_or_say_why(toughness_figures(reported), "toughness ratio against phase angle", "no point has a phase angle");
  group("How well is the parameter known?");
  keep_or_say_why(profile_figures(reported), "profile of the cost",
                  any_value ? "no interval was asked for, or the fit leaves no degrees of freedom" : no_value);
  keep_or_say_why(run_figures(reported), "parameter against normal load",
                  load_reason("there is one run only, or no run determines the parameter"));
  keep_or_say_why(left_out_figures(reported), "error on loads left out",
                  load_reason("it needs several models, two runs or more, and fits that succeed without each of them"));
  group("Residuals");
  keep_or_say_why(residual_figures(reported), "residuals", no_value);
  keep_or_say_why(normal_figures(reported), "normal probability plot of the residuals",
                  any_value ? "it needs 8 points or more, which scatter" : no_value);
  group("What the models predict");
  keep_or_say_why(behaviour_figures(reported), "displacement and radius curves",
                  load_reason("no tangential load is above 0"));
  keep_or_say_why(regime_figures(reported, figures.left_out), "regime map",
                  load_reason("no fitted model has lambda as its only parameter and more than one regime"));
  group("From the log");
  keep(kept_log_figures(reported, figures));
  group("Other laws");
  keep_or_say_why(sahli_figures(reported), "alpha against A0",
                  data.has_loads ? "fewer than two runs in which A falls with T²" : no_loads);
  keep_or_say_why(
      peak_figures(reported), "mean shear stress at peak and minimum",
      reported.peaks ? "no row has P > 0" : "the fit definition names no file of peak forces (peaks = ...)");
  std::erase_if(figures.groups, [](const FigureGroup& one) { return one.figures.empty(); });
  return figures;
}

}  // namespace mixity
