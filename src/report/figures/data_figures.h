// The figures that apply to one data set and its fits, and the reasons why others are left out.
#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "analysis/reported_data.h"
#include "report/figures/figure.h"

namespace mixity {

struct FigureGroup {
  std::string title;
  std::vector<Figure> figures;
};
struct MissingFigure {
  std::string what, why;
};
struct DataFigures {
  std::vector<FigureGroup> groups;
  std::vector<MissingFigure> left_out;
  std::vector<InputFile> drawings;  // read for figures of the log, without their content
};

DataFigures data_figures(const ReportedData& data);

/// Figures have phase angles in degrees, files in radians.
inline double degrees(double psi) { return psi * 180 / std::numbers::pi; }

/// The indices 0 to n - 1.
std::vector<std::size_t> first_indices(std::size_t n);

/// The points that a figure of `series` series shows: all, or an evenly spread part, so that the figure has at most
/// 2000.
std::vector<std::size_t> shown_points(const std::vector<std::size_t>& points, std::size_t series = 1);

/// " 2000 of 50000 points are shown.", or empty if all are.
std::string shown_note(std::size_t shown, std::size_t all);

// ---- Each function makes one figure or kind of figure, none if it would be empty. Names begin with the stem. ----

/// f(psi): data, models and the bands of their intervals (the paper's Fig. 3, 7, 9).
std::vector<Figure> toughness_figures(const ReportedData& data);
/// A(T) of all models together, then of each with both branches, instabilities and strength (Fig. 8, 10).
std::vector<Figure> area_figures(const ReportedData& data);
/// Of elliptic contacts: a/b against T, and the region of both couplings.
std::vector<Figure> axes_figures(const ReportedData& data);
/// Pull-off loads against the tangential load or displacement that is held.
std::vector<Figure> pull_off_figures(const ReportedData& data);
/// Residuals against psi, T and load.
std::vector<Figure> residual_figures(const ReportedData& data);
/// Quantiles of the residuals against those of a normal distribution, for 8 points or more; not for models that
/// describe the data far worse than another.
std::vector<Figure> normal_figures(const ReportedData& data);
/// The cost profiled along each free parameter.
std::vector<Figure> profile_figures(const ReportedData& data);
/// The parameter fitted to each run alone, beside the pooled value.
std::vector<Figure> run_figures(const ReportedData& data);
/// Error in A for loads left out of the fit.
std::vector<Figure> left_out_figures(const ReportedData& data);
/// u(T), A(u) (Fig. 6) and a(P) (Fig. 4) for the fitted parameters.
std::vector<Figure> behaviour_figures(const ReportedData& data);
/// Regimes over load and lambda, with the data's loads; a map with a single regime is left out.
std::vector<Figure> regime_figures(const ReportedData& data, std::vector<MissingFigure>& left_out);
/// alpha against A0 with the exponents -5/4 and -3/2.
std::vector<Figure> sahli_figures(const ReportedData& data);
/// T(t) of the log's runs with maxima and minima (Fig. 2), as `mixity runs` drew them; at most eight. Adds what was
/// read and what is left out.
std::vector<Figure> kept_log_figures(const ReportedData& data, DataFigures& all);
/// T/A_Hertz against P at peak and minimum (Fig. 11), with the jump that each model predicts.
std::vector<Figure> peak_figures(const ReportedData& data);

}  // namespace mixity
