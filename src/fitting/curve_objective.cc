#include "fitting/curve_objective.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/threads.h"
#include "fitting/curve_blocks.h"
#include "fitting/pull_off_rows.h"

namespace mixity {
namespace {

constexpr std::size_t kPointsOfAThread = 1024;  // with fewer, starting a thread costs more than it saves

}  // namespace

std::vector<double> CurveObjective::targets() const {
  std::vector<double> list(points_.size);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const MeasuredPoint point = points_.at(i);
    list[i] = point.A / point.sigma_A;
  }
  return list;
}

std::vector<double> CurveObjective::weights() const {
  std::vector<double> list(points_.size);
  for (std::size_t i = 0; i < list.size(); ++i) list[i] = 1 / points_.at(i).sigma_A;
  return list;
}

bool CurveObjective::evaluate(std::span<const double> x, std::span<double> residuals,
                              std::span<double> jacobian) const {
  return residuals_of(x, residuals, jacobian, {});
}

bool CurveObjective::evaluate_again(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian,
                                    std::vector<double>& memory) const {
  if (near_) return residuals_of(x, residuals, jacobian, {});
  memory.resize(2 * points_.size, 0.0);
  return residuals_of(x, residuals, jacobian, memory);
}

std::size_t CurveObjective::parts() const {
  return whitening_ || axes_rows_ > 0 || pull_off_count() > 0
             ? 1
             : std::max<std::size_t>((blocks_.size() - 1 + kBlocksOfAPart - 1) / kBlocksOfAPart, 1);
}

bool CurveObjective::evaluate_part(std::size_t part, std::span<const double> x, std::vector<double>& residuals,
                                   std::vector<double>& jacobian) const {
  return part_of(part, x, residuals, jacobian, {});
}

bool CurveObjective::evaluate_part_again(std::size_t part, std::span<const double> x, std::vector<double>& residuals,
                                         std::vector<double>& jacobian, std::span<double> memory) const {
  return part_of(part, x, residuals, jacobian, memory);
}

bool CurveObjective::part_of(std::size_t part, std::span<const double> x, std::vector<double>& residuals,
                             std::vector<double>& jacobian, std::span<double> memory) const {
  if (parts() == 1) return Problem::evaluate_part(part, x, residuals, jacobian);
  const std::size_t begin = part * kBlocksOfAPart, end = std::min(begin + kBlocksOfAPart, blocks_.size() - 1),
                    first = blocks_[begin], n = blocks_[end] - first;
  residuals.resize(n);
  jacobian.resize(n * choice_.size());
  const std::span<double> places = memory.empty() ? memory : memory.subspan(2 * first, 2 * n);
  if (!some_blocks(x, points_, {begin, end, first}, Search::global, {residuals, jacobian, places})) return false;
  for (std::size_t i = 0; expected_ && i < expected_->size() && i < n; ++i)
    residuals[i] -= (*expected_)[index_of(first + i)];
  return true;
}

bool CurveObjective::residuals_of(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian,
                                  std::span<double> places) const {
  if (!all_blocks(x, points_, Search::global, with_axes({residuals, jacobian, places}))) return false;
  if (!add_pull_off(x, residuals, jacobian)) return false;
  take_off_and_whiten(residuals, jacobian);
  return true;
}

CurveObjective::Wanted CurveObjective::with_axes(Wanted wanted) const {
  if (axes_rows_ > 0) wanted.axes = wanted.residuals.subspan(points_.size, axes_rows_);
  return wanted;
}

std::size_t CurveObjective::pull_off_count() const { return points_.pull_off ? points_.pull_off->size() : 0; }

/// Fills the rows of pull-off loads, which are the last. The Jacobian may be empty.
bool CurveObjective::add_pull_off(std::span<const double> x, std::span<double> residuals,
                                  std::span<double> jacobian) const {
  if (!points_.pull_off) return true;
  Candidate at = candidate(x);
  model().make_continuous(at.parameters);
  const std::size_t n = pull_off_count();
  return pull_off_rows(*points_.pull_off, choice_, at, residuals.last(n),
                       jacobian.empty() ? jacobian : jacobian.last(n * choice_.size()));
}

