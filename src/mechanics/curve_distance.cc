#include "mechanics/vector_math.h"
// after the declarations of the vector forms
#include <optional>
#include <vector>

#include "mechanics/curve_distance.h"
#include "mechanics/curve_outline.h"
#include "mechanics/equilibrium.h"
#include "mechanics/nearest_proof.h"

namespace mixity {
namespace {

using namespace nearest_detail;

constexpr int kSteps = 8, kStepsOfSearch = 60;
constexpr std::size_t kApproaches = 4;

// The stages of the work on a block, each compiled once for two doubles at once and once for four.

template <Begin kBegin, class Law>
void start_by_two(const CurveFamily<Law>& family, Block& __restrict block) {
  start<kBegin>(family, block);
}
template <Begin kBegin, class Law>
[[gnu::flatten]] MIXITY_WIDE void start_by_four(const CurveFamily<Law>& family, Block& __restrict block) {
  start<kBegin>(family, block);
}

template <class Law>
void settle_by_two(const CurveFamily<Law>& family, int steps, Block& __restrict block) {
  settle(family, block, steps);
}
template <class Law>
[[gnu::flatten]] MIXITY_WIDE void settle_by_four(const CurveFamily<Law>& family, int steps, Block& __restrict block) {
  settle(family, block, steps);
}

template <bool kDerivatives, class Law>
void measure_by_two(const CurveFamily<Law>& family, const Block& __restrict block, Result<Law>& __restrict result) {
  measure<kDerivatives>(family, block, result);
}
template <bool kDerivatives, class Law>
[[gnu::flatten]] MIXITY_WIDE void measure_by_four(const CurveFamily<Law>& family, const Block& __restrict block,
                                                  Result<Law>& __restrict result) {
  measure<kDerivatives>(family, block, result);
}

template <Begin kBegin, class Law>
void run_block(const CurveFamily<Law>& family, int steps, bool derivatives, Block& block, Result<Law>& result) {
  if constexpr (HasPackedForm<Law>) {  // the loops of other laws are not vectorised
    if (MIXITY_HAS_WIDE) {
      if constexpr (kBegin != Begin::anywhere) start_by_four<kBegin>(family, block);
      settle_by_four(family, steps, block);
      return derivatives ? measure_by_four<true>(family, block, result) : measure_by_four<false>(family, block, result);
    }
  }
  if constexpr (kBegin != Begin::anywhere) start_by_two<kBegin>(family, block);
  settle_by_two(family, steps, block);
  return derivatives ? measure_by_two<true>(family, block, result) : measure_by_two<false>(family, block, result);
}

bool valid(const PlanePoints& points, std::size_t i) {
  const auto positive = [](double x) { return x > 0 && std::isfinite(x); };
  return std::abs(points.P[i]) <= kLargestLoad && above_pull_off(points.P[i]) >= 0 &&
         std::abs(points.T[i]) <= kLargestLoad && positive(points.A[i]) && positive(points.sigma_T[i]) &&
         positive(points.sigma_A[i]);
}

void set_point(Block& block, std::size_t slot, const PlanePoints& points, std::size_t i) {
  block.P[slot] = points.P[i];
  block.T_point[slot] = std::abs(points.T[i]);
  block.A_point[slot] = points.A[i];
  block.sigma_T[slot] = points.sigma_T[i];
  block.sigma_A[slot] = points.sigma_A[i];
  block.per_T[slot] = 1 / points.sigma_T[i];
  block.per_A[slot] = 1 / points.sigma_A[i];
}

/// The distance from a place that is an end or a corner of the curve, whose A depends on the load alone with dA/dP =
/// A_P, and whose T, unless it stays, keeps F = 0 there. `out` holds -F's derivatives over |grad F| at first.
template <class Law>
void measure_from_end(const Block& block, std::size_t i, double A_P, bool T_stays, Result<Law>& out) {
  const double r = out.r[i];
  if (r == 0) return;
  const double e_T = (block.T[i] - block.T_point[i]) / block.sigma_T[i] / (r * block.sigma_T[i]);
  const double e_A = (block.A[i] - block.A_point[i]) / block.sigma_A[i] / (r * block.sigma_A[i]);
  const double per_T = T_stays ? 0 : -e_T / out.dT[i];
  out.dP[i] = per_T * (out.dA[i] * A_P + out.dP[i]) + e_A * A_P;
  for (auto& slope : out.parameters) slope[i] *= per_T;
  out.dT[i] = -e_T;
  out.dA[i] = -e_A;
}

/// A place on a curve.
struct Place {
  double T, A, distance;
};

double distance_to(const Block& b, std::size_t i, double T, double A) {
  return std::hypot((T - b.T_point[i]) / b.sigma_T[i], (A - b.A_point[i]) / b.sigma_A[i]);
}

template <class Law>
class Distances {
 public:
  Distances(const Law& law, const Parameters<Law>& p, const PlanePoints& points, Search search, bool derivatives,
            CurveDistances& out)
      : family_(law, p), points_(points), search_(search), derivatives_(derivatives), out_(out) {}

