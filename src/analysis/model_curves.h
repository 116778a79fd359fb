// What the figures of a report draw of the fitted models: curves, the bands of their intervals, radii and maps.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "analysis/result.h"
#include "fitting/predicted_curves.h"
#include "mechanics/regime_map.h"

namespace mixity {

/// Over the load and the one parameter of a model, with the stated shear strength if there is one.
struct ModelMap {
  RegimeMapFrame frame;
  std::vector<RegimeRegion> regions;        // outlines in dimensionless loads, as measured
  std::vector<std::optional<Regime>> runs;  // at the fitted parameter and the load of each run
};

struct ModelCurves {
  using Toughness = std::vector<std::pair<double, double>>;  // (psi, f)

  const FitResult* fit;                                      // has values
  std::vector<DrawnCurve> areas;                             // of each shown run
  std::vector<std::pair<DrawnCurve, DrawnCurve>> area_band;  // the same at the two ends of the interval; or none
  std::vector<DrawnRadii> radii;                             // at each of FiguredModels::shears
  Toughness toughness;
  std::optional<std::pair<Toughness, Toughness>> toughness_band{};  // at the two ends of the interval
  std::optional<ModelMap> map{};                                    // of a model with one parameter
};

/// What a figure of the toughness shows.
struct ToughnessRange {
  double last_psi = 0, most = 0;  // where the curves end
  double least = 1, largest = 1;  // measured ratios, and 1
  bool logarithmic = false;
};

struct FiguredModels {
  std::vector<std::size_t> runs;  // that are shown: by falling load, all or eight spread over them
  double T_data = 0;              // the largest T of the data
  std::vector<double> shears;     // a quarter, half, three quarters and all of it
  double P_most = 0;              // the largest load at which radii are drawn
  ToughnessRange toughness;
  std::vector<ModelCurves> models;  // of each fit with values
};

/// Areas are drawn as far as this multiple of T_data.
inline constexpr double kWidestArea = 2.1;

/// Loads and shears are dimensionless, curves in the units of the data file.
FiguredModels figured_models(const Analysis& result);

/// n of the items, spread evenly, the first and the last among them; all if they are no more.
std::vector<std::size_t> spread(const std::vector<std::size_t>& items, std::size_t n);

}  // namespace mixity
