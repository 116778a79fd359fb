// A least-squares problem that knows which model it fits: the way back from the solver's numbers.
#pragma once

#include "fitting/least_squares.h"
#include "fitting/trial.h"

namespace mixity {

template <class Model>
class ModelProblem : public LeastSquares {
 public:
  virtual Trial<Model> trial(std::span<const double> x) const = 0;
  /// What the residuals are differences from, in the fitted space: data times weight.
  virtual const std::vector<double>& targets() const = 0;
  /// 1/standard error of each, or 1.
  virtual const std::vector<double>& weights() const = 0;
  bool known_errors() const final { return known_errors_; }
  void set_known_errors(bool known) { known_errors_ = known; }

  double data_norm() const override {
    double sum = 0;
    for (const double target : targets()) sum += target * target;
    return std::sqrt(sum);
  }

 private:
  bool known_errors_ = false;
};

/// Which parameters are free, in the solver's order, and where the others are held.
template <class Model>
class FreeChoice {
 public:
  static constexpr std::size_t kModel = parameter_count<Model>;

  FreeChoice(const Trial<Model>& base, const std::array<bool, kModel>& held) : base_(base) {
    for (std::size_t i = 0; i < kModel; ++i)
      if (!held[i]) {
        const ParameterInfo& info = Model::parameters[i];
        model_.push_back(i);
        parameters_.push_back({std::string(info.name), info.lower, info.upper});
        parameters_.back().neutral = info.neutral;
      }
  }
  void add(Correction correction, FreeParameter parameter) {
    corrections_.push_back(correction);
    parameters_.push_back(std::move(parameter));
  }

  const std::vector<FreeParameter>& parameters() const { return parameters_; }
  const std::vector<std::size_t>& model() const { return model_; }             // indices of free model parameters
  const std::vector<Correction>& corrections() const { return corrections_; }  // after them
  std::size_t size() const { return parameters_.size(); }
  void set_start(std::size_t k, double x) { parameters_[k].start = x; }

  Trial<Model> trial(std::span<const double> x) const {
    Trial<Model> result = base_;
    for (std::size_t k = 0; k < model_.size(); ++k) result.parameters[model_[k]] = x[k];
    for (std::size_t k = 0; k < corrections_.size(); ++k) result.corrections[corrections_[k]] = x[model_.size() + k];
    return result;
  }

 private:
  Trial<Model> base_;
  std::vector<std::size_t> model_;
  std::vector<Correction> corrections_;
  std::vector<FreeParameter> parameters_;
};

}  // namespace mixity