bool CurveObjective::evaluate_both(std::span<const double> x, std::span<double> residuals,
                                   std::vector<double>& distances) const {
  if (!all_blocks(x, points_, Search::global, with_axes({residuals, {}, {}}))) return false;
  if (!add_pull_off(x, residuals, {})) return false;
  distances.assign(residuals.begin(), residuals.begin() + static_cast<std::ptrdiff_t>(points_.size));
  take_off_and_whiten(residuals, {});
  return true;
}

void CurveObjective::take_off_and_whiten(std::span<double> residuals, std::span<double> jacobian) const {
  for (std::size_t i = 0; expected_ && i < expected_->size(); ++i) residuals[i] -= (*expected_)[i];
  if (!whitening_) return;
  whitening_->apply(residuals.first(points_.size));
  if (!jacobian.empty()) whiten(jacobian);
}

void CurveObjective::whiten(std::span<double> jacobian) const {
  const std::size_t width = choice_.size();
  for (std::size_t k = 0; whitening_ && k < width; ++k)
    whitening_->apply(jacobian.first(points_.size * width).subspan(k), width);
}

std::optional<NearestPlaces> CurveObjective::nearest(std::span<const double> x, std::span<double> jacobian,
                                                     NearestPlaces from) const {
  const bool from_nearest = !from.T.empty();
  NearestPlaces found = std::move(from);
  for (std::vector<double>* const list : {&found.residuals, &found.T, &found.A, &found.load_T, &found.load_A})
    list->resize(points_.size);
  found.axes.resize(axes_rows_);
  if (!all_blocks(x, points_, Search::global, {found.residuals, jacobian, {}, &found, false, from_nearest, found.axes}))
    return std::nullopt;
  found.pull_off.resize(pull_off_count());
  if (!add_pull_off(x, found.pull_off, jacobian)) return std::nullopt;
  if (!jacobian.empty()) whiten(jacobian);
  return found;
}

/// Readings beside the true values, by noise along the curve.
struct CurveObjective::Beside final : PointSource {
  Beside(const MeasuredPoints& of, const NearestPlaces& on, double towards) : points(of), places(on), side(towards) {}
  void fill(std::span<const std::uint32_t> indices, const PointArrays& to) const override {
    points.fill(indices, to);
    for (std::size_t k = 0; k < indices.size(); ++k) {
      const std::size_t i = indices[k];
      to.near_T[k] = to.T[k] = T_of(i, to.sigma_T[k]);  // almost on the curve
      to.near_A[k] = to.A[k] = A_of(i, to.sigma_A[k]);
    }
  }
  MeasuredPoint at(std::size_t i) const override {
    MeasuredPoint point = points.at(i);
    point.T = T_of(i, point.sigma_T);
    point.A = A_of(i, point.sigma_A);
    return point;
  }
  bool has_places() const override { return points.has_places(); }
  double T_of(std::size_t i, double sigma) const { return places.T[i] + side * places.load_A[i] * sigma; }
  double A_of(std::size_t i, double sigma) const {
    return std::max(places.A[i] - side * places.load_T[i] * sigma, 0.5 * places.A[i]);
  }
  const MeasuredPoints& points;
  const NearestPlaces& places;
  double side;
};

std::optional<std::vector<double>> CurveObjective::expected(std::span<const double> x,
                                                            const NearestPlaces& places) const {
  const std::size_t n = points_.size;
  std::vector<double> mean(n, 0.0);
  const double root = 1.0;
  for (const double side : {-root, root}) {
    Wanted wanted{mean, {}, {}};
    wanted.halves = true;
    if (!all_blocks(x, {n, std::make_shared<Beside>(points_, places, side)}, Search::global, wanted))
      return std::nullopt;
  }
  return mean;
}

