#include "mechanics/vector_math.h"
// after the declarations of the vector forms
#include <optional>
#include <vector>

#include "mechanics/curve_distance.h"
#include "mechanics/curve_outline.h"
#include "mechanics/equilibrium.h"
#include "mechanics/nearest_block.h"
#include "mechanics/outline_turn.h"

namespace mixity {
namespace {

using namespace nearest_detail;

constexpr int kSteps = 8, kStepsOfSearch = 60;
constexpr std::size_t kApproaches = 4;

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
      if (!set_points(block_, points_, from, count)) return false;
      open_ = count;
      is_open_.fill(true);
      if (begin_nearby(from, count)) {
        run_block<Begin::nearby>(family_, kSteps, derivatives_, block_, result_);
        if (!write_nearest(from, count)) return false;
        if (open_ == 0) continue;
      }
      run_block<Begin::at_the_point>(family_, search_ == Search::rough ? 0 : kSteps, derivatives_, block_, result_);
      if (!write_nearest(from, count)) return false;
      for (std::size_t slot = 0; open_ > 0 && slot < count; ++slot)
        if (is_open_[slot])
          left_.push_back({from + slot,
                           {block_.T[slot], block_.A[slot],
                            is_settled(slot) ? result_.distance[slot] : std::numeric_limits<double>::infinity()}});
    }
    if (!left_.empty() && !family_.uncoupled) search_curves();
    for (std::size_t from = 0; from < left_.size(); from += kBlock)
      if (!finish(from, std::min(kBlock, left_.size() - from))) return false;
    return true;
  }

 private:
  /// A point that remains after the first pass, and the nearest point of the curve found for it.
  struct Left {
    std::size_t index;
    Place place;
  };

  /// Takes the caller's starting points. False if a point of the block has none.
  bool begin_nearby(std::size_t from, std::size_t count) {
    if (out_.place_A.empty() || family_.uncoupled) return false;
    if (count == kBlock) return begin_slots(&out_.place_T[from], &out_.place_A[from], block_);
    for (std::size_t slot = 0; slot < kBlock; ++slot) {
      const std::size_t i = from + std::min(slot, count - 1);
      if (!(out_.place_A[i] > 0)) return false;
      block_.T[slot] = out_.place_T[i];
      block_.A[slot] = out_.place_A[i];
    }
    return true;
  }

  /// Where Newton's method starts, and then where it is; its distance once it has ended on the curve.
  struct Start {
    std::size_t index;
    PlanePlace at;
    double distance = kLargest;
  };

  /// The starts for one remaining point: consecutive ones, the last three of each approach.
  struct Starts {
    Left* left;
    std::size_t first, end;
    std::vector<Approach> found;
  };

  void load(std::size_t slot, std::size_t index) {
    set_point(block_, slot, points_, index);
    const CurveBounds ends = curve_bounds(family_, points_.P[index]);
    block_.T_end[slot] = ends.T;
    block_.A_end[slot] = ends.A;
    block_.settled[slot] = block_.at_end[slot] = 0;
  }

  bool is_settled(std::size_t slot) const {
    return block_.settled[slot] > 0 && result_.on_curve[slot] > 0 && std::isfinite(result_.distance[slot]);
  }

  /// Writes the open points of the block whose places are nearest, or need not be, and closes them.
  bool write_nearest(std::size_t from, std::size_t count) {
    const OfAll all = in_vectors([&] { return of_all(block_, result_, derivatives_, family_.p.size()); });
    std::array<bool, kBlock> found{};
    std::size_t closed = 0;
    for (std::size_t slot = 0; slot < count; ++slot) {
      if (!is_open_[slot]) continue;
      const bool enough = search_ == Search::rough || (search_ == Search::local && is_settled(slot));
      found[slot] = result_.sure[slot] > 0 || enough || is_nearest(slot);
      closed += found[slot];
    }
    open_ -= closed;
    if (closed == count && all.inside) {
      write_all(from, count);
      return all.finite;
    }
    for (std::size_t slot = 0; slot < count; ++slot) {
      if (!found[slot]) continue;
      if (!write(block_, result_, slot, from + slot)) return false;
      is_open_[slot] = false;
    }
    return true;
  }

  /// The outline of the curve of a load.
  const std::vector<PlanePlace>& outline(double P) {
    if (!table_) table_.emplace(family_);
    if (P != P_of_outline_) {
      P_of_outline_ = P;
      const CurveBounds ends = curve_bounds(family_, P);
      table_->set_load(P, {ends.T, ends.A});
    }
    return table_->places();
  }

  /// Whether the place that was found is the nearest: the outline approaches the point there and turns little,
  /// elsewhere it stays farther away, and the distance has a clear minimum. Of laws whose curves bend on no smaller
  /// scale than that of the outline's nodes.
  bool is_nearest(std::size_t slot) {
    constexpr double kClear = 0.3;  // of the second derivative that the distance from a straight line has
    if constexpr (HasPackedForm<Law>) {
      if (family_.uncoupled || !is_settled(slot) || block_.at_end[slot] > 0) return false;
      const double least = result_.curvature[slot], distance = result_.distance[slot], A = block_.A[slot];
      if (!(least > kClear)) return false;
      const PlanePlace point{block_.T_point[slot], block_.A_point[slot]};
      const double per_T = block_.per_T[slot], per_A = block_.per_A[slot], reach = distance * block_.sigma_A[slot];
      const std::vector<PlanePlace>& all = outline(block_.P[slot]);
      // the rest of the curve is farther away in A alone
      const std::span<const PlanePlace> part = nodes_of_areas(all, point.A - reach, point.A + reach);
      approaches(part, point, per_T, per_A, kApproaches, segments_, near_);
      if (near_.empty()) return false;
      const int before = static_cast<int>(part.data() - all.data()), last = static_cast<int>(part.size()) - 2;
      const Turn turn = turn_of(all, before + near_[0].segment, per_T, per_A);
      if (!(A <= turn.highest && A >= turn.lowest && turn.sine < 0.5)) return false;
      for (std::size_t k = 1; k < near_.size(); ++k) {
        const int segment = near_[k].segment, of_all = before + segment;
        if ((segment == 0 && before > 0) || (segment == last && of_all < table_->last() - 1)) continue;
        const double elsewhere = table_->is_along_rays() ? least_distance(all, of_all, point, per_T, per_A)
                                                         : near_[k].distance - size_of(all, of_all, per_T, per_A);
        if (!(elsewhere > distance)) return false;
      }
      // beyond the convex side of the curve no other place is near
      return least >= 1 || (1 - kClear) * turn.radius > 2 * distance;
    }
    return false;
  }

  /// Newton's method from a known point of the curve, where it has not converged yet. A global search also starts from
  /// each part of the curve's outline that comes near the measured point, and from both ends of that part, since there
  /// may be two near points beside a fold. A part much nearer than what was found is searched by golden section.
  void search_curves() {
    std::vector<Start> all;
    std::vector<Starts> of_points;
    for (Left& left : left_) {
      const std::size_t i = left.index;
      Starts starts{&left, all.size(), 0, {}};
      if (!std::isfinite(left.place.distance)) {
        load(0, i);
        const Place known = known_place(family_, block_, 0);
        all.push_back({i, {known.T, known.A}});
      }
      if (search_ == Search::global) {
        const std::vector<PlanePlace>& nodes = outline(points_.P[i]);
        approaches(nodes, {std::abs(points_.T[i]), points_.A[i]}, 1 / points_.sigma_T[i], 1 / points_.sigma_A[i],
                   kApproaches, segments_, starts.found);
        for (const Approach& approach : starts.found) {
          all.push_back({i, approach.place});
          for (const int side : {-1, 2})
            all.push_back({i, nodes[static_cast<std::size_t>(std::clamp(approach.segment + side, 0, table_->last()))]});
        }
      }
      starts.end = all.size();
      if (starts.end > starts.first) of_points.push_back(std::move(starts));
    }
    settle_all(all);
    for (const Starts& starts : of_points) {
      Left& left = *starts.left;
      for (std::size_t k = starts.first; k < starts.end; ++k)
        if (all[k].distance < left.place.distance) left.place = {all[k].at.T, all[k].at.A, all[k].distance};
      for (std::size_t k = 0; k < starts.found.size(); ++k) {
        const Approach& approach = starts.found[k];
        const Start* const three = &all[starts.end - 3 * (starts.found.size() - k)];
        const double best = std::min({three[0].distance, three[1].distance, three[2].distance});
        if (!(approach.distance < left.place.distance && best > 2 * approach.distance + 0.5)) continue;
        outline(points_.P[left.index]);
        set_point(block_, 0, points_, left.index);
        const auto distance = [&](double u) {
          const PlanePlace place = table_->at(u);
          return distance_to(block_, 0, place.T, place.A);
        };
        const double low = std::max(approach.segment - 1, 0), high = std::min(approach.segment + 2, table_->last());
        const double u = golden_section(low, high, distance), d = distance(u);
        if (d < left.place.distance * (1 - 1e-9)) left.place = {table_->at(u).T, table_->at(u).A, d};
      }
    }
  }

  /// Newton's method from all starts. Those that take many steps, or never settle, continue in blocks of their own:
  /// one such start would cost all others of its block as many steps.
  void settle_all(std::vector<Start>& all) {
    std::vector<Start*> open, next;
    for (Start& start : all) open.push_back(&start);
    int taken = 0;
    for (const int until : {kSteps, 3 * kSteps, kStepsOfSearch}) {
      for (std::size_t from = 0; from < open.size(); from += kBlock) {
        const std::size_t count = std::min(kBlock, open.size() - from);
        for (std::size_t slot = 0; slot < kBlock; ++slot) {
          const Start& start = *open[from + std::min(slot, count - 1)];
          load(slot, start.index);
          block_.T[slot] = start.at.T;
          block_.A[slot] = start.at.A;
        }
        run_block<Begin::anywhere>(family_, until - taken, false, block_, result_);
        for (std::size_t slot = 0; slot < count; ++slot) {
          Start& start = *open[from + slot];
          start.at = {block_.T[slot], block_.A[slot]};
          if (!(block_.settled[slot] > 0))
            next.push_back(&start);
          else if (result_.on_curve[slot] > 0)
            start.distance = result_.distance[slot];
        }
      }
      taken = until;
      open.swap(next);
      next.clear();
    }
  }

  /// Writes the remaining points: at the point found on the curve, else at a known one.
  bool finish(std::size_t from, std::size_t count) {
    std::array<double, kBlock> found{};
    for (std::size_t slot = 0; slot < kBlock; ++slot) {
      const Left& left = left_[from + std::min(slot, count - 1)];
      load(slot, left.index);
      Place place = known_place(family_, block_, slot);
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
    measure_block(family_, true, unmoved, unmoved_);  // without a step
    for (std::size_t slot = 0; slot < count; ++slot) {
      // Newton's method, started where it or a search has ended, moves only by rounding.
      const bool there = block_.at_end[slot] > 0 || (result_.stationary[slot] > 0 && result_.on_curve[slot] > 0);
      const bool better =
          block_.settled[slot] > 0 && there && result_.distance[slot] <= found[slot] * (1 + 1e-9) + 1e-9;
      if (!write(better ? block_ : unmoved, better ? result_ : unmoved_, slot, left_[from + slot].index)) return false;
    }
    return true;
  }

  /// The same as write() for each of these points, whose places are between the ends of the curves.
  void write_all(std::size_t from, std::size_t count) {
    const std::size_t p = family_.p.size();
    const auto at = [from](std::span<double> values) { return values.empty() ? nullptr : &values[from]; };
    const WrittenArrays to{&points_.T[from],
                           &out_.r[from],
                           at(out_.place_T),
                           at(out_.place_A),
                           derivatives_ ? &out_.dP[from] : nullptr,
                           derivatives_ ? &out_.dT[from] : nullptr,
                           derivatives_ ? &out_.dA[from] : nullptr,
                           derivatives_ ? &out_.parameters[from * p] : nullptr};
    in_vectors([&] {
      if (count == kBlock) return write_slots(block_, result_, kBlock, p, to);
      write_slots(block_, result_, count, p, to);
    });
  }

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
  std::size_t open_ = 0;  // points of the block that are not written yet
  std::array<bool, kBlock> is_open_{};
  std::vector<Left> left_;
  std::optional<RayTable<Law>> table_;
  double P_of_outline_ = std::numeric_limits<double>::quiet_NaN();
  SegmentDistances segments_;
  std::vector<Approach> near_;
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
