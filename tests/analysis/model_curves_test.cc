// What figures draw of the fitted models.
#include "analysis/model_curves.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/request.h"
#include "analysis/run.h"
#include "fitting/misread_data.h"

namespace mixity {
namespace model_curves_test {

/// A band that stopped at the frame would be cut aslant where its ends stop at different psi.
TEST(ModelCurves, EndsOfABandRunToTheSamePsiAboveTheFrameToo) {
  FitRequest request;
  request.data_path = MIXITY_ROOT "/data/as4_peek_mmb.csv";
  request.models = {"a", "b", "c"};
  const Analysis result = run(request);
  const FiguredModels figured = figured_models(result);
  int beyond = 0, bands = 0;
  for (const ModelCurves& model : figured.models) {
    for (const auto& [psi, f] : model.toughness) EXPECT_TRUE(std::isfinite(f)) << model.fit->model << ' ' << psi;
    if (!model.toughness_band) continue;
    ++bands;
    for (const auto& end : {model.toughness_band->first, model.toughness_band->second}) {
      EXPECT_EQ(end.back().first, figured.toughness.last_psi) << model.fit->model;
      beyond += end.back().second > figured.toughness.most;
    }
  }
  EXPECT_GT(bands, 0);
  EXPECT_GT(beyond, 0);
}

Analysis with_free_toughness(const std::string& shipped, const std::string& model) {
  FitRequest request;
  request.data_path = MIXITY_ROOT "/data/" + shipped;
  request.models = {model};
  request.options.free = {kToughness};
  request.options.checks = false;
  return run(request);
}

/// Three series with a toughness each, and no stated one.
TEST(ModelCurves, RatiosAreOverTheToughnessThatIsFoundForTheirSeries) {
  const Analysis result = with_free_toughness("snow_weak_layers_manual.csv", "c");
  const FitResult& fit = result.fits.at(0);
  const Dataset& data = result.data;
  const std::vector<double> over = over_fitted_toughness(data, fit);
  ASSERT_EQ(over.size(), 3u);
  for (std::size_t run = 0; run < 3; ++run) {
    const FittedParameter* const found = find_parameter(fit.parameters, "toughness(" + data.curves[run] + ")");
    ASSERT_TRUE(found && found->value) << run;
    EXPECT_EQ(over[run], data.display.energy_scale / *found->value);
  }
  // then the points lie about the fitted curve
  double sum = 0;
  for (std::size_t i = 0; i < data.points.size(); ++i) sum += data.toughness(i)->ratio * over[data.points[i].curve];
  EXPECT_GT(sum / static_cast<double>(data.points.size()), 1);
  EXPECT_EQ(over_fitted_toughness(data, {}).at(0), 1);
}

/// Gc in N/mm, whose toughness is stated and is shown in J/m^2.
TEST(ModelCurves, RatiosAreOverTheToughnessThatIsFoundWhateverItsUnit) {
  const Analysis result = with_free_toughness("im7_8552_mmb.csv", "bk");
  const FitResult& fit = result.fits.at(0);
  const FittedParameter* const found = find_parameter(fit.parameters, "toughness");
  ASSERT_TRUE(found && found->value && found->unit == "J/m^2");
  EXPECT_NEAR(over_fitted_toughness(result.data, fit).at(0) * *found->value, 324, 1e-9);
}

/// Loads that are read 4 mN too large, which the metadata state.
TEST(ModelCurves, MapsOfRegimesAreOfTheLoadsAsCorrected) {
  FitRequest request;
  request.models = {"c"};
  request.options.objective = Objective::toughness;
  const Misread misread = misread_mergel().at(0);
  ASSERT_EQ(misread.constant, "load_offset");
  const Analysis right = run(request, mergel()), other = run(request, misread.data);
  const FiguredModels one = figured_models(right), two = figured_models(other);
  const ModelMap &map = *one.models.at(0).map, &shifted = *two.models.at(0).map;
  const double offset = misread.data.stated_constants()[kLoadOffset];
  EXPECT_EQ(shifted.runs, map.runs);
  EXPECT_NEAR(shifted.frame.P_low + offset, map.frame.P_low, 1e-9);
  EXPECT_NEAR(shifted.frame.P_high + offset, map.frame.P_high, 1e-9);
  ASSERT_EQ(shifted.regions.size(), map.regions.size());
  for (std::size_t i = 0; i < map.regions.size(); ++i)
    EXPECT_NEAR(shifted.regions[i].outline.at(0).first + offset, map.regions[i].outline.at(0).first, 1e-6);
}

/// Sliding begins at T = tau0 A of the true T. A strength sqrt(1.5) times as large gives other regimes.
TEST(ModelCurves, MapsOfRegimesCompareTheTrueShearWithTheStrength) {
  FitRequest request;
  request.models = {"c"};
  const auto runs_of = [&](ModeIII convention, double strength) {
    Dataset data = mergel();
    data.metadata.mode_III = convention;
    data.metadata.shear_strength = strength;
    const Analysis result = run(request, data);
    return figured_models(result).models.at(0).map->runs;
  };
  std::size_t other = 0;
  for (const double strength : {0.3e6, 0.43e6, 0.6e6, 0.8e6}) {
    EXPECT_EQ(runs_of(ModeIII::averaged, strength), runs_of(ModeIII::half, strength)) << strength;
    other += runs_of(ModeIII::half, std::sqrt(1.5) * strength) != runs_of(ModeIII::half, strength);
  }
  EXPECT_GT(other, 0u);
}

}  // namespace model_curves_test
}  // namespace mixity
