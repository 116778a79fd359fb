// Work against precision of drawing a curve A(T): how far the polyline strays from the curve, T and A scaled by their
// ranges, against a reference of 100,000 points.
//
// Evaluations: points of the polyline. Tolerance: their number asked for, or for the adaptive method the chord error.
// Uniform in T cannot draw beyond a fold, so it is tried on the stable branch alone.
#include <array>
#include <cstdio>
#include <memory>
#include <string>

#include "benchmarks/precision/precision.h"
#include "benchmarks/precision/table.h"
#include "benchmarks/precision/textbook.h"
#include "mechanics/batch.h"
#include "mechanics/sampling.h"

namespace mixity::precision {
namespace {

constexpr std::size_t kReference = 100000;

struct Place {
  double T, A;
};
using Polyline = std::vector<Place>;

volatile double sink;  // keeps polylines from being optimised away

Polyline places(const std::vector<CurvePoint>& points) {
  Polyline line;
  line.reserve(points.size());
  for (const CurvePoint& p : points) line.push_back({p.T, p.A});
  return line;
}

double distance(const Place& p, const Place& from, const Place& to) {
  const double dx = to.T - from.T, dy = to.A - from.A, x = p.T - from.T, y = p.A - from.A;
  const double square = dx * dx + dy * dy;
  const double t = square > 0 ? std::clamp((x * dx + y * dy) / square, 0.0, 1.0) : 0.0;
  return std::hypot(x - t * dx, y - t * dy);
}

/// Largest distance of the curve from the polyline, both followed from the same end: the nearest segment moves on with
/// the point, and is looked for a few segments ahead.
double chord_error(const Polyline& reference, Polyline line) {
  double T_range = 0, A_range = 0, worst = 0;
  for (const Place& p : reference) {
    T_range = std::max(T_range, p.T);
    A_range = std::max(A_range, p.A);
  }
  for (Place& p : line) p = {p.T / T_range, p.A / A_range};
  std::size_t near = 0;
  for (Place p : reference) {
    p = {p.T / T_range, p.A / A_range};
    double least = distance(p, line[near], line[near + 1]);
    for (std::size_t i = near + 1; i + 1 < line.size() && i < near + 4; ++i)
      if (const double d = distance(p, line[i], line[i + 1]); d < least) {
        least = d;
        near = i;
      }
    worst = std::max(worst, least);
  }
  return worst;
}

template <class Model>
class Drawing {
 public:
  /// Of the stable branch (as far as T_most, if it ends in no fold), or of the whole curve.
  Drawing(const Parameters<Model>& p, double P, double T_most, bool whole)
      : p_(p), P_(P), curve_(Model{}, p, P), contact_(Model{}, p, P), whole_(whole) {
    const StableBranch& branch = contact_.first_branch();
    T_last_ = std::min(branch.T_bottom, T_most);
    y_last_ = branch.T_bottom <= T_most ? branch.y_bottom : contact_.at(T_most).y;
    ranges_ = whole ? drawable_ranges(curve_, T_most)
                    : std::vector<PhiRange>{{curve_.phi_begin(curve_.pieces().front()), phi_of(curve_, y_last_)}};
    reference_ = places(sample_uniform(curve_, ranges_, kReference));
    char text[80];
    std::snprintf(text, sizeof text, "%s, lambda = %g, P = %g, ", std::string(Model::info.key).c_str(), p[0], P);
    const char* end = y_last_ > branch.y_bottom ? "towards the asymptote"
                      : branch.ends_in_fold     ? "to the fold"
                                                : "to Hertz";
    name_ = text + std::string(whole ? "through the fold" : end);
  }

