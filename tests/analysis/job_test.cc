// A whole job: what stops it, and what it tells of its progress.
#include "analysis/job.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "dataset/temporary_folder.h"

namespace mixity {
namespace {

/// Two loads, three models.
FitJob job_in(const TemporaryFolder& folder) {
  FitJob job;
  job.data_path =
      folder.write("a.csv", "P,T,A\n1,0,19.6\n1,5,19.2\n1,8,18.7\n1,10,18\n5,0,23.9\n5,8,23.3\n5,12,22.1\n5,14,21.4\n");
  job.models = {"a", "b", "c"};
  return job;
}

TEST(Job, WithAnUnknownModelIsAnErrorAndNoBlankResult) {
  const TemporaryFolder folder;
  for (const std::vector<std::string>& models : {std::vector<std::string>{"z"}, {"c", "z"}, {"c", ""}, {"C"}}) {
    FitJob job = job_in(folder);
    job.models = models;
    EXPECT_THROW(run(job), std::invalid_argument);
  }
}

/// Nothing that takes long stands at one number: each fit tells of its stages, the comparison and the fits of single
/// runs of each run, the refits of each share of them.
TEST(Job, TellsOfItsProgressInSmallStepsThatNeverFall) {
  const TemporaryFolder folder;
  FitJob job = job_in(folder);
  job.per_curve = true;
  for (const std::size_t replicates : {0, 200}) {
    job.options.bootstrap.replicates = replicates;
    job.options.influence = replicates > 0;
    std::vector<double> told;
    run(job, [&](double fraction) { told.push_back(fraction); });
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

TEST(Job, NamesEveryFileThatItReads) {
  FitJob job;
  job.path = "fit.toml";
  job.data_path = "a.csv";
  job.peaks_path = "p.csv";
  EXPECT_EQ(files_read(job), (std::vector<std::string>{"a.csv", "a.toml", "p.csv", "p.toml", "fit.toml"}));
}

}  // namespace
}  // namespace mixity
