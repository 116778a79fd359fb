#include "fitting/curve_objective.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

#include "base/threads.h"

namespace mixity {
namespace {

constexpr std::size_t kBlock = 512;             // points whose arrays stay in the processor's cache
constexpr std::size_t kPointsOfAThread = 1024;  // fewer take less time than starting it

}  // namespace

/// Arrays of a block: the points as scaled, and their distances with derivatives.
struct CurveObjective::Workspace {
  Workspace(std::size_t n, std::size_t parameters) : values(new double[n * (9 + parameters)]), size(n) {}
  std::span<double> array(std::size_t which, std::size_t n) { return {values.get() + which * size, n}; }
  std::unique_ptr<double[]> values;
  std::size_t size;
};

CurveObjective::CurveObjective(const std::vector<MeasuredPoint>& points, FreeChoice choice,
                               std::vector<double> expected, std::shared_ptr<const Whitening> whitening,
                               std::vector<ParameterValues> shifts)
    : ModelProblem(std::move(choice)),
      order_(points.size()),
      expected_(std::move(expected)),
      whitening_(std::move(whitening)),
      shifts_(std::move(shifts)) {
  // The normal of the curve is taken at the place next to a reading, which noise along the curve has moved. As far as
  // the points before predict that noise, the prediction of the residual is off by -2 times the expected distance.
  if (whitening_ && !whitening_->predicted_across().empty())
    for (std::size_t i = 0; i < expected_.size(); ++i) expected_[i] *= 1 - 2 * whitening_->predicted_across()[i];
  // by load, so that the points of one curve are processed together
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  const auto run_of = [&](std::size_t i) { return shifts_.empty() ? 0 : points[i].run; };
  std::stable_sort(order_.begin(), order_.end(), [&](std::size_t i, std::size_t j) {
    return std::pair(run_of(i), points[i].P) < std::pair(run_of(j), points[j].P);
  });
  for (std::size_t i = 0; i < points.size(); ++i)
    if (i == 0 || i - blocks_.back() == kBlock || run_of(order_[i]) != run_of(order_[i - 1])) blocks_.push_back(i);
  blocks_.push_back(points.size());
  points_.reserve(points.size());
  for (const std::size_t i : order_) points_.push_back(points[i]);
  for (const MeasuredPoint& point : points) {
    varies_ |= point.place.has_own_constants();
    targets_.push_back(point.A / point.sigma_A);
    weights_.push_back(1 / point.sigma_A);
  }
  if (points.size() < 2 * kSample) return;
  std::vector<MeasuredPoint> sample;
  for (std::size_t i = 0; i < kSample; ++i) sample.push_back(points_[i * points_.size() / kSample]);
  sample_ = std::make_unique<CurveObjective>(sample, choice_, std::vector<double>(), nullptr, shifts_);
}

double CurveObjective::data_norm() const {
  double square = std::pow(ModelProblem::data_norm(), 2);
  for (const MeasuredPoint& point : points_) square += std::pow(point.T / point.sigma_T, 2);
  return std::sqrt(square);
}

bool CurveObjective::evaluate(std::span<const double> x, std::span<double> residuals,
                              std::span<double> jacobian) const {
  return residuals_of(x, residuals, jacobian, {});
}

bool CurveObjective::evaluate_again(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian,
                                    std::vector<double>& memory) const {
  memory.resize(2 * points_.size(), 0.0);
  return residuals_of(x, residuals, jacobian, memory);
}

bool CurveObjective::evaluate_roughly(std::span<const double> x, std::span<double> residuals) const {
  if (!sample_) return all_blocks(x, Search::rough, residuals, {}, {});
  std::fill(residuals.begin(), residuals.end(), 0.0);
  return sample_->evaluate_roughly(x, residuals.first(sample_->residual_count()));
}

bool CurveObjective::residuals_of(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian,
                                  std::span<double> places) const {
  if (!all_blocks(x, Search::global, residuals, jacobian, places)) return false;
  for (std::size_t i = 0; i < expected_.size(); ++i) residuals[i] -= expected_[i];
  if (!whitening_) return true;
  whitening_->apply(residuals);
  const std::size_t width = choice_.size();
  if (!jacobian.empty())
    for (std::size_t k = 0; k < width; ++k) whitening_->apply(jacobian.subspan(k), width);
  return true;
}

std::optional<NearestPlaces> CurveObjective::nearest(std::span<const double> x) const {
  const std::size_t n = points_.size();
  const std::vector<double> of_n(n);
  NearestPlaces found{of_n, of_n, of_n, of_n, of_n};
  std::vector<double> places(2 * n, 0.0), loads(2 * n);
  if (!all_blocks(x, Search::global, found.residuals, {}, places, loads)) return std::nullopt;
  const Constants constants = candidate(x).constants;
  const bool varies = varies_ || has_changes(constants);
  ConstantsScale scale(constants);
  for (std::size_t i = 0; i < n; ++i) {
    if (varies) scale = ConstantsScale(constants, points_[i].place);
    found.T[order_[i]] = places[i] / scale.force - scale.shear_offset;
    found.A[order_[i]] = scale.measured_area(places[n + i]);
    const double size = std::hypot(loads[i], loads[n + i]);
    found.load_T[order_[i]] = loads[i] / size;
    found.load_A[order_[i]] = loads[n + i] / size;
  }
  return found;
}

std::optional<std::vector<double>> CurveObjective::expected(std::span<const double> x,
                                                            const NearestPlaces& places) const {
  const std::size_t n = points_.size();
  std::vector<double> mean(n, 0.0), distances(n);
  std::vector<MeasuredPoint> beside(n);
  const double root = 1.0;
  for (const double side : {-root, root}) {
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = order_[k];
      MeasuredPoint& point = beside[i] = points_[k];
      point.T = places.T[i] + side * places.load_A[i] * point.sigma_T;
      point.A = std::max(places.A[i] - side * places.load_T[i] * point.sigma_A, 0.5 * places.A[i]);
    }
    if (!CurveObjective(beside, choice_, {}, {}, shifts_).evaluate(x, distances, {})) return std::nullopt;
    for (std::size_t i = 0; i < n; ++i) mean[i] += distances[i] / 2;
  }
  return mean;
}

