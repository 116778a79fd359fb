#include "mechanics/equilibrium.h"

#include <algorithm>
#include <tuple>

#include "mechanics/fold_search.h"
#include "mechanics/roots.h"

namespace mixity {

template <class Law>
std::string_view contact_obstacle(const Law& law, const Parameters<Law>& p, double P) {
  if (!in_bounds(law, p)) return "a model parameter lies outside its range";
  if (!(std::abs(P) <= kLargestLoad)) return "the load is not a number below 1e150";
  return law.equilibrium_domain(p);
}

/// Largest root of R in [low, high], where R(low) <= 0 <= R(high): steps to the upper root of the quadratic that
/// R's value, slope and curvature define (Euler's method). It converges cubically, is exact in one step for law c, and,
/// unlike Newton's method, stays fast at the double root of a fold. Bisection is the safeguard.
template <class Law>
Equilibrium LoadedContact<Law>::solve(double T, double low, double high, double start) const {
  constexpr double eps = std::numeric_limits<double>::epsilon();
  double y = start;
  int iterations = 0;
  for (; iterations < 200 && high - low > eps * high; ++iterations) {
    const ShearTerm<double> R = circle_residual(law_, p_, P_, y, T);
    // The rounding error of R in the form that circle_residual uses at this y.
    const double size =
        y > 4 ? S0_ * S0_ + 2 * std::abs(y - 3 * pi<double>()) * y : 6 * pi<double>() * (y + std::abs(P_));
    const double rounding = 0.5 * eps * size;
    if (std::abs(R.value) <= rounding) break;
    (R.value > 0 ? high : low) = y;
    // Within rounding of a fold the discriminant may come out negative: the vertex is then the root.
    const double root = std::sqrt(std::max(R.d1 * R.d1 - 2 * R.value * R.d2, 0.0));
    const double step = R.d1 > 0 ? -2 * R.value / (R.d1 + root) : (root - R.d1) / R.d2;
    const double next = y + step;
    if (!(next >= low && next <= high)) {
      y = low > 0 && high > 16 * low ? std::sqrt(low * high) : 0.5 * (low + high);
      continue;
    }
    // The error after the step is a third of a cubic term, |R''' step^3/6 R'|, with R''' about R''/y; R'' by its terms,
    // 2 and tau^2_yy, whose sum may pass through 0 where R''' does not.
    const double bend = 2 + std::abs(R.d2 - 2);
    const bool done = std::abs(step) <= eps * y || bend * std::abs(step * step * step) <= 0.1 * eps * R.d1 * y * y;
    y = next;
    if (done) {
      ++iterations;
      break;
    }
  }
  return {EquilibriumStatus::ok, y, iterations};
}

/// Searches along the coordinate of the curve, in which T rises.
template <class Law>
Equilibrium LoadedContact<Law>::solve_non_monotone(double T, const StableBranch& branch) const {
  const CurvePiece& piece = curve_->pieces().front();
  const auto excess = [&](double v) { return std::log(curve_->tangential_load(curve_->position(piece, v)) / T); };
  if (branch.T_top == 0 && !(excess(branch.v_top) < 0)) {  // T is before the first coordinate
    const NonMonotoneCurve<Law> by_ray(law_, p_, P_);
    double y = y_jkr_;
    for (int i = 0; i < 3; ++i) y = by_ray.upper_edge_load(T / y).value_or(y_jkr_);
    return {EquilibriumStatus::ok, y};
  }
  if (!(excess(branch.v_top) < 0)) return {EquilibriumStatus::ok, branch.y_top};
  if (!(excess(branch.v_bottom) > 0)) {
    // beyond the largest T of the curve there is no equilibrium, but T at a fold has rounding errors
    const bool rounding = std::abs(excess(branch.v_bottom)) < 1e-12;
    return {branch.ends_in_fold || rounding ? EquilibriumStatus::ok : EquilibriumStatus::no_equilibrium,
            branch.y_bottom};
  }
  return {EquilibriumStatus::ok, curve_->position(piece, root_between(excess, branch.v_top, branch.v_bottom)).y};
}

template <class Law>
Equilibrium LoadedContact<Law>::follow(double T) const {
  if (simple_top_) {
    // tau^2 is at most small_shear T^2, which makes this start a lower bound, close to the root. R rises with y
    // above the centre, so R <= 0 there shows that the root above is the only one.
    const double centre = 3 * pi<double>(), room = S0_ * S0_ - law_.small_shear(p_) * T * T;
    const bool certain = room >= 0;
    if (certain || circle_residual(law_, p_, P_, centre, T).value <= 0)
      return solve(T, centre, y_jkr_, certain ? centre + std::sqrt(room) : 0.5 * (centre + y_jkr_));
  }
  first_branch();
  if (T > branches_.back().T_bottom && !all_branches_) find_branches(kAll);
  for (const StableBranch& branch : branches_) {
    if (T > branch.T_bottom) continue;
    if constexpr (kMayBeNonMonotone<Law>) {
      if (non_monotone_) return solve_non_monotone(T, branch);
    }
    if (T < branch.T_top) return solve(branch.T_top, branch.y_bottom, branch.y_top, branch.y_top);
    return solve(T, branch.y_bottom, branch.y_top, std::max(branch.y_bottom, 0.5 * branch.y_top));
  }
  return {EquilibriumStatus::no_equilibrium};
}

template <class Law>
const StableBranch& LoadedContact<Law>::first_branch() const {
  if (branches_.empty()) find_branches(1);  // finds at least one
  return branches_.front();                 // cppcheck-suppress containerOutOfBounds
}

template <class Law>
const std::vector<StableBranch>& LoadedContact<Law>::branches() const {
  if (!all_branches_) find_branches(kAll);
  return branches_;
}

template <class Law>
void LoadedContact<Law>::find_branches(std::size_t folds) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  branches_.clear();
  all_branches_ = true;
  const EquilibriumCurve<Law> curve(law_, p_, P_);
  if (non_monotone_) curve_.emplace(curve);
  if (curve.uncoupled()) {
    branches_ = {{y_jkr_, 0, y_jkr_, kInfinity, false}};
    return;
  }
  StableBranch branch{y_jkr_, 0, 0, 0, false, kFirstCoordinate, kLastCoordinate<Law>};
  bool open = true;
  const std::vector<FoldPlace> places = locate_folds(curve, {Control::Kind::load}, folds);
  for (const FoldPlace& fold : places) {
    const double y = fold.position.y, T = fold.T;
    if (fold.maximum)
      branches_.push_back({branch.y_top, branch.T_top, y, T, true, branch.v_top, fold.coordinate});
    else
      branch = {y, T, 0, 0, false, fold.coordinate, kLastCoordinate<Law>};
    open = !fold.maximum;
  }
  all_branches_ = places.size() < folds;
  if (!open) return;
  // Only the first piece can end in a stable branch: at Hertz, where tau^2 = 6 pi P, or at the asymptote. If it has
  // neither end, its fold lies beyond kLargestLoad.
  const CurvePiece& piece = curve.pieces().front();
  double end = kInfinity;
  if (piece.end == CurveEnd::hertz)
    end = curve.non_monotone() ? std::sqrt(6 * pi<double>() * P_ / law_.shear_term(p_, 0.0, 1.0).value)
                               : tangential_load(law_, p_, 0.0, std::sqrt(6 * pi<double>() * P_));
  branches_.push_back({branch.y_top, branch.T_top, piece.y_end, end, false, branch.v_top, kLastCoordinate<Law>});
}

namespace {
[[gnu::used]] const auto equilibrium_instances = each_law([]<class Law>() {
  using Contact = LoadedContact<Law>;
  return std::tuple(&contact_obstacle<Law>, &Contact::follow, &Contact::branches, &Contact::first_branch);
});
}  // namespace

}  // namespace mixity
