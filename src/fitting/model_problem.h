// A least-squares problem in the parameters of a model and free constants of the experiment.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "fitting/constants.h"
#include "mechanics/contact_model.h"
#include "mechanics/held_approach.h"
#include "solver/problem.h"

namespace mixity {

/// The model under these constants, on which the dimensionless compliance of a machine that holds an approach depends.
inline ContactModel at_scale(const ContactModel& model, const ConstantsScale& scale) {
  return model.has_compliance() && scale.compliance != 1
             ? model.at_held_approach(model.held_at(0).compliance * scale.compliance)
             : model;
}

/// Values of a model's parameters and of the constants of the experiment.
struct Candidate {
  ParameterValues parameters{};
  Constants constants{};
};

/// A measured point and its standard errors, dimensionless.
struct MeasuredPoint {
  double P, T, A, sigma_T, sigma_A;
  PointPlace place{};
  std::size_t run = 0;            // the run, where parameters differ between runs
  double near_T = 0, near_A = 0;  // a reading of a place near the nearest point of the curve; A = 0: not known
};

/// ln(a/b) of a point's semi-axes, NaN where it was not measured, as mechanics/states.h has it; or the load at a held
/// approach.
struct MeasuredAxes {
  double q, sigma_q, slant;
};

struct MeasuredPullOff;

/// The numbers of some measured points.
struct PointArrays {
  std::span<double> P, T, A, sigma_T, sigma_A, near_T, near_A;
};

/// Where measured points come from. Several threads may call it.
class PointSource {
 public:
  PointSource() = default;
  PointSource(const PointSource&) = delete;
  PointSource& operator=(const PointSource&) = delete;
  virtual ~PointSource() = default;
  virtual MeasuredPoint at(std::size_t i) const = 0;
  /// Fills the arrays with the points at these indices: for many points far faster than at().
  virtual void fill(std::span<const std::uint32_t> indices, const PointArrays& arrays) const = 0;
  /// Whether a point may have another place than PointPlace{}.
  virtual bool has_places() const = 0;
};

/// Measured points. Those of a large data set are computed on demand: an array of millions would be most of the memory
/// of a fit.
class MeasuredPoints {
 public:
  MeasuredPoints(std::size_t n, std::shared_ptr<const PointSource> source) : size(n), source_(std::move(source)) {}
  MeasuredPoints(std::vector<MeasuredPoint> list);

  MeasuredPoint at(std::size_t i) const { return source_->at(i); }
  void fill(std::span<const std::uint32_t> indices, const PointArrays& arrays) const { source_->fill(indices, arrays); }
  bool has_places() const { return source_->has_places(); }

  std::size_t size;
  std::shared_ptr<const std::vector<MeasuredAxes>> axes{};         // null: not fitted
  std::shared_ptr<const std::vector<MeasuredPullOff>> pull_off{};  // null: none

 private:
  std::shared_ptr<const PointSource> source_;
};

/// Which parameters are free, in the solver's order, and at which values the others are held.
class FreeChoice {
 public:
  /// `base`: values of everything that is not free; `held`: one flag per parameter of the model; empty: none.
  FreeChoice(ContactModel model, const Candidate& base, const std::vector<bool>& held);
  void add(Constant constant, FreeParameter parameter);
  /// States a free parameter of the model with a standard error: it gets a prior.
  void state(std::string_view parameter, double value, double standard_error);

  const ContactModel& model() const { return model_; }
  const std::vector<FreeParameter>& parameters() const { return parameters_; }
  const std::vector<std::size_t>& of_model() const { return of_model_; }  // indices of free model parameters
  const std::vector<Constant>& constants() const { return constants_; }   // after them
  std::size_t size() const { return parameters_.size(); }
  /// Whether a constant is free that acts on some points more than on others.
  bool has_changes() const {
    return std::any_of(constants_.begin(), constants_.end(), [](Constant one) { return is_change(one); });
  }

  const Constants& fixed_constants() const { return base_.constants; }  // the values of those that are not free
  Candidate candidate(std::span<const double> x) const;

  /// Fills a row of the Jacobian. `by_parameter`: the residual's derivatives in all model parameters; in(constant):
  /// that in a constant.
  template <class In>
  void fill_row(std::span<double> row, const double* by_parameter, const In& in) const {
    std::size_t k = 0;
    for (const std::size_t parameter : of_model_) row[k++] = by_parameter[parameter];
    for (const Constant constant : constants_) row[k++] = in(constant);
  }

 private:
  ContactModel model_;
  Candidate base_;
  std::vector<std::size_t> of_model_;
  std::vector<Constant> constants_;
  std::vector<FreeParameter> parameters_;
};

inline constexpr std::size_t kSample = 32;  // points, enough to find the basins of a cost

/// Base of the objectives. A residual is the model's value minus the target, times the weight of the point.
class ModelProblem : public Problem {
 public:
  explicit ModelProblem(FreeChoice choice) : choice_(std::move(choice)) {}
  const std::vector<FreeParameter>& parameters() const override { return choice_.parameters(); }
  Candidate candidate(std::span<const double> x) const { return choice_.candidate(x); }
  /// Weighted data, in the fitted space.
  virtual std::vector<double> targets() const = 0;
  /// 1/standard error of each target, or 1.
  virtual std::vector<double> weights() const = 0;
  bool known_errors() const final { return known_errors_; }
  void set_known_errors(bool known) { known_errors_ = known; }

 protected:
  const ContactModel& model() const { return choice_.model(); }
  std::size_t model_parameters() const { return model().parameters().size(); }

  FreeChoice choice_;

 private:
  bool known_errors_ = false;
};

/// Base of objectives that store targets and weights.
class WeightedProblem : public ModelProblem {
 public:
  using ModelProblem::ModelProblem;
  std::size_t residual_count() const override { return targets_.size(); }
  std::vector<double> targets() const override { return targets_; }
  std::vector<double> weights() const override { return weights_; }
  double data_norm() const override;

 protected:
  std::vector<double> targets_, weights_;
};

}  // namespace mixity