bool CurveObjective::all_blocks(std::span<const double> x, Search search, std::span<double> residuals,
                                std::span<double> jacobian, std::span<double> places, std::span<double> loads) const {
  Candidate at = candidate(x);
  model().make_continuous(at.parameters);
  const std::size_t n = points_.size(), blocks = blocks_.size() - 1;
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> defined = true;
  const auto work = [&] {
    Workspace workspace(std::min(n, kBlock), model_parameters());
    for (std::size_t block; defined && (block = next++) < blocks;) {
      const std::size_t begin = blocks_[block], end = blocks_[block + 1];
      if (!one_block(shifts_.empty() ? at : of_run(at, points_[begin].run), begin, end, search, workspace, residuals,
                     jacobian, places, loads))
        defined = false;
    }
  };
  run_on_threads(std::clamp<std::size_t>(n / kPointsOfAThread, 1, processors()), work);
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

bool CurveObjective::one_block(const Candidate& at, std::size_t begin, std::size_t end, Search search,
                               Workspace& workspace, std::span<double> residuals, std::span<double> jacobian,
                               std::span<double> places, std::span<double> loads) const {
  const std::size_t n = end - begin, width = choice_.size(), p = model_parameters();
  const bool varies = varies_ || has_changes(at.constants);
  ConstantsScale scale(at.constants);
  const auto array = [&](std::size_t which) { return workspace.array(which, n); };
  const auto P = array(0), T = array(1), A = array(2), sigma_T = array(3), sigma_A = array(4);
  for (std::size_t i = 0; i < n; ++i) {
    const MeasuredPoint& point = points_[begin + i];
    if (varies) scale = ConstantsScale(at.constants, point.place);
    P[i] = scale.load(point.P);
    T[i] = scale.shear(point.T);
    A[i] = scale.true_area(point.A);
    sigma_T[i] = scale.force * point.sigma_T;
    sigma_A[i] = scale.area * point.sigma_A;
    if (!(A[i] > 0)) return false;
  }
  CurveDistances out{array(5), array(6), array(7), array(8), {workspace.values.get() + 9 * workspace.size, n * p}};
  if (!places.empty()) {
    out.place_T = places.subspan(begin, n);
    out.place_A = places.subspan(points_.size() + begin, n);
  }
  if (!model().curve_distances(at.parameters, {P, T, A, sigma_T, sigma_A}, search, !jacobian.empty() || !loads.empty(),
                               out))
    return false;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t to = order_[begin + i];
    residuals[to] = out.r[i];
    if (!loads.empty()) {
      loads[begin + i] = std::copysign(out.dT[i], out.dT[i] * T[i]) * sigma_T[i];  // equilibrium knows |T| alone
      loads[points_.size() + begin + i] = out.dA[i] * sigma_A[i];
    }
    if (jacobian.empty()) continue;
    const PointPlace& place = points_[begin + i].place;
    if (varies) scale = ConstantsScale(at.constants, place);
    const auto of_error = [&](double slope, double sigma) { return -out.r[i] * slope * slope * sigma * sigma; };
    const ResidualSlopes slopes{out.dP[i], out.dT[i], out.dA[i], of_error(out.dT[i], sigma_T[i]),
                                of_error(out.dA[i], sigma_A[i])};
    choice_.fill_row(jacobian.subspan(to * width, width), out.parameters.data() + i * p, slopes,
                     {P[i], T[i], A[i], 0, 0, place}, scale);
  }
  return true;
}

}  // namespace mixity
