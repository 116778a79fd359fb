// Curves of the fitted models for a report's figures: bands of intervals, radii and maps.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "analysis/result.h"
#include "fitting/predicted_curves.h"
#include "mechanics/regime_map.h"

namespace mixity {

/// Regimes over the load and the one parameter of a model, with the stated shear strength if any.
struct ModelMap {
  RegimeMapFrame frame;
  std::vector<RegimeRegion> regions;        // outlines in measured loads, dimensionless
  std::vector<std::optional<Regime>> runs;  // regime at the fitted parameter and the load of each run
};

struct ModelCurves {
  using Toughness = std::vector<std::pair<double, double>>;  // (psi, f)

  const FitResult* fit;                                      // has values
  std::vector<DrawnCurve> areas;                             // one per shown run
  std::vector<std::pair<DrawnCurve, DrawnCurve>> area_band;  // the same for both ends of the interval; or empty
  std::vector<DrawnRadii> radii;                             // one for each of FiguredModels::shears
  Toughness toughness;
  std::optional<std::pair<Toughness, Toughness>> toughness_band{};  // for both ends of the interval
  std::optional<ModelMap> map{};                                    // only for a model with one parameter
};

/// The extent of a figure of the toughness.
struct ToughnessRange {
  double last_psi = 0, most = 0;  // where the curves end
  double least = 1, largest = 1;  // extremes of the measured ratios and 1
  bool logarithmic = false;
};

struct FiguredModels {
  std::vector<std::size_t> runs;  // the shown runs by falling load: all, or eight spread over them
  double T_data = 0;              // the largest T of the data
  std::vector<double> shears;     // 1/4, 1/2, 3/4 and all of T_data
  double P_most = 0;              // the largest load for which radii are drawn
  ToughnessRange toughness;
  std::vector<ModelCurves> models;  // one per fit with values
};

/// Areas are drawn up to this multiple of T_data.
inline constexpr double kWidestArea = 2.1;

/// Loads and shears are dimensionless; curves are in the units of the data file.
FiguredModels figured_models(const Analysis& result);

/// For each run the factor that puts measured ratios, which are over the stated G_Ic, over the one that this fit found,
/// of the run or of all; 1 where it found none, and for data with loads.
std::vector<double> over_fitted_toughness(const Dataset& data, const FitResult& fit);

/// n of the items, evenly spread, including the first and the last; all if there are at most n.
std::vector<std::size_t> spread(const std::vector<std::size_t>& items, std::size_t n);

}  // namespace mixity
