// Prepares the points of a CurveObjective: their order, their blocks, the norm of the data, and a sample of them.
#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>
#include <utility>
#include <vector>

#include "base/threads.h"
#include "fitting/curve_blocks.h"
#include "fitting/curve_objective.h"
#include "fitting/pull_off_rows.h"

namespace mixity {

CurveObjective::CurveObjective(MeasuredPoints points, FreeChoice choice, std::vector<double> expected,
                               std::shared_ptr<const Whitening> whitening, std::vector<ParameterValues> shifts)
    : ModelProblem(std::move(choice)),
      points_(std::move(points)),
      whitening_(std::move(whitening)),
      shifts_(std::move(shifts)) {
  // The normal of the curve is taken at the place next to a reading, which noise along the curve has moved. As far as
  // the points before predict that noise, the prediction of the residual is off by -2 times the expected distance.
  if (whitening_ && !whitening_->predicted_across().empty())
    for (std::size_t i = 0; i < expected.size(); ++i) expected[i] *= 1 - 2 * whitening_->predicted_across()[i];
  if (!expected.empty()) expected_ = std::make_shared<std::vector<double>>(std::move(expected));
  const std::size_t n = points_.size;
  near_ = n >= kManyPoints && points_.at(0).near_A > 0;
  list_points();
  const double areas =
      sum_of(0, [](const PointArrays& block, std::size_t k) { return std::pow(block.A[k] / block.sigma_A[k], 2); });
  for (std::size_t i = 0; i < n && points_.has_places(); ++i) varies_ |= points_.at(i).place.has_own_constants();
  sort_points();
  data_norm_ = std::sqrt(sum_of(std::pow(std::sqrt(areas), 2), [](const PointArrays& block, std::size_t k) {
    return std::pow(block.T[k] / block.sigma_T[k], 2);
  }));
  for (std::size_t i = 0; i < pull_off_count(); ++i) {
    const MeasuredPullOff& one = (*points_.pull_off)[i];
    data_norm_ = std::hypot(data_norm_, one.P / one.sigma_P);
  }
  std::size_t run_before = 0;
  for (std::size_t rank = 0; rank < n; rank += shifts_.empty() ? kBlock : 1) {
    const std::size_t run = shifts_.empty() ? 0 : points_.at(index_of(rank)).run;
    if (rank == 0 || rank - blocks_.back() == kBlock || run != run_before) blocks_.push_back(rank);
    run_before = run;
  }
  blocks_.push_back(n);
  if (varies_) listed_.reset();
  list_axes();
}

/// Most problems are evaluated near a known minimum, and need none.
const CurveObjective* CurveObjective::sample() const {
  std::call_once(sampled_, [&] {
    const std::size_t n = points_.size;
    if (n < 2 * kSample) return;
    std::vector<MeasuredPoint> some;
    std::vector<MeasuredAxes> axes;
    for (std::size_t i = 0; i < kSample; ++i) {
      some.push_back(points_.at(index_of(i * n / kSample)));
      if (points_.axes) axes.push_back((*points_.axes)[index_of(i * n / kSample)]);
    }
    MeasuredPoints points(std::move(some));
    if (points_.axes) points.axes = std::make_shared<const std::vector<MeasuredAxes>>(std::move(axes));
    sample_ = std::make_unique<CurveObjective>(std::move(points), choice_, std::vector<double>(), nullptr, shifts_);
  });
  return sample_.get();
}

bool CurveObjective::evaluate_roughly(std::span<const double> x, std::span<double> residuals) const {
  const CurveObjective* const some = sample();
  if (!some)
    return all_blocks(x, points_, Search::rough, with_axes({residuals, {}, {}})) && add_pull_off(x, residuals, {});
  std::fill(residuals.begin(), residuals.end(), 0.0);
  return some->evaluate_roughly(x, residuals.first(some->residual_count())) && add_pull_off(x, residuals, {});
}

/// Numbers the rows of measured axes.
void CurveObjective::list_axes() {
  if (!points_.axes) return;
  axes_row_.assign(points_.size, 0);
  for (std::size_t i = 0; i < points_.size; ++i)
    if (std::isfinite((*points_.axes)[i].q)) axes_row_[i] = points_.size + axes_rows_++;
}

/// The sum over all points by rank, from parts of fixed length: it does not depend on the number of threads.
template <class Of>
double CurveObjective::sum_of(double from, const Of& of) {
  constexpr std::size_t kPart = kBlock * kBlocksOfAPart;
  const std::size_t n = points_.size;
  std::vector<double> sums((n + kPart - 1) / kPart);
  if (!sums.empty()) sums[0] = from;
  parallel_for(sums.size(), [&](std::size_t part) {
    Workspace workspace(std::min(n, kBlock), 0);
    const std::size_t end = std::min(n, (part + 1) * kPart);
    for (std::size_t rank = part * kPart; rank < end; rank += kBlock) {
      const std::size_t count = std::min(kBlock, end - rank);
      const PointArrays block = block_of(rank, count, workspace);
      for (std::size_t k = 0; k < count; ++k) sums[part] += of(block, k);
    }
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

/// Arrays are scaled faster than points that are made one by one; of millions they would be most of the memory.
void CurveObjective::list_points() {
  const std::size_t n = points_.size;
  if (n >= kManyPoints) return;
  listed_.reset(new double[kListed * n]);
  for (std::size_t rank = 0; rank < n; rank += kBlock) {
    const std::size_t count = std::min(kBlock, n - rank);
    points_.fill(Indices(*this, rank, count).list, listed(rank, count));
  }
}

PointArrays CurveObjective::listed(std::size_t rank, std::size_t count) {
  const auto array = [&](std::size_t which) { return std::span(&listed_[which * points_.size + rank], count); };
  return {array(0), array(1), array(2), array(3), array(4), array(5), array(6)};
}

/// The arrays of consecutive points by rank; those that are not listed are computed.
PointArrays CurveObjective::block_of(std::size_t rank, std::size_t count, Workspace& workspace) {
  if (listed_) return listed(rank, count);
  const PointArrays block = workspace.points(count);
  points_.fill(Indices(*this, rank, count).list, block);
  return block;
}

/// Sorts by load, so that the points of one curve are processed together. Consecutive points with the same load are
/// moved as one: a run is usually a single such block.
void CurveObjective::sort_points() {
  using Key = std::pair<std::size_t, double>;
  struct Stretch {
    Key key;
    std::size_t begin;
  };
  constexpr std::size_t kPart = kBlock * kBlocksOfAPart;
  const std::size_t n = points_.size;
  std::vector<std::vector<Stretch>> parts((n + kPart - 1) / kPart);
  parallel_for(parts.size(), [&](std::size_t part) {
    Workspace workspace(std::min(n, kBlock), 0);
    const std::size_t end = std::min(n, (part + 1) * kPart);
    for (std::size_t begin = part * kPart; begin < end; begin += kBlock) {
      const std::size_t count = std::min(kBlock, end - begin);
      const PointArrays block = block_of(begin, count, workspace);
      for (std::size_t k = 0; k < count; ++k) {
        const Key key(shifts_.empty() ? 0 : points_.at(begin + k).run, block.P[k]);
        if (parts[part].empty() || parts[part].back().key != key) parts[part].push_back({key, begin + k});
      }
    }
  });
  std::vector<Stretch> stretches;
  bool sorted = true;
  for (const auto& part : parts)
    for (const Stretch& one : part) {
      if (!stretches.empty() && stretches.back().key == one.key) continue;
      sorted &= stretches.empty() || stretches.back().key < one.key;
      stretches.push_back(one);
    }
  if (sorted) return;
  std::vector<std::size_t> by_key(stretches.size());
  std::iota(by_key.begin(), by_key.end(), std::size_t{0});
  std::stable_sort(by_key.begin(), by_key.end(),
                   [&](std::size_t i, std::size_t j) { return stretches[i].key < stretches[j].key; });
  order_.resize(n);
  std::unique_ptr<double[]> by_rank(listed_ ? new double[kListed * n] : nullptr);
  std::size_t rank = 0;
  for (const std::size_t k : by_key) {
    const std::size_t begin = stretches[k].begin,
                      count = (k + 1 < stretches.size() ? stretches[k + 1].begin : n) - begin;
    std::iota(order_.begin() + static_cast<std::ptrdiff_t>(rank),
              order_.begin() + static_cast<std::ptrdiff_t>(rank + count), static_cast<std::uint32_t>(begin));
    for (std::size_t array = 0; by_rank && array < kListed; ++array)
      std::copy_n(&listed_[array * n + begin], count, &by_rank[array * n + rank]);
    rank += count;
  }
  listed_ = std::move(by_rank);
}

}  // namespace mixity
