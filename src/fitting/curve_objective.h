// Objective `curve`: signed distances of measured points (P, T, A) from the equilibrium curves of their loads, in the
// plane of T and A, in units of the standard errors. Any of the constants of the experiment may be free.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>

#include "fitting/error_model.h"
#include "fitting/model_problem.h"
#include "fitting/whitening.h"

namespace mixity {

class CurveObjective final : public ModelProblem {
 public:
  /// What is subtracted from the distances, by point; null: nothing.
  using Expected = std::shared_ptr<const std::vector<double>>;
  /// Standard errors must be > 0. Targets, from which the reported R^2 is computed, are the areas. A residual is the
  /// distance minus the `expected` one (empty: 0), decorrelated by `whitening` (null: unchanged). `shifts`: deviations
  /// of each run's model parameters from the common ones; empty: 0.
  CurveObjective(MeasuredPoints points, FreeChoice choice, std::vector<double> expected = {},
                 std::shared_ptr<const Whitening> whitening = {}, std::vector<ParameterValues> shifts = {});

  /// Those of the points, then those of the axes that were measured, then those of pull-off loads.
  std::size_t residual_count() const override { return points_.size + axes_rows_ + pull_off_count(); }
  std::size_t pull_off_count() const;
  /// The row of a point's axes, which follow those of the points; 0: none.
  std::size_t row_of_axes(std::size_t point) const { return axes_row_.empty() ? 0 : axes_row_[point]; }
  /// The norm of the data, T included.
  double data_norm() const override { return data_norm_; }
  std::vector<double> targets() const override;
  std::vector<double> weights() const override;
  /// Few values suffice: basins are wide, and the paper's fit gives another start.
  std::size_t scan_density(std::size_t searched) const override { return searched == 1 ? 10 : 5; }

  bool evaluate(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const override;
  /// `memory`: T of the nearest points of the curves, then A.
  bool evaluate_again(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian,
                      std::vector<double>& memory) const override;
  /// A part is a block of consecutive points in the objective's order.
  std::size_t parts() const override;
  bool evaluate_part(std::size_t part, std::span<const double> x, std::vector<double>& residuals,
                     std::vector<double>& jacobian) const override;
  std::size_t memory_of_parts() const override { return near_ ? 0 : 2 * points_.size; }
  bool evaluate_part_again(std::size_t part, std::span<const double> x, std::vector<double>& residuals,
                           std::vector<double>& jacobian, std::span<double> memory) const override;
  /// To first order, at a sample of the points.
  bool evaluate_roughly(std::span<const double> x, std::span<double> residuals) const override;

  /// Computes residuals and the distances that they come from. False where a value is not finite.
  bool evaluate_both(std::span<const double> x, std::span<double> residuals, std::vector<double>& distances) const;
  /// The distances and the nearest points of the curves. `jacobian`: as evaluate() fills it, or empty. `from`: T and A
  /// of places at which the search begins, whose memory the result takes; empty: those that the points know. Null
  /// where a value is not finite.
  std::optional<NearestPlaces> nearest(std::span<const double> x, std::span<double> jacobian = {},
                                       NearestPlaces from = {}) const;
  /// Whether the positions of points matter, which depend on their places so far.
  bool has_places() const { return points_.has_places(); }
  /// The mean distance of readings with these true values and with noise of the standard errors: by Gauss-Hermite
  /// quadrature of order 3 over the noise along the curve, whose middle node contributes 0. Null where a value is not
  /// finite.
  std::optional<std::vector<double>> expected(std::span<const double> x, const NearestPlaces& places) const;
  /// In place of the list given at first: that of millions of points is not copied.
  void share_expected(Expected list) { expected_ = std::move(list); }

 private:
  struct Workspace;
  struct Beside;
  /// The outputs to fill; empty or null ones are skipped.
  struct Wanted {
    std::span<double> residuals, jacobian, places;
    NearestPlaces* nearest = nullptr;
    bool halves = false;        // adds half of each residual to what is there
    bool from_nearest = false;  // the search begins at the places in `nearest`
    std::span<double> axes{};   // residuals by row behind those of the points
  };
  /// A range of blocks. `first`: the rank of the point whose row is row 0; null: a point's row is its index.
  struct Range {
    std::size_t begin, end;
    std::optional<std::size_t> first{};
  };
  void sort_points();
  void list_points();
  /// Some of the points, evenly over the loads; null if there are few points.
  const CurveObjective* sample() const;
  PointArrays listed(std::size_t rank, std::size_t count);
  PointArrays block_of(std::size_t rank, std::size_t count, Workspace& workspace);
  template <class Of>
  double sum_of(double from, const Of& of);
  bool part_of(std::size_t part, std::span<const double> x, std::vector<double>& residuals,
               std::vector<double>& jacobian, std::span<double> memory) const;
  std::size_t index_of(std::size_t rank) const { return order_.empty() ? rank : order_[rank]; }
  struct Indices;
  void whiten(std::span<double> jacobian) const;
  void take_off_and_whiten(std::span<double> residuals, std::span<double> jacobian) const;
  struct OfAxes;
  struct OfApproach;
  void list_axes();
  Wanted with_axes(Wanted wanted) const;
  bool add_pull_off(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian) const;
  bool residuals_of(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian,
                    std::span<double> places) const;
  bool all_blocks(std::span<const double> x, const MeasuredPoints& points, Search search, const Wanted& wanted) const {
    return some_blocks(x, points, {0, blocks_.size() - 1}, search, wanted);
  }
  bool some_blocks(std::span<const double> x, const MeasuredPoints& points, const Range& range, Search search,
                   const Wanted& wanted) const;
  void scale_block(const Constants& constants, const ConstantsScale& of_all, const MeasuredPoints& points,
                   std::size_t begin, Search search, const NearestPlaces* from, Workspace& workspace,
                   CurveDistances& out) const;
  /// The parameters of a run, clamped to their ranges.
  Candidate of_run(const Candidate& of_all, std::size_t run) const;
  bool one_block(const Candidate& at, const MeasuredPoints& points, std::size_t begin, std::size_t end,
                 const Range& range, Search search, Workspace& workspace, const Wanted& wanted) const;

  MeasuredPoints points_;
  std::vector<std::uint32_t> order_;  // the points by load, or by run where parameters are shifted; empty: as given
  Expected expected_;
  std::shared_ptr<const Whitening> whitening_;
  std::vector<ParameterValues> shifts_;      // per run; empty: none
  static constexpr std::size_t kListed = 7;  // the arrays of PointArrays
  std::unique_ptr<double[]> listed_;   // the PointArrays by rank, if no run has constants of its own; null: not listed
  std::vector<std::size_t> blocks_;    // the rank at which each block begins, and the end of the last
  bool varies_ = false;                // the constants differ from run to run
  std::vector<std::size_t> axes_row_;  // per point: the row of its axes; 0: none
  std::size_t axes_rows_ = 0;
  bool near_ = false;  // the points know where the search for the nearest places begins
  double data_norm_ = 0;
  mutable std::once_flag sampled_;
  mutable std::unique_ptr<CurveObjective> sample_;
};

}  // namespace mixity