  bool find() {
    const std::size_t n = points_.P.size();
    for (std::size_t from = 0; from < n; from += kBlock) {
      const std::size_t count = std::min(kBlock, n - from);
      for (std::size_t slot = 0; slot < kBlock; ++slot) {
        const std::size_t i = from + std::min(slot, count - 1);
        if (!valid(points_, i)) return false;
        set_point(block_, slot, points_, i);
      }
      if (begin_nearby(from, count))
        run_block<Begin::nearby>(family_, kSteps, true, block_, result_);
      else
        run_block<Begin::at_the_point>(family_, search_ == Search::rough ? 0 : kSteps, derivatives_, block_, result_);
      for (std::size_t slot = 0; slot < count; ++slot) {
        const bool settled =
            block_.settled[slot] > 0 && result_.on_curve[slot] > 0 && std::isfinite(result_.distance[slot]);
        if (result_.sure[slot] > 0 || search_ == Search::rough || (settled && search_ == Search::local)) {
          if (!write(block_, result_, slot, from + slot)) return false;
        } else {
          const double distance = settled ? result_.distance[slot] : std::numeric_limits<double>::infinity();
          left_.push_back({from + slot, {block_.T[slot], block_.A[slot], distance}});
        }
      }
    }
    if (!left_.empty() && !family_.uncoupled) search_curves();
    for (std::size_t from = 0; from < left_.size(); from += kBlock)
      if (!finish(from, std::min(kBlock, left_.size() - from))) return false;
    return true;
  }

 private:
  /// A point that is left after the first pass, and the nearest place that Newton's method has reached for it.
  struct Left {
    std::size_t index;
    Place place;
  };

  /// Whether all points of a block have a place to start from.
  bool begin_nearby(std::size_t from, std::size_t count) {
    if (out_.place_A.empty() || family_.uncoupled) return false;
    for (std::size_t slot = 0; slot < kBlock; ++slot) {
      const std::size_t i = from + std::min(slot, count - 1);
      if (!(out_.place_A[i] > 0)) return false;
      block_.T[slot] = out_.place_T[i];
      block_.A[slot] = out_.place_A[i];
    }
    return true;
  }

  void load(std::size_t slot, std::size_t index) {
    set_point(block_, slot, points_, index);
    const CurveBounds ends = curve_bounds(family_, points_.P[index]);
    block_.T_end[slot] = ends.T;
    block_.A_end[slot] = ends.A;
    block_.settled[slot] = block_.at_end[slot] = 0;
  }

