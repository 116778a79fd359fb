// A least-squares problem that knows which model it fits and which constants of the experiment are free: the way back
// from the solver's numbers.
#pragma once

#include <span>
#include <vector>

#include "fitting/constants.h"
#include "mechanics/contact_model.h"
#include "solver/problem.h"

namespace mixity {

/// What a fit tries out: a model's parameters, and constants of the experiment other than those stated.
struct Candidate {
  ParameterValues parameters{};
  Constants constants{};
};

/// A measured point and its standard errors, dimensionless.
struct MeasuredPoint {
  double P, T, A, sigma_T, sigma_A;
};

/// Which parameters are free, in the solver's order, and where the others are held.
class FreeChoice {
 public:
  /// `base`: where parameters are held that are not free; `held`: of each parameter of the model, or empty: none.
  FreeChoice(ContactModel model, const Candidate& base, const std::vector<bool>& held);
  void add(Constant constant, FreeParameter parameter);

  const ContactModel& model() const { return model_; }
  const std::vector<FreeParameter>& parameters() const { return parameters_; }
  const std::vector<std::size_t>& of_model() const { return of_model_; }  // indices of free model parameters
  const std::vector<Constant>& constants() const { return constants_; }   // after them
  std::size_t size() const { return parameters_.size(); }

  Candidate candidate(std::span<const double> x) const;

  /// A row of the Jacobian: `by_parameter` has the residual's derivatives in all of the model's parameters, `slopes`
  /// those in what was measured, at a point as scaled.
  void fill_row(std::span<double> row, const double* by_parameter, const ResidualSlopes& slopes,
                const MeasuredPoint& scaled, const ConstantsScale& scale) const {
    std::size_t k = 0;
    for (const std::size_t parameter : of_model_) row[k++] = by_parameter[parameter];
    for (const Constant constant : constants_) row[k++] = slopes.in(constant, scaled.P, scaled.T, scaled.A, scale);
  }

 private:
  ContactModel model_;
  Candidate base_;
  std::vector<std::size_t> of_model_;
  std::vector<Constant> constants_;
  std::vector<FreeParameter> parameters_;
};

/// What the objectives share. A residual is its model's value minus the target, each times weight.
class ModelProblem : public Problem {
 public:
  explicit ModelProblem(FreeChoice choice) : choice_(std::move(choice)) {}
  std::size_t residual_count() const override { return targets_.size(); }
  const std::vector<FreeParameter>& parameters() const override { return choice_.parameters(); }
  Candidate candidate(std::span<const double> x) const { return choice_.candidate(x); }
  /// What the residuals are differences from, in the fitted space: data times weight.
  const std::vector<double>& targets() const { return targets_; }
  /// 1/standard error of each, or 1.
  const std::vector<double>& weights() const { return weights_; }
  bool known_errors() const final { return known_errors_; }
  void set_known_errors(bool known) { known_errors_ = known; }
  double data_norm() const override;

 protected:
  const ContactModel& model() const { return choice_.model(); }
  std::size_t model_parameters() const { return model().parameters().size(); }

  FreeChoice choice_;
  std::vector<double> targets_, weights_;

 private:
  bool known_errors_ = false;
};

}  // namespace mixity