bool CurveObjective::some_blocks(std::span<const double> x, const MeasuredPoints& points, const Range& range,
                                 Search search, const Wanted& wanted) const {
  Candidate at = candidate(x);
  model().make_continuous(at.parameters);
  const std::size_t n = blocks_[range.end] - blocks_[range.begin];
  std::atomic<std::size_t> next = range.begin;
  std::atomic<bool> defined = true;
  const auto work = [&] {
    Workspace workspace(std::min(n, kBlock), model_parameters());
    for (std::size_t block; defined && (block = next++) < range.end;) {
      may_go_on();
      const std::size_t begin = blocks_[block], end = blocks_[block + 1];
      if (!one_block(shifts_.empty() ? at : of_run(at, points.at(index_of(begin)).run), points, begin, end, range,
                     search, workspace, wanted))
        defined = false;
    }
  };
  run_on_idle_processors(n / kPointsOfAThread, work);
  return defined;
}

Candidate CurveObjective::of_run(const Candidate& of_all, std::size_t run) const {
  Candidate own = of_all;
  const auto infos = model().parameters();
  for (std::size_t k = 0; k < own.parameters.size(); ++k)
    if (shifts_[run][k] != 0)
      own.parameters[k] = std::clamp(own.parameters[k] + shifts_[run][k], infos[k].lower, infos[k].upper);
  model().make_continuous(own.parameters);
  return own;
}

/// Fills the arrays of a block with scaled points, and sets where the search for the nearest places starts: at `from`,
/// or if that is null where the points know it.
void CurveObjective::scale_block(const Constants& constants, const ConstantsScale& of_all, const MeasuredPoints& points,
                                 std::size_t begin, Search search, const NearestPlaces* from, Workspace& workspace,
                                 CurveDistances& out) const {
  const std::size_t n = out.r.size();
  const ConstantsScale same = of_all;
  const auto array = [&](std::size_t which) { return workspace.array(which, n).data(); };
  double *const P = array(0), *const T = array(1), *const A = array(2), *const sigma_T = array(3),
                *const sigma_A = array(4);
  // Array by array, which compilers make vectors of.
  const auto begin_near = [&out, same](const double* __restrict near_T, const double* __restrict near_A) {
    double *const __restrict place_T = out.place_T.data(), *const __restrict place_A = out.place_A.data();
    for (std::size_t i = 0; i < out.r.size(); ++i) {
      const bool known = place_A[i] > 0;
      const double T = std::abs(same.shear(near_T[i])), A = same.true_area(near_A[i]);
      place_T[i] = known ? place_T[i] : T;
      place_A[i] = known ? place_A[i] : A;
    }
  };
  const auto has_near = [&](double first_A) {
    if (search == Search::rough || !(first_A > 0)) return false;
    if (!out.place_A.empty()) return true;
    out.place_T = workspace.array(11, n);
    out.place_A = workspace.array(12, n);
    std::fill(out.place_A.begin(), out.place_A.end(), 0.0);  // nothing to start from
    return true;
  };
  if (listed_ && &points == &points_ && !has_changes(constants) && !from) {
    const auto listed = [&](std::size_t which) { return &listed_[which * points.size + begin]; };
    const auto each = [n](double* __restrict to, const double* __restrict from, const auto& scaled) {
      for (std::size_t i = 0; i < n; ++i) to[i] = scaled(from[i]);
    };
    each(P, listed(0), [same](double x) { return same.load(x); });
    each(T, listed(1), [same](double x) { return same.shear(x); });
    each(A, listed(2), [same](double x) { return same.true_area(x); });
    each(sigma_T, listed(3), [same](double x) { return same.shear_force * x; });
    each(sigma_A, listed(4), [same](double x) { return same.area * x; });
    if (has_near(listed(6)[0])) begin_near(listed(5), listed(6));
    return;
  }
  const PointArrays arrays = workspace.points(n);
  points.fill(Indices(*this, begin, n).list, arrays);
  for (std::size_t i = 0; from && i < n; ++i) {
    arrays.near_T[i] = from->T[index_of(begin + i)];
    arrays.near_A[i] = from->A[index_of(begin + i)];
  }
  const bool varies = varies_ || has_changes(constants), near = has_near(arrays.near_A[0]);
  if (varies) {
    for (std::size_t i = 0; i < n; ++i) {
      const ConstantsScale scale(constants, points.at(index_of(begin + i)).place);
      if (near && !(out.place_A[i] > 0)) {
        out.place_T[i] = std::abs(scale.shear(arrays.near_T[i]));
        out.place_A[i] = scale.true_area(arrays.near_A[i]);
      }
      P[i] = scale.load(P[i]);
      T[i] = scale.shear(T[i]);
      A[i] = scale.true_area(A[i]);
      sigma_T[i] *= scale.shear_force;
      sigma_A[i] *= scale.area;
    }
    return;
  }
  if (near) begin_near(arrays.near_T.data(), arrays.near_A.data());
  for (std::size_t i = 0; i < n; ++i) P[i] = same.load(P[i]);
  for (std::size_t i = 0; i < n; ++i) T[i] = same.shear(T[i]);
  for (std::size_t i = 0; i < n; ++i) A[i] = same.true_area(A[i]);
  for (std::size_t i = 0; i < n; ++i) sigma_T[i] *= same.shear_force;
  for (std::size_t i = 0; i < n; ++i) sigma_A[i] *= same.area;
}

