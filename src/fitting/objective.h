// A least-squares problem that knows which model it fits and which constants of the experiment are free: the way back
// from the solver's numbers.
#pragma once

#include <cmath>

#include "dataset/dataset.h"
#include "fitting/constants.h"
#include "mechanics/registry.h"
#include "solver/problem.h"

namespace mixity {

/// What a fit tries out: a model's parameters, and constants of the experiment other than those stated.
template <class Model>
struct Candidate {
  Parameters<Model> parameters{};
  Constants constants{};
};

/// A measured point and its standard errors, dimensionless.
struct MeasuredPoint {
  double P, T, A, sigma_T, sigma_A;
};

/// Which parameters are free, in the solver's order, and where the others are held.
template <class Model>
class FreeChoice {
 public:
  static constexpr std::size_t kModel = parameter_count<Model>;

  FreeChoice(const Candidate<Model>& base, const std::array<bool, kModel>& held) : base_(base) {
    for (std::size_t i = 0; i < kModel; ++i)
      if (!held[i]) {
        const ParameterInfo& info = Model::parameters[i];
        model_.push_back(i);
        parameters_.push_back({std::string(info.name), info.lower, info.upper});
        parameters_.back().neutral = info.neutral;
      }
  }
  void add(Constant constant, FreeParameter parameter) {
    constants_.push_back(constant);
    parameters_.push_back(std::move(parameter));
  }

  const std::vector<FreeParameter>& parameters() const { return parameters_; }
  const std::vector<std::size_t>& model() const { return model_; }       // indices of free model parameters
  const std::vector<Constant>& constants() const { return constants_; }  // after them
  std::size_t size() const { return parameters_.size(); }
  /// To be held while the model is used: a fit's refits run on threads of their own.
  auto enter_model() const { return model_of_visit_.enter(); }

  Candidate<Model> candidate(std::span<const double> x) const {
    Candidate<Model> result = base_;
    for (std::size_t k = 0; k < model_.size(); ++k) result.parameters[model_[k]] = x[k];
    for (std::size_t k = 0; k < constants_.size(); ++k) result.constants[constants_[k]] = x[model_.size() + k];
    return result;
  }

  /// A row of the Jacobian: `by_parameter` has the residual's derivatives in all of the model's parameters, `slopes`
  /// those in what was measured, at a point as scaled.
  void fill_row(std::span<double> row, const double* by_parameter, const ResidualSlopes& slopes,
                const MeasuredPoint& scaled, const ConstantsScale& scale) const {
    std::size_t k = 0;
    for (const std::size_t parameter : model_) row[k++] = by_parameter[parameter];
    for (const Constant constant : constants_) row[k++] = slopes.in(constant, scaled.P, scaled.T, scaled.A, scale);
  }

 private:
  [[no_unique_address]] ModelOfVisit<Model> model_of_visit_{};
  Candidate<Model> base_;
  std::vector<std::size_t> model_;
  std::vector<Constant> constants_;
  std::vector<FreeParameter> parameters_;
};

/// What the objectives share. A residual is its model's value minus the target, each times weight.
template <class Model>
class ModelProblem : public Problem {
 public:
  explicit ModelProblem(FreeChoice<Model> choice) : choice_(std::move(choice)) {}
  std::size_t residual_count() const override { return targets_.size(); }
  const std::vector<FreeParameter>& parameters() const override { return choice_.parameters(); }
  Candidate<Model> candidate(std::span<const double> x) const { return choice_.candidate(x); }
  /// What the residuals are differences from, in the fitted space: data times weight.
  const std::vector<double>& targets() const { return targets_; }
  /// 1/standard error of each, or 1.
  const std::vector<double>& weights() const { return weights_; }
  bool known_errors() const final { return known_errors_; }
  void set_known_errors(bool known) { known_errors_ = known; }

  double data_norm() const override {
    double sum = 0;
    for (const double target : targets_) sum += target * target;
    return std::sqrt(sum);
  }

 protected:
  FreeChoice<Model> choice_;
  std::vector<double> targets_, weights_;

 private:
  bool known_errors_ = false;
};

}  // namespace mixity
