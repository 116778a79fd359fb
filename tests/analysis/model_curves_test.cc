// What figures draw of the fitted models.
#include "analysis/model_curves.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/request.h"
#include "analysis/run.h"

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

}  // namespace model_curves_test
}  // namespace mixity
