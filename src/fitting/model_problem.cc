#include "fitting/model_problem.h"

#include <cmath>

namespace mixity {
namespace {

struct ListedPoints final : PointSource {
  explicit ListedPoints(std::vector<MeasuredPoint> points) : list(std::move(points)) {}
  MeasuredPoint at(std::size_t i) const override { return list[i]; }
  void fill(std::span<const std::uint32_t> indices, const PointArrays& to) const override {
    for (std::size_t k = 0; k < indices.size(); ++k) {
      const MeasuredPoint& point = list[indices[k]];
      to.P[k] = point.P;
      to.T[k] = point.T;
      to.A[k] = point.A;
      to.sigma_T[k] = point.sigma_T;
      to.sigma_A[k] = point.sigma_A;
      to.near_T[k] = point.near_T;
      to.near_A[k] = point.near_A;
    }
  }
  bool has_places() const override { return true; }
  std::vector<MeasuredPoint> list;
};

}  // namespace

MeasuredPoints::MeasuredPoints(std::vector<MeasuredPoint> list)
    : size(list.size()), source_(std::make_shared<ListedPoints>(std::move(list))) {}

FreeChoice::FreeChoice(ContactModel model, const Candidate& base, const std::vector<bool>& held)
    : model_(std::move(model)), base_(base) {
  const std::span<const ParameterInfo> infos = model_.parameters();
  if (base_.parameters.size() != infos.size()) base_.parameters = ParameterValues::zeros(infos.size());
  for (std::size_t i = 0; i < infos.size(); ++i) {
    if (!held.empty() && held[i]) continue;
    of_model_.push_back(i);
    parameters_.push_back({std::string(infos[i].name), infos[i].lower, infos[i].upper});
    parameters_.back().neutral = infos[i].neutral;
  }
}

void FreeChoice::add(Constant constant, FreeParameter parameter) {
  constants_.push_back(constant);
  parameters_.push_back(std::move(parameter));
}

void FreeChoice::state(std::string_view parameter, double value, double standard_error) {
  for (FreeParameter& one : parameters_) {
    if (one.name != parameter) continue;
    one.start = value;
    one.prior = standard_error;
  }
}

Candidate FreeChoice::candidate(std::span<const double> x) const {
  Candidate result = base_;
  for (std::size_t k = 0; k < of_model_.size(); ++k) result.parameters[of_model_[k]] = x[k];
  for (std::size_t k = 0; k < constants_.size(); ++k) result.constants[constants_[k]] = x[of_model_.size() + k];
  return result;
}

double WeightedProblem::data_norm() const {
  double sum = 0;
  for (const double target : targets_) sum += target * target;
  return std::sqrt(sum);
}

}  // namespace mixity