  /// Newton's method from a known place of the curve, where it has not ended yet, and for a global search from each
  /// stretch of the curve's outline that comes near the point, and from both ends of it, since two places may be near
  /// beside a fold. A stretch that promises much more than was found is searched by golden section.
  void search_curves() {
    std::optional<RayTable<Law>> table;
    if (search_ == Search::global) table.emplace(family_);
    std::vector<Approach> found;
    double P = std::numeric_limits<double>::quiet_NaN();
    for (Left& left : left_) {
      std::size_t used = 0;
      const auto begin_at = [&](PlanePlace place) {
        load(used, left.index);
        block_.T[used] = place.T;
        block_.A[used++] = place.A;
      };
      if (!std::isfinite(left.place.distance)) {
        load(0, left.index);
        const Place known = known_place(0);
        begin_at({known.T, known.A});
      }
      const std::size_t i = left.index;
      if (table) {
        if (points_.P[i] != P) {
          P = points_.P[i];
          const CurveBounds ends = curve_bounds(family_, P);
          table->set_load(P, {ends.T, ends.A});
        }
        approaches(table->places(), {std::abs(points_.T[i]), points_.A[i]}, 1 / points_.sigma_T[i],
                   1 / points_.sigma_A[i], kApproaches, found);
        for (const Approach& approach : found) {
          begin_at(approach.place);
          for (const int side : {-1, 2})
            begin_at(table->places()[static_cast<std::size_t>(std::clamp(approach.segment + side, 0, table->last()))]);
        }
      }
      if (used == 0) continue;
      for (std::size_t slot = used; slot < kBlock; ++slot) begin_at_same(slot, left.index);
      run_block<Begin::anywhere>(family_, kStepsOfSearch, false, block_, result_);
      const auto reached = [&](std::size_t slot) {
        return block_.settled[slot] > 0 && result_.on_curve[slot] > 0 ? result_.distance[slot] : kLargest;
      };
      for (std::size_t slot = 0; slot < used; ++slot)
        if (reached(slot) < left.place.distance) left.place = {block_.T[slot], block_.A[slot], reached(slot)};
      if (!table) continue;
      for (std::size_t k = 0; k < found.size(); ++k) {
        const Approach& approach = found[k];
        const std::size_t slot = used - 3 * (found.size() - k);
        const double best = std::min({reached(slot), reached(slot + 1), reached(slot + 2)});
        if (!(approach.distance < left.place.distance && best > 2 * approach.distance + 0.5)) continue;
        const auto distance = [&](double u) {
          const PlanePlace place = table->at(u);
          return distance_to(block_, 0, place.T, place.A);
        };
        const double low = std::max(approach.segment - 1, 0), high = std::min(approach.segment + 2, table->last());
        const double u = golden_section(low, high, distance), d = distance(u);
        if (d < left.place.distance * (1 - 1e-9)) left.place = {table->at(u).T, table->at(u).A, d};
      }
    }
  }

  /// An idle slot does what the first does.
  void begin_at_same(std::size_t slot, std::size_t index) {
    load(slot, index);
    block_.T[slot] = block_.T[0];
    block_.A[slot] = block_.A[0];
  }

  /// Writes what is left: at the place found, or, if that is none, at one that is known to lie on the curve.
  bool finish(std::size_t from, std::size_t count) {
    std::array<double, kBlock> found{};
    for (std::size_t slot = 0; slot < kBlock; ++slot) {
      const Left& left = left_[from + std::min(slot, count - 1)];
      load(slot, left.index);
      Place place = known_place(slot);
      if (left.place.distance < place.distance * (1 - 1e-12)) place = left.place;
      const bool vanishes = block_.P[slot] == 0 && block_.A_end[slot] == 0 &&
                            distance_to(block_, slot, 0, 0) <= place.distance * (1 + 1e-12);
      if (vanishes && !family_.uncoupled) return false;
      block_.T[slot] = place.T;
      block_.A[slot] = place.A;
      found[slot] = place.distance;
    }
    Block unmoved = block_;
    run_block<Begin::anywhere>(family_, kStepsOfSearch, derivatives_, block_, result_);
    measure_by_two<true>(family_, unmoved, unmoved_);  // without a step
    for (std::size_t slot = 0; slot < count; ++slot) {
      // From where it has been, or a search ended, Newton's method moves by roundings.
      const bool there = block_.at_end[slot] > 0 || (result_.stationary[slot] > 0 && result_.on_curve[slot] > 0);
      const bool better =
          block_.settled[slot] > 0 && there && result_.distance[slot] <= found[slot] * (1 + 1e-9) + 1e-9;
      if (!write(better ? block_ : unmoved, better ? result_ : unmoved_, slot, left_[from + slot].index)) return false;
    }
    return true;
  }

