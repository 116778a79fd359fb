// A whole request: what stops it, and its progress.
#include "analysis/run.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "analysis/request.h"
#include "analysis/settings.h"
#include "dataset/temporary_folder.h"
#include "fitting/measured_runs.h"

namespace mixity {
namespace run_test {

/// Two loads, three models.
FitRequest request_in(const TemporaryFolder& folder) {
  FitRequest request;
  request.data_path =
      folder.write("a.csv", "P,T,A\n1,0,19.6\n1,5,19.2\n1,8,18.7\n1,10,18\n5,0,23.9\n5,8,23.3\n5,12,22.1\n5,14,21.4\n");
  request.models = {"a", "b", "c"};
  return request;
}

TEST(Run, WithAnUnknownModelIsAnErrorAndNoBlankResult) {
  const TemporaryFolder folder;
  for (const std::vector<std::string>& models : {std::vector<std::string>{"z"}, {"c", "z"}, {"c", ""}, {"C"}}) {
    FitRequest request = request_in(folder);
    request.models = models;
    EXPECT_THROW(run(request), std::invalid_argument);
  }
}

/// Nothing that takes long stands at one number: each fit tells of its stages, the comparison and the fits of single
/// runs of each run, the refits of each share of them.
TEST(Run, TellsOfItsProgressInSmallStepsThatNeverFall) {
  const TemporaryFolder folder;
  FitRequest request = request_in(folder);
  request.per_curve = true;
  for (const std::size_t replicates : {0, 200}) {
    request.options.bootstrap.replicates = replicates;
    request.options.influence = replicates > 0;
    std::vector<double> told;
    run(request, [&](double fraction) { told.push_back(fraction); });
    double before = 0;
    for (const double fraction : told) {
      EXPECT_GE(fraction, before);
      EXPECT_LE(fraction - before, 0.15);  // each model's fit is 10 of 72 parts, or less where there are refits
      before = fraction;
    }
    ASSERT_FALSE(told.empty());
    EXPECT_EQ(told.back(), 1);
  }
}

/// P in N where the heading says mN.
TEST(Run, OfAreasBelowHertzSaysThatAUnitIsOff) {
  const TemporaryFolder folder;
  FitRequest request = request_in(folder);
  request.data_path =
      folder.write("b.csv", "P,T,A\n1000,0,19.6\n1000,5,19.2\n1000,8,18.7\n1000,10,18\n5000,0,23.9\n5000,8,23.3\n");
  for (const FitResult& fit : run(request).fits) {
    EXPECT_NE(fit.status, FitStatus::ok);
    EXPECT_NE(fit.message.text().find("most areas do not exceed that of Hertz at their load: a unit is probably off"),
              std::string::npos)
        << fit.message.text();
  }
  for (const FitResult& fit : run(request_in(folder)).fits)
    EXPECT_EQ(fit.message.text().find("Hertz"), std::string::npos);
}

/// Such areas hardly change lambda, so that the score tests alone let the fit pass.
TEST(Run, WithAreasWithoutShearThatAreTooLargeNamesTheirOwnToughnessWhichEndsOkAndRight) {
  std::size_t hardly = 0;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    FitRequest request;
    request.models = {"c"};
    Dataset data = measured_runs(seed);
    for (Point& point : data.points)
      if (point.T == 0) point.A *= 1.04;
    const FitResult fit = run(request, data).fits.at(0);
    EXPECT_EQ(fit.status, FitStatus::suspect) << seed;
    ASSERT_FALSE(fit.explanations.empty()) << seed << ' ' << fit.message.text();
    EXPECT_EQ(fit.explanations[0].cause, "hysteresis") << seed;
    EXPECT_NE(fit.message.text().find("larger by"), std::string::npos) << fit.message.text();
    hardly += fit.message.text().starts_with("the areas without shear do not agree");
    request.exclusion.unsheared = Unsheared::own;
    const FitResult own = run(request, data).fits.at(0);
    EXPECT_EQ(own.status, FitStatus::ok) << seed << own.message.text();
    EXPECT_NEAR(*own.parameters[0].value, 0.15, 4 * *own.parameters[0].stderr_) << seed;
  }
  EXPECT_GT(hardly, 0U);
}

/// Without errors of T the density ends where a measured T exceeds that of the jump.
TEST(Run, WithExactShearNearTheJumpHasAnEvidence) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    SeededNoise noise(seed, 0.03);
    Dataset data = measured_runs(1);
    data.points = synthetic_runs("c", {0.15}, {-1, 0.5, 2, 5, 12, 30}, 25, 0.97, noise).points;
    FitRequest request;
    request.models = {"c"};
    const FitResult fit = run(request, data).fits.at(0);
    ASSERT_TRUE(fit.evidence) << seed << ' ' << fit.message.text();
    const FittedParameter& lambda = fit.parameters[0];
    EXPECT_NEAR(fit.evidence->evidence.mean, *lambda.value, 0.2 * *lambda.stderr_) << seed;
    EXPECT_NEAR(fit.evidence->evidence.standard_deviation, *lambda.stderr_, 0.1 * *lambda.stderr_) << seed;
  }
}

TEST(Run, TakesAStandardErrorOfZeroWithoutAUnit) {
  FitRequest request;
  request.data_path = MIXITY_ROOT "/data/mergel2018.csv";
  request.models = {"c"};
  ASSERT_EQ(set_option(request, "sigma_T", "0"), "");
  ASSERT_EQ(set_option(request, "sigma_A", "0.004 mm^2"), "");
  const FitResult fit = run(request).fits.at(0);
  EXPECT_TRUE(fit.parameters[0].value);
  EXPECT_EQ(fit.errors->source_T, ErrorSource::stated);
}

TEST(Run, NamesEveryFileThatItReads) {
  Analysis analysis;
  analysis.request.path = "fit.toml";
  analysis.request.data_path = "a.csv";
  analysis.request.peaks_path = "p.csv";
  analysis.data.metadata.headings = "names.toml";
  EXPECT_EQ(files_read(analysis),
            (std::vector<std::string>{"a.csv", "a.toml", "p.csv", "p.toml", "fit.toml", "names.toml"}));
}

}  // namespace run_test
}  // namespace mixity
