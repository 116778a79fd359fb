// Adds up the progress of parts that run in parallel.
#pragma once

#include <algorithm>
#include <mutex>
#include <numeric>
#include <utility>
#include <vector>

#include "solver/options.h"

namespace mixity {

/// A part that restarts keeps the fraction it had reached. `progress` must outlive this object.
class Meter {
 public:
  Meter(const Progress& progress, std::vector<double> costs)
      : progress_(progress), costs_(std::move(costs)), done_(costs_.size()) {
    for (const double cost : costs_) whole_ += cost;
  }

  /// Null if there is no callback.
  Progress part(std::size_t i) {
    if (!progress_) return {};
    return [this, i](double fraction) {
      const std::lock_guard lock(mutex_);
      done_[i] = std::max(done_[i], fraction);
      progress_(std::inner_product(done_.begin(), done_.end(), costs_.begin(), 0.0) / whole_);
    };
  }

 private:
  const Progress& progress_;
  std::vector<double> costs_, done_;
  double whole_ = 0;
  std::mutex mutex_;
};

}  // namespace mixity