  void add_rows(std::vector<Row>& all) const {
    std::vector<Row> rows;
    for (const double n : {10.0, 30.0, 100.0, 300.0, 1000.0, 3000.0}) {
      const auto points = static_cast<std::size_t>(n);
      if (!whole_) {
        add(rows, "uniform in T by TOMS 748", n, [this, points] { return uniform_in_T_by_search(points); });
        add(rows, "uniform in T by mixity", n, [this, points] { return uniform_in_T(points); });
      }
      add(rows, "uniform in phi", n, [this, points] { return places(sample_uniform(curve_, ranges_, points)); });
    }
    for (const double chord : {1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 1e-5, 1e-6})
      add(rows, "adaptive", chord, [this, chord] { return places(sample_adaptive(curve_, ranges_, chord)); });
    measure(rows);
    for (Row& row : rows) {
      row.run = nullptr;
      all.push_back(row);
    }
  }

 private:
  template <class Draw>
  void add(std::vector<Row>& rows, const char* method, double tolerance, const Draw& draw) const {
    const Polyline line = draw();
    rows.push_back({.task = "drawing",
                    .case_name = name_,
                    .method = method,
                    .tolerance = tolerance,
                    .error = chord_error(reference_, line),
                    .evaluations = static_cast<double>(line.size()),
                    .claim = "ok",
                    .run = [draw] { sink = draw().back().A; }});
  }

  double shear(std::size_t i, std::size_t n) const {
    return T_last_ * static_cast<double>(i) / static_cast<double>(n - 1);
  }
  Place last() const { return {T_last_, area_from_radius(radius_from_edge_load(y_last_, P_))}; }

  Polyline uniform_in_T(std::size_t n) const {
    std::vector<double> T(n - 1), A(n - 1);
    for (std::size_t i = 0; i + 1 < n; ++i) T[i] = shear(i, n);
    predict_areas(LoadedContact(Model{}, p_, P_), T, A);
    Polyline line;
    line.reserve(n);
    for (std::size_t i = 0; i + 1 < n; ++i) line.push_back({T[i], A[i]});
    line.push_back(last());
    return line;
  }

  /// The end of the branch is given to it.
  Polyline uniform_in_T_by_search(std::size_t n) const {
    const Bracket bracket{radius_from_edge_load(y_last_, P_),
                          radius_from_edge_load(contact_.jkr_edge_load(), P_) * (1 + 1e-9)};
    Polyline line;
    line.reserve(n);
    for (std::size_t i = 0; i + 1 < n; ++i)
      line.push_back({shear(i, n), toms748(PrintedEquation<Model>{p_[0], P_, shear(i, n)}, bracket, 1e-12).A});
    line.push_back(last());
    return line;
  }

  Parameters<Model> p_;
  double P_;
  EquilibriumCurve<Model> curve_;
  LoadedContact<Model> contact_;
  bool whole_;
  double T_last_ = 0, y_last_ = 0;
  std::vector<PhiRange> ranges_;
  Polyline reference_;
  std::string name_;
};

template <class Model>
void draw(double lambda, double P, std::vector<Row>& rows) {
  const double scale = circle_radius(P) / std::sqrt(Model::small_shear({lambda}));
  const StableBranch branch = LoadedContact(Model{}, {lambda}, P).first_branch();
  Drawing<Model>({lambda}, P, std::isfinite(branch.T_bottom) ? branch.T_bottom : 10 * scale, false).add_rows(rows);
  if (branch.ends_in_fold) Drawing<Model>({lambda}, P, 2 * branch.T_bottom, true).add_rows(rows);
}

}  // namespace
}  // namespace mixity::precision

int main() {
  using namespace mixity;
  std::vector<precision::Row> rows;
  precision::draw<Johnson>(0.15, 3, rows);          // towards its asymptote
  precision::draw<Johnson>(0.99, 3, rows);          // folds
  precision::draw<WatersGuduru>(0.15, 3, rows);     // folds
  precision::draw<WatersGuduru>(0.15, 1000, rows);  // reaches Hertz
  precision::draw<PapangeloCiavarella>(0.15, 3, rows);
  precision::print(rows);
}
