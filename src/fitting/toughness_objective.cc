#include "fitting/toughness_objective.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/stop.h"
#include "base/threads.h"

namespace mixity {
namespace {

constexpr std::size_t kChunk = 256;  // points whose arrays stay in the processor's cache
constexpr std::size_t kBetweenChecks = 16 * kChunk;

/// The cost in ln f on packed arrays, for a one-parameter model: a vectorised sweep gives value and derivatives.
class PackedToughness final : public Cost {
 public:
  /// `targets`, `weights`: as in ToughnessObjective. All arguments must outlive this object.
  PackedToughness(const ContactModel& model, const PackedMixities& points, const std::vector<double>& targets,
                  const std::vector<double>& weights)
      : model_(model), points_(points), targets_(targets), weights_(weights) {}

  bool exact_curvature() const override { return true; }
  void at(std::span<const double> x, std::span<const double> weights, CostValue& cost) override {
    std::vector<Sums> pieces((points_.size() + kPiece - 1) / kPiece);
    parallel_for(pieces.size(), [&](std::size_t piece) {
      const std::size_t begin = piece * kPiece;
      pieces[piece] = sums(x[0], begin, std::min(points_.size(), begin + kPiece), weights);
    });
    Sums all;
    for (const Sums& piece : pieces) all.add(piece);
    cost.value = all.value;
    cost.gradient.setConstant(1, all.slope);
    cost.hessian.setConstant(1, 1, all.square + all.bend);
    cost.slope_size.setConstant(1, std::sqrt(all.square));
    cost.finite = std::isfinite(cost.value) && std::isfinite(cost.gradient[0]) && std::isfinite(cost.hessian(0, 0));
  }

 private:
  static constexpr std::size_t kPackedChunk = 512;           // a multiple of four
  static constexpr std::size_t kPiece = 128 * kPackedChunk;  // for one thread

  struct Sums {
    double value = 0, slope = 0, square = 0, bend = 0;
    void add(const Sums& other) {
      value += other.value;
      slope += other.slope;
      square += other.square;
      bend += other.bend;
    }
  };

  Sums sums(double x, std::size_t first, std::size_t last, std::span<const double> weights) const {
    // Four sums of each kind, which compilers keep in vector registers. The order, and so the result, is fixed.
    double value[4]{}, slope[4]{}, square[4]{}, bend[4]{};
    std::array<double, kPackedChunk> f, f1, f2;  // ln f and its derivatives
    for (std::size_t begin = first; begin < last; begin += kPackedChunk) {
      const std::size_t n = std::min(kPackedChunk, last - begin);
      model_.packed_log_toughness(x, points_, begin, n, f.data(), f1.data(), f2.data());
      const double *const own = weights_.data() + begin, *const targets = targets_.data() + begin;
      const auto add = [&](std::size_t j, std::size_t k, double w) {
        const double r = own[j] * f[j] - targets[j], d = own[j] * f1[j];
        value[k] += w * r * r;
        slope[k] += w * r * d;
        square[k] += w * d * d;
        bend[k] += w * r * own[j] * f2[j];
      };
      const auto add_all = [&](const auto& weight) {
        const std::size_t whole = n / 4 * 4;
        for (std::size_t j = 0; j < whole; j += 4)
          for (std::size_t k = 0; k < 4; ++k) add(j + k, k, weight(j + k));
        for (std::size_t j = whole; j < n; ++j) add(j, j % 4, weight(j));
      };
      if (weights.empty())
        add_all([](std::size_t) { return 1.0; });
      else
        add_all([given = weights.data() + begin](std::size_t j) { return given[j]; });
    }
    const auto sum = [](const double* s) { return (s[0] + s[1]) + (s[2] + s[3]); };
    return {sum(value), sum(slope), sum(square), sum(bend)};
  }

