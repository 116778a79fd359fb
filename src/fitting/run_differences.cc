#include "fitting/run_differences.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/threads.h"
#include "fitting/fitted_errors.h"
#include "solver/linear_algebra.h"
#include "statistics/distributions.h"

namespace mixity {
UsedRuns used_runs(const Dataset& data, const PointIndices& used) {
  Groups all(data.curves.size());
  std::vector<std::size_t> sizes(all.size());
  for (const std::size_t i : used) ++sizes[data.points[i].curve];
  for (std::size_t run = 0; run < all.size(); ++run) all[run].reserve(sizes[run]);
  for (std::size_t i = 0; i < used.size(); ++i) all[data.points[used[i]].curve].push_back(i);
  UsedRuns list;
  for (std::size_t run = 0; run < all.size(); ++run) {
    if (all[run].empty()) continue;
    list.groups.push_back(std::move(all[run]));
    list.runs.push_back(run);
  }
  return list;
}

PointsByRun::PointsByRun(const Dataset& data, const PointIndices& used) : begins_{0} {
  const auto run_of = [&](std::size_t i) { return data.points[used[i]].curve; };
  std::vector<std::size_t> next(std::max<std::size_t>(data.curves.size(), 1));
  bool sorted = true;
  for (std::size_t i = 0, end = 0; i < used.size(); i = end) {  // stretches of one run
    const std::size_t run = run_of(i);
    for (end = i + 1; end < used.size() && run_of(end) == run;) ++end;
    next[run] += end - i;
    sorted &= end == used.size() || run < run_of(end);
  }
  for (std::size_t run = 0; run < next.size(); ++run) {
    const std::size_t size = std::exchange(next[run], begins_.back());
    if (size == 0) continue;
    runs_.push_back(run);
    begins_.push_back(begins_.back() + size);
  }
  if (sorted) return;
  order_.resize(used.size());
  for (std::size_t i = 0; i < used.size(); ++i) order_[next[run_of(i)]++] = static_cast<std::uint32_t>(i);
}

std::vector<std::string> tested_quantities(const Dataset& data, const PreparedFit& prepared) {
  std::vector<std::string> list;
  const auto infos = prepared.model.parameters();
  for (std::size_t k = 0; k < infos.size() && list.empty(); ++k)
    if (!prepared.held[k]) list.emplace_back(infos[k].name);
  const Constant of_held = data.holds_approach() ? kApproachOffset : kLoadOffset;
  for (const Constant c : {kToughness, kModulus, kAreaScale, of_held})
    if (c != of_held || !data.several_spheres) list.emplace_back(kConstantNames[c]);
  return list;
}

namespace {

/// A fit with further free constants, whose points are independent.
struct Widened {
  PreparedFit prepared;
  std::vector<double> x;
};

/// A copy of all but the points, whose indices may be millions.
PreparedFit without_points(const PreparedFit& fit) {
  PreparedFit copy{fit.model, fit.objective};
  copy.base = fit.base;
  copy.held = fit.held;
  copy.errors = fit.errors;
  copy.constants = fit.constants;
  copy.fitted = fit.fitted;
  return copy;
}

/// Has no points.
Widened with_quantities(const PreparedFit& prepared, const std::vector<double>& x,
                        const std::vector<std::string>& quantities) {
  Widened wide{without_points(prepared), x};
  // Only their slopes are used, on which expected distances do not act: of independent points the errors serve as they
  // are, and of millions no list is copied.
  if (prepared.errors->correlations.any() || prepared.errors->runs.any()) {
    StandardErrors& errors = *(wide.prepared.errors = std::make_shared<StandardErrors>(*prepared.errors));
    errors.correlations = {};
    errors.runs.spreads.clear();  // their shifts remain
    errors.expected.clear();
  }
  for (const std::string& name : quantities) {
    const auto constant = constant_named(name);
    const bool fitted = std::any_of(prepared.fitted.begin(), prepared.fitted.end(),
                                    [&](const FittedConstant& one) { return one.constant == constant; });
    if (!constant || fitted) continue;
    wide.prepared.fitted.push_back({*constant, prepared.constants[*constant], 0});
    wide.x.push_back(prepared.constants[*constant]);
  }
  return wide;
}

/// Of each quantity its column of the Jacobian; empty if one has none.
std::vector<Eigen::Index> columns_of(const std::vector<FreeParameter>& parameters,
                                     const std::vector<std::string>& quantities) {
  std::vector<Eigen::Index> columns;
  for (const std::string& quantity : quantities) {
    const auto named = std::find_if(parameters.begin(), parameters.end(),
                                    [&](const FreeParameter& one) { return one.name == quantity; });
    if (named == parameters.end()) return {};
    columns.push_back(named - parameters.begin());
  }
  return columns;
}

/// Parameters that have one, as rows behind those of the data.
void add_priors(const std::vector<FreeParameter>& parameters, const std::vector<double>& x, RunRows& rows) {
  std::vector<std::size_t> priors;
  for (std::size_t k = 0; k < x.size(); ++k)
    if (parameters[k].prior > 0) priors.push_back(k);
  const Eigen::Index data = rows.r.size(), all = data + static_cast<Eigen::Index>(priors.size());
  rows.J.conservativeResize(all, Eigen::NoChange);
  rows.r.conservativeResize(all);
  rows.J.bottomRows(all - data).setZero();
  for (std::size_t i = 0; i < priors.size(); ++i) {
    const FreeParameter& parameter = parameters[priors[i]];
    const auto row = data + static_cast<Eigen::Index>(i);
    rows.J(row, static_cast<Eigen::Index>(priors[i])) = 1 / parameter.prior;
    rows.r[row] = (x[priors[i]] - *parameter.start) / parameter.prior;
  }
}

}  // namespace

std::optional<RunRows> run_rows(const Dataset& data, const FitOptions& options, const PreparedFit& prepared,
                                const std::vector<double>& x, const std::vector<double>& residuals,
                                const std::vector<std::string>& quantities, double unit) {
  auto [all, beside] = with_quantities(prepared, x, quantities);
  all.used = prepared.used;
  const auto problem = make_problem(data, options, all);
  const std::size_t n = problem->residual_count(), width = beside.size(), p = x.size();
  std::vector<double> bare(n), jacobian(n * width);
  if (!problem->evaluate(beside, bare, jacobian)) return std::nullopt;
  const auto& parameters = problem->parameters();
  const auto rows = static_cast<Eigen::Index>(n), columns = static_cast<Eigen::Index>(p),
             effects = static_cast<Eigen::Index>(quantities.size());
  const std::vector<Eigen::Index> of_quantities = columns_of(parameters, quantities);
  if (of_quantities.size() != quantities.size()) return std::nullopt;
  RunRows found;
  found.Z.resize(rows, effects);
  const auto whole = as_matrix(jacobian, width);
  for (Eigen::Index q = 0; q < effects; ++q)
    found.Z.col(q) = whole.col(of_quantities[static_cast<std::size_t>(q)]) / unit;
  const auto neighbours = neighbours_of(data, prepared.used, *prepared.errors);
  std::vector<double> r = residuals;
  r.resize(n);
  const std::size_t points = prepared.used.size();  // the rows of axes follow
  found.bare = whole.leftCols(columns) / unit;
  if (neighbours) {
    neighbours->apply(std::span(r).first(points));
    for (std::size_t k = 0; k < width; ++k)
      neighbours->apply(std::span(jacobian).first(points * width).subspan(k), width);
  }
  found.J = neighbours ? Eigen::MatrixXd(whole.leftCols(columns) / unit) : found.bare;
  found.r = as_vector(r) / unit;
  found.Zw = found.Z;
  if (neighbours)
    for (Eigen::Index q = 0; q < effects; ++q) neighbours->apply({found.Zw.col(q).data(), points});
  add_priors(parameters, x, found);
  if (!found.J.allFinite() || !found.Zw.allFinite() || !found.r.allFinite()) return std::nullopt;
  return found;
}

std::optional<SummedRows> summed_run_rows(const Dataset& data, const FitOptions& options, const PreparedFit& prepared,
                                          const PointsByRun& points, const std::vector<double>& x,
                                          const std::vector<double>& residuals,
                                          const std::vector<std::string>& quantities, double unit) {
  constexpr std::size_t kAtOnce = kManyPoints / 2;
  const Widened wide = with_quantities(prepared, x, quantities);
  const auto p = static_cast<Eigen::Index>(x.size()), effects = static_cast<Eigen::Index>(quantities.size()),
             width = p + effects + 1;
  struct Piece {
    std::size_t group, begin;
    Eigen::MatrixXd triangle{};  // of its rows; empty where a value is not finite
  };
  std::vector<Piece> pieces;
  std::vector<FreeParameter> parameters;
  for (std::size_t g = 0; g < points.runs(); ++g)
    for (std::size_t begin = 0; begin < points.size(g); begin += kAtOnce) pieces.push_back({g, begin});
  const auto reduce = [&](Piece& piece) {
    const auto index = [&](std::size_t i) { return points.at(piece.group, piece.begin + i); };
    const std::size_t n = std::min(kAtOnce, points.size(piece.group) - piece.begin), columns = wide.x.size();
    PreparedFit some = wide.prepared;
    for (std::size_t i = 0; i < n; ++i) some.used.push_back(prepared.used[index(i)]);
    const auto problem = make_problem(data, options, some);
    const std::vector<Eigen::Index> of_quantities = columns_of(problem->parameters(), quantities);
    std::vector<double> bare(n), jacobian(n * columns);
    if (of_quantities.size() != quantities.size() || !problem->evaluate(wide.x, bare, jacobian)) return;
    const auto whole = as_matrix(jacobian, columns);
    Eigen::MatrixXd rows(whole.rows(), width);
    rows.leftCols(p) = whole.leftCols(p) / unit;
    for (Eigen::Index q = 0; q < effects; ++q)
      rows.col(p + q) = whole.col(of_quantities[static_cast<std::size_t>(q)]) / unit;
    for (std::size_t i = 0; i < n; ++i) rows(static_cast<Eigen::Index>(i), width - 1) = residuals[index(i)] / unit;
    piece.triangle = qr_triangle(std::move(rows));
    if (&piece == pieces.data()) parameters = problem->parameters();
  };
  parallel_for(pieces.size(), [&](std::size_t k) { reduce(pieces[k]); });
  Eigen::MatrixXd triangles(static_cast<Eigen::Index>(points.runs()) * width, width);
  SummedRows sums;
  for (std::size_t k = 0; k < pieces.size();) {
    const std::size_t g = pieces[k].group, first_piece = k;
    while (k < pieces.size() && pieces[k].group == g) {
      if (pieces[k].triangle.size() == 0) return std::nullopt;
      ++k;
    }
    Eigen::MatrixXd stack(static_cast<Eigen::Index>(k - first_piece) * width, width);
    for (std::size_t i = first_piece; i < k; ++i)
      stack.middleRows(static_cast<Eigen::Index>(i - first_piece) * width, width) = pieces[i].triangle;
    const auto first = static_cast<Eigen::Index>(g) * width;
    triangles.middleRows(first, width) = qr_triangle(std::move(stack));
    std::vector<std::size_t>& list = sums.groups.emplace_back();
    for (Eigen::Index i = 0; i < width; ++i) list.push_back(static_cast<std::size_t>(first + i));
  }
  if (!triangles.allFinite()) return std::nullopt;
  sums.rows = {triangles.leftCols(p), triangles.rightCols(1), {}, triangles.middleCols(p, effects)};
  add_priors(parameters, x, sums.rows);
  return sums;
}

RunTest run_test(const Dataset& data, const std::string& quantity, const GroupTest& test,
                 const std::vector<std::size_t>& runs, std::optional<double> freedom) {
  const auto chance = [&](double fall, double directions) {
    if (!(directions > 0 && fall > 0)) return 1.0;
    return freedom ? fisher_p_value(fall / directions, directions, *freedom) : chi_squared_p_value(fall, directions);
  };
  const auto constant = constant_named(quantity);
  const bool relative = constant && is_factor(*constant);
  const ConstantUnit unit = shown_deviation(data, quantity);
  const auto way = [&](const GroupTest::One& one, double size, double p_value) {
    return RunTest::Way{one.fall, p_value, size * unit.scale, one.change, one.widening};
  };
  RunTest result{quantity, unit.text, relative, test.directions};
  result.all = way({test.fall, 0, test.change, test.widening}, test.spread, chance(test.fall, test.directions));
  const auto largest = std::max_element(test.groups.begin(), test.groups.end(),
                                        [](const auto& x, const auto& y) { return x.fall < y.fall; });
  result.run = runs[static_cast<std::size_t>(largest - test.groups.begin())];
  result.odd =
      way(*largest, largest->value, std::min(1.0, chance(largest->fall, 1) * static_cast<double>(test.groups.size())));
  result.drift = way(test.along, test.along.value, chance(test.along.fall, 1));
  return result;
}

}  // namespace mixity
