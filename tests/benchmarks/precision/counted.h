// Counts what a solver of this program asks of a problem.
#pragma once

#include <memory>
#include <utility>

#include "solver/problem.h"

namespace mixity::precision {

/// Counts the sweeps of another cost.
class CountedCost final : public Cost {
 public:
  CountedCost(std::unique_ptr<Cost> cost, long& sweeps) : cost_(std::move(cost)), sweeps_(sweeps) {}
  bool exact_curvature() const override { return cost_->exact_curvature(); }
  void at(std::span<const double> x, std::span<const double> weights, CostValue& cost) override {
    ++sweeps_;
    cost_->at(x, weights, cost);
  }

 private:
  std::unique_ptr<Cost> cost_;
  long& sweeps_;
};

class CountedProblem final : public WrappedProblem {
 public:
  using WrappedProblem::WrappedProblem;
  mutable long sweeps = 0;
  std::unique_ptr<Cost> cost() const override { return std::make_unique<CountedCost>(problem_.cost(), sweeps); }

 private:
  void change(std::span<const double>, std::span<double>, std::span<double>) const override { ++sweeps; }
};

}  // namespace mixity::precision
