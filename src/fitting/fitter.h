// One fit of one model to points of a data set.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "fitting/course.h"
#include "fitting/error_model.h"
#include "fitting/prepare.h"
#include "fitting/run_differences.h"
#include "solver/prior.h"
#include "solver/robust.h"
#include "solver/solve.h"

namespace mixity {

/// shown: a reported fit, by Ceres. values: a refit by the kernel, for its values alone. tried: like values, for a
/// possible explanation, in fewer rounds.
enum class Purpose { shown, values, tried };

/// Of a fit that is not shown: without its last digits, and without thousands of steps, which only a valley of a wrong
/// model needs.
SolverOptions options_of_refits();

class Fitter {
 public:
  /// `points`: indices of the points to fit; null: all. `near`: values to start from; null: search the whole range. All
  /// arguments must outlive this object. Throws as fit_model does.
  Fitter(const Dataset& data, const ContactModel& model, const FitOptions& options, Purpose purpose,
         const std::vector<std::size_t>* points, const std::vector<FittedParameter>* near);

  FitResult run();

 private:
  bool checked() const { return purpose_ == Purpose::shown && options_.checks; }
  FitResult&& finished();
  Verdict find_parameters(const Progress& progress);
  std::size_t unknown() const;
  bool has_too_few_points();
  bool is_beyond(double most_misfit) const;
  bool exceeds(double squares, double freedom, double at_most) const;
  bool scatters_too_far(const NearestPlaces& nearest, const std::vector<double>& leverage, const ErrorModels& models,
                        double at_most, bool chosen, std::optional<ErrorModels>& by_neighbours) const;
  void report_progress(double fraction) const;
  void describe();
  void fit_as_the_paper();
  void start_at_circles();
  Verdict find_minimum();
  Verdict minimum_with_its_errors();
  bool settle_errors(std::vector<double>& x);
  bool leads_to_the_same_errors(const std::vector<double>& x);
  void restore_errors();
  double size_stated_errors(NearestPlaces& nearest, double freedom);
  double size_axes(const NearestPlaces& nearest);
  double size_pull_off(const NearestPlaces& nearest);
  double log_size_of_areas() const;
  double take_expected_off(const std::vector<double>& expected, double freedom, NearestPlaces& nearest);
  bool expects_distances(const std::vector<double>& x);
  std::optional<NearestPlaces> nearest_and_leverages(const std::vector<double>& x, std::vector<double>& leverage,
                                                     bool lean) const;
  std::optional<ErrorModels> estimated_errors(const NearestPlaces& nearest, const std::vector<double>& leverage,
                                              const ErrorModels& before, Stage stage,
                                              const std::vector<std::vector<double>>& own) const;
  std::vector<std::vector<double>> take_runs_apart(const std::vector<double>& x, NearestPlaces& nearest,
                                                   std::vector<double>& leverage, const ErrorModels& models,
                                                   bool& apart, std::optional<ErrorModels>& by_neighbours) const;
  bool find_run_differences(std::vector<double>& x, NearestPlaces& nearest, std::vector<double>& leverage,
                            double& change);
  bool differ_more_than_neighbours(const RunRows& rows, const Groups& groups, const NearestPlaces& nearest,
                                   const std::vector<double>& leverage, const ErrorModels& models,
                                   std::optional<ErrorModels>& by_neighbours) const;
  std::optional<double> share_taken_off(const std::vector<double>& x) const;
  std::vector<double> with_other_size(const std::vector<double>& x, bool of_T, double step, double taken) const;
  void widen_by_sizes_of_errors(const std::vector<double>& x);
  void add_rows_of_axes(Groups& groups) const;
  void widen_by_jackknife(const RunRows& rows, const Groups& groups);
  bool refresh_columns(const std::vector<double>& x);
  bool shorten_steps(const std::vector<double>& x, const RunDifferences& start, NearestPlaces& nearest);
  void test_runs(const std::vector<double>& x);
  std::optional<Eigen::MatrixXd> columns_of_law(const std::vector<double>& x, const RunRows& rows) const;
  void test_law(const RunRows& rows, const Eigen::MatrixXd& columns, std::optional<double> freedom);
  void expect_shape(const std::vector<double>& x);
  std::optional<OneRun> one_run(RunRows rows, const Groups& groups, Eigen::Index quantity, double unit) const;
  bool settle_weights(Verdict& verdict);
  Verdict find_robust_minimum(Verdict verdict);
  Verdict find_minimum_of_student(Verdict verdict);
  Verdict minimum_of(const Problem& data);
  void add_evidence(const Verdict& verdict);
  void add_budget(const std::vector<double>& x, const Verdict& verdict);
  void add_pull_off(const std::vector<double>& x);
  void add_goodness(const std::vector<double>& x);
  void test_residuals(const std::vector<double>& x);
  void suspect_wide_errors();

  const Dataset& data_;
  const FitOptions& options_;
  Purpose purpose_;
  PreparedFit prepared_;
  const std::vector<std::size_t>* points_;
  StartingPoints starting_;
  SolverOptions solver_;
  std::unique_ptr<ModelProblem> problem_;
  std::optional<RobustProblem> robust_;
  std::optional<ProblemWithPriors> cost_;
  std::vector<double> first_minimum_;     // of the first of the rounds that find the errors
  std::optional<CourseTest> off_course_;  // the course because of which the fitted errors were discarded
  bool off_with_correlations_ = false;    // it came with correlations of neighbours
  bool independent_ = false;              // neighbours are taken as independent
  bool given_up_ = false;                 // no explanation, whatever the remaining rounds find
  double unit_ = 1;                       // divisor of the data's residuals in cost_
  FitResult result_;
};

}  // namespace mixity
