// The text report, one golden file for each status. After a deliberate change of the text, run the test once with
// MIXITY_UPDATE_GOLDEN=1 and read the difference before committing it.
#include "report/fit_text.h"

#include <gtest/gtest.h>

#include "report/golden_file.h"

namespace mixity {
namespace {

JobResult example(FitStatus status) {
  JobResult result;
  result.data.path = "data/example.csv";
  result.data.name = "example";
  result.data.metadata.provenance = Provenance::measured;
  result.data.metadata.source = "Bench 3, 2026-05-04";
  result.data.has_loads = true;
  result.data.rows = 42;
  result.data.points.resize(40);
  result.data.curves = {"P=1", "P=3"};
  result.data.display.area = "mm^2";
  result.data.excluded = {{7, "T < 0"}, {9, "include = 0"}};

  FitResult fit;
  fit.model = "c";
  fit.model_name = "Papangelo-Ciavarella 2019";
  fit.formula = "f = 1/(1 + (lambda-1) sin^2(psi))";
  fit.status = status;
  fit.parameters = {{"lambda", 0.0023456789, 1.2345e-5, 0, 1}};
  fit.used.resize(40);
  fit.r2 = 0.99990826;
  fit.rmse = 0.01541;
  fit.max_abs_residual = 0.0539;
  fit.area = AreaGoodness{0.99935, 0.0021636, 0.00655, 38, 2, {}};
  result.job.published["c"] = {{"lambda", 0.0023, 0.00005}, {"r2", 0.9999, 0.00005}};
  result.fits = {fit};
  return result;
}

TEST(FitText, Ok) { expect_golden(example(FitStatus::ok), "ok.txt"); }

TEST(FitText, AtBound) {
  JobResult result = example(FitStatus::at_bound);
  result.fits[0].message = "lambda is at its lower bound 0";
  result.fits[0].parameters[0] = {"lambda", 0.0, {}, 0, 1, true};
  expect_golden(result, "at_bound.txt");
}

TEST(FitText, NotIdentifiable) {
  JobResult result = example(FitStatus::not_identifiable);
  FitResult& fit = result.fits[0];
  fit.message = "the data do not constrain lambda: every value in the range fits";
  fit.parameters[0].value.reset();
  fit.parameters[0].stderr_.reset();
  fit.r2.reset();
  fit.rmse.reset();
  fit.max_abs_residual.reset();
  fit.area.reset();
  expect_golden(result, "not_identifiable.txt");
}

TEST(FitText, Multimodal) {
  JobResult result = example(FitStatus::multimodal);
  result.fits[0].message = "another minimum fits as well within the scatter: lambda = 0.41";
  expect_golden(result, "multimodal.txt");
}

TEST(FitText, NotConverged) {
  JobResult result = example(FitStatus::not_converged);
  result.fits[0].message = "the solver stopped where the gradient is not zero (relative size 0.002)";
  result.fits[0].parameters[0].stderr_.reset();
  expect_golden(result, "not_converged.txt");
}

TEST(FitText, ReconstructedWithManyExclusionsAndAHeldParameter) {
  JobResult result = example(FitStatus::ok);
  result.data.metadata.provenance = Provenance::reconstructed;
  for (std::size_t line = 10; line < 20; ++line) result.data.excluded.push_back({line, "T is not finite"});
  result.fits[0].scale = Scale::linear;
  result.fits[0].parameters = {{"r", 1.774, {}, 1e-3, 1e3, false, true}, {"eta", 2.284, 0.41, 1e-2, 1e2}};
  result.fits[0].excluded = {{30, "model a has an infinite toughness at this psi"}};
  expect_golden(result, "reconstructed.txt");
}

}  // namespace
}  // namespace mixity
