// One fit: of one model to points of a data set, with what the options ask for.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "fitting/prepare.h"
#include "solver/prior.h"
#include "solver/robust.h"
#include "solver/solve.h"

namespace mixity {

/// shown: a fit of its own, by Ceres. values: one of many, by the kernel, without what is only shown. tried: the same,
/// of an explanation that may be wrong, and is given up where it takes long.
enum class Purpose { shown, values, tried };

class Fitter {
 public:
  /// `points`: indices of those to fit; null: all. `near`: where the minimum is looked for; null: anywhere. All of
  /// these must outlive this. Throws as fit_model does.
  Fitter(const Dataset& data, const ContactModel& model, const FitOptions& options, Purpose purpose,
         const std::vector<std::size_t>* points, const std::vector<FittedParameter>* near);

  FitResult run();

 private:
  bool checked() const { return purpose_ == Purpose::shown && options_.checks; }
  void report_progress(double fraction) const;
  void describe();
  void fit_as_the_paper();
  Verdict find_minimum();
  bool settle_weights(Verdict& verdict);
  Verdict find_robust_minimum(Verdict verdict);
  Verdict minimum_of(const Problem& data);
  const Problem& cost() const;
  void add_evidence(const Verdict& verdict);
  void add_budget(const std::vector<double>& x, const Verdict& verdict);
  void add_goodness(const std::vector<double>& x);
  void test_residuals();
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
  std::optional<ProblemWithPriors> priors_;
  double unit_ = 1;  // of the residuals of the data beside the priors
  FitResult result_;
};

}  // namespace mixity