  const ContactModel& model_;
  const PackedMixities& points_;
  const std::vector<double>&targets_, &weights_;
};

}  // namespace

ToughnessObjective::ToughnessObjective(const std::vector<ToughnessPoint>& points, Scale scale, FreeChoice choice,
                                       std::vector<double> weights)
    : WeightedProblem(std::move(choice)), scale_(scale) {
  weights_ = std::move(weights);
  weights_.resize(points.size(), 1.0);
  targets_.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    targets_.push_back(weights_[i] * (scale_ == Scale::log ? std::log(points[i].ratio) : points[i].ratio));
  const bool packs = scale_ == Scale::log && model().has_packed_form();
  for (std::vector<double>* const list : {&packed_.first, &packed_.second}) list->reserve(packs ? points.size() : 0);
  mixities_.reserve(packs ? kChunk : points.size());
  for (const ToughnessPoint& point : points) {
    mixities_.push_back(point.mixity);
    if (!packs || (mixities_.size() < kChunk && &point != &points.back())) continue;
    model().pack(mixities_, packed_);  // in pieces, as a second list of millions of points would count
    mixities_.clear();
  }
}

double ToughnessObjective::data_norm() const {
  double square = std::pow(WeightedProblem::data_norm(), 2);
  if (scale_ == Scale::log)
    for (const double weight : weights_) square += weight * weight;
  return std::sqrt(square);
}

double ToughnessObjective::residual(std::size_t i, double log_f) const {
  return weights_[i] * (scale_ == Scale::log ? log_f : std::exp(log_f)) - targets_[i];
}

bool ToughnessObjective::evaluate(std::span<const double> x, std::span<double> residuals,
                                  std::span<double> jacobian) const {
  const Candidate at = candidate(x);
  const std::vector<std::size_t>& free = choice_.of_model();
  const std::size_t width = choice_.size(), p = model_parameters();
  const double toughness = at.constants[kToughness];  // as ln f: ln Gc/GIc is lower by this
  std::array<double, kChunk> value, curvature;
  std::array<double, kChunk * ParameterValues::kMost> gradient;
  bool finite = true;
  for (std::size_t begin = 0; begin < targets_.size(); begin += kChunk) {
    if (begin % kBetweenChecks == 0) may_go_on();
    const std::size_t n = std::min(kChunk, targets_.size() - begin);
    if (is_packed())
      model().packed_log_toughness(at.parameters[0], packed_, begin, n, value.data(), gradient.data(),
                                   curvature.data());
    else
      model().log_toughness(at.parameters, std::span(mixities_).subspan(begin, n), value,
                            std::span(gradient).first(jacobian.empty() ? 0 : n * p));
    for (std::size_t j = 0; j < n; ++j) {
      const std::size_t i = begin + j;
      residuals[i] = residual(i, value[j] + toughness);
      finite &= std::isfinite(residuals[i]);
      if (jacobian.empty()) continue;
      const double f = scale_ == Scale::log ? 1 : std::exp(value[j] + toughness);  // df = f d(ln f)
      for (std::size_t k = 0; k < free.size(); ++k) {
        const double slope = weights_[i] * f * gradient[j * p + free[k]];
        jacobian[i * width + k] = slope;
        finite &= std::isfinite(slope);
      }
      if (width > free.size()) jacobian[i * width + free.size()] = weights_[i] * f;
    }
  }
  return finite;
}

bool ToughnessObjective::evaluate_roughly(std::span<const double> x, std::span<double> residuals) const {
  if (is_packed() || mixities_.size() < 2 * kSample) return evaluate(x, residuals, {});
  const Candidate at = candidate(x);
  std::fill(residuals.begin(), residuals.end(), 0.0);
  double value = 0;
  for (std::size_t i = 0; i < mixities_.size(); i += std::max<std::size_t>(mixities_.size() / kSample, 1)) {
    model().log_toughness(at.parameters, {&mixities_[i], 1}, {&value, 1}, {});
    residuals[i] = residual(i, value + at.constants[kToughness]);
    if (!std::isfinite(residuals[i])) return false;
  }
  return true;
}

std::unique_ptr<Cost> ToughnessObjective::cost() const {
  if (is_packed() && choice_.size() == 1 && choice_.of_model().size() == 1)
    return std::make_unique<PackedToughness>(model(), packed_, targets_, weights_);
  return Problem::cost();
}

ToughnessOfLoads::ToughnessOfLoads(MeasuredPoints points, FreeChoice choice, std::vector<double> weights)
    : WeightedProblem(std::move(choice)), points_(std::move(points)) {
  weights_ = std::move(weights);
  weights_.resize(points_.size, 1.0);
  for (std::size_t i = 0; i < points_.size; ++i) {
    const MeasuredPoint p = points_.at(i);
    const ConstantsScale scale(choice_.fixed_constants(), p.place);
    const double A = scale.true_area(p.A), P = at_scale(model(), scale).load(scale.load(p.P), radius_from_area(A));
    targets_.push_back(weights_[i] * std::log(toughness_of_area(P, scale.shear(p.T), A)->ratio));
  }
}

double ToughnessOfLoads::data_norm() const {
  return std::hypot(WeightedProblem::data_norm(), std::sqrt(static_cast<double>(points_.size)));
}

bool ToughnessOfLoads::evaluate(std::span<const double> x, std::span<double> residuals,
                                std::span<double> jacobian) const {
  const Candidate at = candidate(x);
  const bool varies = has_changes(at.constants);
  ConstantsScale scale(at.constants);
  const std::size_t p = model_parameters(), width = choice_.size();
  std::array<double, kChunk> P, T, A, by_P, by_T, by_A;
  std::array<double, kChunk * ParameterValues::kMost> by_parameter;
  bool finite = true;
  for (std::size_t begin = 0; begin < points_.size; begin += kChunk) {
    if (begin % kBetweenChecks == 0) may_go_on();
    const std::size_t n = std::min(kChunk, points_.size - begin);
    for (std::size_t j = 0; j < n; ++j) {
      const MeasuredPoint point = points_.at(begin + j);
      if (varies) scale = ConstantsScale(at.constants, point.place);
      P[j] = scale.load(point.P);
      T[j] = scale.shear(point.T);
      A[j] = scale.true_area(point.A);
    }
    if (varies && model().has_compliance()) {  // each point has a compliance of its own
      for (std::size_t j = 0; j < n; ++j) {
        const auto one = [&](auto& list) { return std::span(list).subspan(j, 1); };
        const ConstantsScale own(at.constants, points_.at(begin + j).place);
        if (!at_scale(model(), own)
                 .toughness_residuals(at.parameters, one(P), one(T), one(A),
                                      {residuals.subspan(begin + j, 1), one(by_P), one(by_T), one(by_A),
                                       std::span(by_parameter).subspan(j * p, p)}))
          return false;
      }
    } else if (!at_scale(model(), scale)
                    .toughness_residuals(at.parameters, std::span(P).first(n), std::span(T).first(n),
                                         std::span(A).first(n),
                                         {residuals.subspan(begin, n), by_P, by_T, by_A, by_parameter}))
      return false;
    for (std::size_t j = 0; j < n; ++j) {
      const std::size_t i = begin + j;
      residuals[i] *= weights_[i];
      finite &= std::isfinite(residuals[i]);
      if (jacobian.empty()) continue;
      const PointPlace place = points_.at(i).place;
      if (varies) scale = ConstantsScale(at.constants, place);
      const std::span<double> row = jacobian.subspan(i * width, width);
      const ResidualSlopes slopes{by_P[j], by_T[j], by_A[j]};
      if (model().holds_approach()) {
        const HeldApproach held = at_scale(model(), scale).held_at(P[j]);
        const HeldApproach::EdgeLoad y = held.edge_load(radius_from_area(A[j]));
        const double by_compliance = by_P[j] * y.by_compliance / y.by_approach * held.compliance;
        choice_.fill_row(row, by_parameter.data() + j * p,
                         [&](Constant c) { return slopes.held(P[j], T[j], A[j], by_compliance).in(c, scale, place); });
      } else {
        choice_.fill_row(row, by_parameter.data() + j * p,
                         [&](Constant c) { return slopes.in(c, P[j], T[j], A[j], scale, place); });
      }
      for (double& slope : row) {
        slope *= weights_[i];
        finite &= std::isfinite(slope);
      }
    }
  }
  return finite;
}

}  // namespace mixity