bool CurveObjective::one_block(const Candidate& at, const MeasuredPoints& points, std::size_t begin, std::size_t end,
                               const Range& range, Search search, Workspace& workspace, const Wanted& wanted) const {
  const std::size_t n = end - begin, width = choice_.size(), p = model_parameters(),
                    first_row = begin - range.first.value_or(0);  // where rows follow one another
  const auto array = [&](std::size_t which) { return workspace.array(which, n); };
  CurveDistances out{
      array(7), array(8), array(9), array(10), {workspace.values.get() + Workspace::kArrays * workspace.size, n * p}};
  if (!wanted.places.empty()) {
    out.place_T = wanted.places.subspan(first_row, n);
    out.place_A = wanted.places.subspan(wanted.places.size() / 2 + first_row, n);
  } else if (wanted.nearest) {
    out.place_T = array(11);
    out.place_A = array(12);
    std::fill(out.place_A.begin(), out.place_A.end(), 0.0);  // nothing to start from
  }
  const ConstantsScale of_all(at.constants);
  scale_block(at.constants, of_all, points, begin, search, wanted.from_nearest ? wanted.nearest : nullptr, workspace,
              out);
  OfAxes axes;
  PlanePoints plane{array(0), array(1), array(2), array(3), array(4)};
  if (!wanted.axes.empty() && points.axes) axes.add(*this, points, begin, n, p, plane, out);
  OfApproach approach;
  const bool held = model().holds_approach();
  if (held) approach.add(*this, at.constants, points, begin, n, axes, plane, out);
  const auto P = array(0), T = array(1), A = array(2), sigma_T = array(3), sigma_A = array(4);
  const bool in_order = range.first || order_.empty(), in_place = in_order && !wanted.halves,
             all_in_place = in_place && !wanted.jacobian.empty() && width == p && choice_.constants().empty();
  if (in_place) out.r = wanted.residuals.subspan(first_row, n);
  if (all_in_place) out.parameters = wanted.jacobian.subspan(first_row * p, n * p);
  if (!model().curve_distances(at.parameters, plane, search, !wanted.jacobian.empty() || wanted.nearest, out))
    return false;
  const auto to = [&](std::size_t i) { return in_order ? first_row + i : index_of(begin + i); };
  for (std::size_t i = 0; !in_place && i < n; ++i) {
    double& residual = wanted.residuals[to(i)];
    residual = wanted.halves ? residual + out.r[i] / 2 : out.r[i];
  }
  if (!wanted.jacobian.empty() && !all_in_place) {
    std::size_t column = 0;
    for (const std::size_t parameter : choice_.of_model()) {
      for (std::size_t i = 0; i < n; ++i) wanted.jacobian[to(i) * width + column] = out.parameters[i * p + parameter];
      ++column;
    }
  }
  for (std::size_t i = 0; i < axes.r.size(); ++i) {
    const std::size_t row = row_of_axes(index_of(begin + i));
    if (row == 0) continue;
    wanted.axes[row - points_.size] = axes.r[i];
    for (std::size_t k = 0; !wanted.jacobian.empty() && k < choice_.of_model().size(); ++k)
      wanted.jacobian[row * width + k] = axes.parameters[i * p + choice_.of_model()[k]];
  }
  if (choice_.constants().empty() && !wanted.nearest) return true;
  const bool varies = varies_ || has_changes(at.constants), places_act = varies || choice_.has_changes();
  ConstantsScale scale = of_all;
  PointPlace place{};
  const auto slopes_of = [&](std::size_t i) {
    const auto of_error = [&](double slope, double sigma) { return -out.r[i] * slope * slope * sigma * sigma; };
    return ResidualSlopes{out.dP[i], out.dT[i], out.dA[i], of_error(out.dT[i], sigma_T[i]),
                          of_error(out.dA[i], sigma_A[i])};
  };
  const bool by_column = !places_act && !wanted.jacobian.empty() && axes.r.empty() && !held;
  if (by_column) {
    const auto by_force = array(5), by_area = array(6);
    for (std::size_t i = 0; i < n; ++i) {
      const ScaledSlopes slopes = slopes_of(i).at(P[i], T[i], A[i]);
      by_force[i] = slopes.by_force;
      by_area[i] = slopes.by_area;
    }
    for (std::size_t k = 0; k < choice_.constants().size(); ++k)
      with_constant(choice_.constants()[k], [&](auto constant) {
        double* const column = wanted.jacobian.data() + choice_.of_model().size() + k;
        for (std::size_t i = 0; i < n; ++i)
          column[to(i) * width] =
              ScaledSlopes{out.dP[i], out.dT[i], out.dA[i], by_force[i], by_area[i]}.in(constant, scale, place);
      });
  }
  if (by_column && !wanted.nearest) return true;
  for (std::size_t i = 0; i < n; ++i) {
    if (places_act) place = points.at(index_of(begin + i)).place;  // drifts act at T = 0, too
    if (varies) scale = ConstantsScale(at.constants, place);
    if (wanted.nearest) {
      const double load_T = std::copysign(out.dT[i], out.dT[i] * T[i]) * sigma_T[i];  // equilibrium knows |T| alone
      const double load_A = out.dA[i] * sigma_A[i], size = std::sqrt(load_T * load_T + load_A * load_A);  // about 1
      wanted.nearest->T[to(i)] = scale.measured_shear(out.place_T[i]);
      wanted.nearest->A[to(i)] = scale.measured_area(out.place_A[i]);
      wanted.nearest->load_T[to(i)] = load_T / size;
      wanted.nearest->load_A[to(i)] = load_A / size;
    }
    if (by_column || wanted.jacobian.empty()) continue;
    const auto fill = [&](std::size_t to_row, const auto& slopes) {
      double* const row = &wanted.jacobian[to_row * width] + choice_.of_model().size();
      for (std::size_t k = 0; k < choice_.constants().size(); ++k)
        row[k] = slopes.in(choice_.constants()[k], scale, place);
    };
    const std::size_t beside = axes.r.empty() ? 0 : row_of_axes(index_of(begin + i));  // 0: none
    const ResidualSlopes of_point =
        axes.r.empty() ? slopes_of(i)
                       : ResidualSlopes{out.dP[i], out.dT[i], out.dA[i], axes.of_sigma_T[i], axes.of_sigma_A[i]};
    const auto of_axes = [&] {
      return ResidualSlopes{axes.dP[i], axes.dT[i], axes.dA[i], axes.own_sigma_T[i], axes.own_sigma_A[i]};
    };
    if (!held) {
      fill(to(i), of_point.at(P[i], T[i], A[i]));
      if (beside > 0) fill(beside, of_axes().at(P[i], T[i], A[i]));
      continue;
    }
    const double m = approach.compliance[i];
    if (axes.r.empty()) {
      fill(to(i), of_point.held(P[i], T[i], A[i], out.dm[i] * m));
      continue;
    }
    const double load = std::isfinite(axes.q[i]) ? axes.q[i] : 0;
    fill(to(i), of_point.held(P[i], T[i], A[i], out.dm[i] * m, axes.of_q[i], load, axes.of_sigma_q[i]));
    if (beside > 0)
      fill(beside, of_axes().held(P[i], T[i], A[i], axes.dm[i] * m, axes.own_q[i], load, axes.own_sigma_q[i]));
  }
  return true;
}

}  // namespace mixity