  /// The nearest of three places: JKR, Hertz where the curve ends there, and the one in the direction of the point from
  /// the circle's centre.
  Place known_place(std::size_t slot) const {
    const double P = block_.P[slot], centre = 3 * pi<double>(), S0 = circle_radius(P), jkr = centre + S0;
    Place best{0, area_from_radius(jkr_radius(P)), 0};
    if (family_.uncoupled) best.T = block_.T_point[slot];
    best.distance = distance_to(block_, slot, best.T, best.A);
    const auto consider = [&](double T, double A) {
      const double distance = distance_to(block_, slot, T, A);
      if (distance < best.distance) best = {T, A, distance};
    };
    consider(block_.T_end[slot], block_.A_end[slot]);
    const double A = block_.A_point[slot], T = block_.T_point[slot];
    if constexpr (kMayBeNonMonotone<Law>) {
      if (family_.non_monotone) {  // in the direction of the point from T = 0 and Hertz
        const double t = T / std::max(edge_load(radius_from_area(A), P), 1e-3 * jkr);
        if (const auto y_there = NonMonotoneCurve<Law>(family_.law, family_.p, P).upper_edge_load(t))
          consider(t * *y_there, area_of(*y_there, P));
        return best;
      }
    }
    const double end = std::max(edge_load(radius_from_area(block_.A_end[slot]), P), 0.0),
                 least = end + 1e-3 * (jkr - end);
    const double y = std::max(edge_load(radius_from_area(A), P), least), v = y - centre;
    const double tau2 = std::max(family_.law.shear_term(family_.p, y, T).value, 0.0), radius = std::sqrt(v * v + tau2);
    const double y_radial = std::max(centre + v * S0 / radius, least), v_radial = y_radial - centre;
    const double tau = std::sqrt(std::max((S0 - v_radial) * (S0 + v_radial), 0.0));
    if (!family_.uncoupled) consider(tangential_load(family_.law, family_.p, y_radial, tau), area_of(y_radial, P));
    return best;
  }
  static double area_of(double y, double P) { return area_from_radius(radius_from_edge_load(y, P)); }

  bool write(Block& block, Result<Law>& result, std::size_t slot, std::size_t i) {
    const double P = block.P[slot];
    if (derivatives_) {
      const double top = area_from_radius(jkr_radius(P));
      if (block.at_end[slot] > 0)
        measure_from_end(block, slot, 0.5 * pi<double>() / hertz_radius(P), false, result);
      else if (!(block.settled[slot] > 0) && block.T[slot] == 0 && block.A[slot] == top)
        measure_from_end(block, slot, -result.dP[slot] / result.dA[slot], true, result);  // a corner
    }
    bool finite = std::isfinite(result.r[slot]) && std::isfinite(result.dA[slot]);
    out_.r[i] = result.r[slot];
    if (!out_.place_A.empty()) {
      out_.place_T[i] = block.T[slot];
      out_.place_A[i] = block.A[slot];
    }
    if (derivatives_) {
      out_.dP[i] = result.dP[slot];
      out_.dT[i] = std::copysign(1.0, points_.T[i]) * result.dT[slot];
      out_.dA[i] = result.dA[slot];
      finite &= std::isfinite(out_.dP[i]) && std::isfinite(out_.dT[i]) && std::isfinite(out_.dA[i]);
      const std::size_t p = family_.p.size();
      for (std::size_t k = 0; k < p; ++k) {
        out_.parameters[i * p + k] = result.parameters[k][slot];
        finite &= std::isfinite(result.parameters[k][slot]);
      }
    }
    return finite;
  }

  CurveFamily<Law> family_;
  const PlanePoints& points_;
  Search search_;
  bool derivatives_;
  CurveDistances& out_;
  Block block_;
  Result<Law> result_, unmoved_;
  std::vector<Left> left_;
};

}  // namespace

template <class Law>
bool curve_distances(const Law& law, const Parameters<Law>& p, const PlanePoints& points, Search search,
                     bool derivatives, CurveDistances& out) {
  if (!LoadedContact<Law>(law, p, 0).obstacle().empty()) return false;
  return Distances<Law>(law, p, points, search, derivatives, out).find();
}

namespace {
[[gnu::used]] const auto instances = each_law([]<class Law>() { return &curve_distances<Law>; });
}  // namespace

}  // namespace mixity
