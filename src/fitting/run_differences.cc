#include "fitting/run_differences.h"

#include <algorithm>
#include <cmath>

#include "fitting/fitted_errors.h"
#include "statistics/distributions.h"

namespace mixity {
UsedRuns used_runs(const Dataset& data, std::span<const std::size_t> used) {
  Groups all(data.curves.size());
  for (std::size_t i = 0; i < used.size(); ++i) all[data.points[used[i]].curve].push_back(i);
  UsedRuns list;
  for (std::size_t run = 0; run < all.size(); ++run) {
    if (all[run].empty()) continue;
    list.groups.push_back(std::move(all[run]));
    list.runs.push_back(run);
  }
  return list;
}

std::vector<std::string> tested_quantities(const Dataset& data, const PreparedFit& prepared) {
  std::vector<std::string> list;
  const auto infos = prepared.model.parameters();
  for (std::size_t k = 0; k < infos.size() && list.empty(); ++k)
    if (!prepared.held[k]) list.emplace_back(infos[k].name);
  for (const Constant c : {kToughness, kModulus, kAreaScale, kLoadOffset})
    if (c != kLoadOffset || !data.several_spheres) list.emplace_back(kConstantNames[c]);
  return list;
}

std::optional<RunRows> run_rows(const Dataset& data, const FitOptions& options, const PreparedFit& prepared,
                                const std::vector<double>& x, const std::vector<double>& residuals,
                                const std::vector<std::string>& quantities, double unit) {
  PreparedFit all = prepared;
  all.errors = std::make_shared<StandardErrors>(*prepared.errors);
  all.errors->correlations = {};
  all.errors->runs.spreads.clear();  // their shifts remain
  all.errors->expected.clear();
  all.start.clear();
  std::vector<double> beside = x;
  for (const std::string& name : quantities) {
    const auto constant = constant_named(name);
    const bool fitted = std::any_of(prepared.fitted.begin(), prepared.fitted.end(),
                                    [&](const FittedConstant& one) { return one.constant == constant; });
    if (!constant || fitted) continue;
    all.fitted.push_back({*constant, prepared.constants[*constant], 0});
    beside.push_back(prepared.constants[*constant]);
  }
  const auto problem = make_problem(data, options, all);
  const std::size_t n = problem->residual_count(), width = beside.size(), p = x.size();
  std::vector<double> bare(n), jacobian(n * width);
  if (!problem->evaluate(beside, bare, jacobian)) return std::nullopt;
  const auto& parameters = problem->parameters();
  std::vector<std::size_t> priors;
  for (std::size_t k = 0; k < p; ++k)
    if (parameters[k].prior > 0) priors.push_back(k);
  const auto rows = static_cast<Eigen::Index>(n), columns = static_cast<Eigen::Index>(p),
             effects = static_cast<Eigen::Index>(quantities.size());
  RunRows found{Eigen::MatrixXd::Zero(rows + static_cast<Eigen::Index>(priors.size()), columns), {}, {}, {}};
  found.r = Eigen::VectorXd::Zero(found.J.rows());
  found.Z.resize(rows, effects);
  const auto whole = as_matrix(jacobian, width);
  for (Eigen::Index q = 0; q < effects; ++q) {
    const auto named = std::find_if(parameters.begin(), parameters.end(), [&](const FreeParameter& one) {
      return one.name == quantities[static_cast<std::size_t>(q)];
    });
    if (named == parameters.end()) return std::nullopt;
    found.Z.col(q) = whole.col(named - parameters.begin()) / unit;
  }
  const auto neighbours = neighbours_of(data, prepared.used, *prepared.errors);
  std::vector<double> r = residuals;
  if (neighbours) {
    neighbours->apply(r);
    for (std::size_t k = 0; k < width; ++k) neighbours->apply(std::span(jacobian).subspan(k), width);
  }
  found.J.topRows(rows) = whole.leftCols(columns) / unit;
  found.r.head(rows) = as_vector(r) / unit;
  found.Zw = found.Z;
  if (neighbours)
    for (Eigen::Index q = 0; q < effects; ++q)
      neighbours->apply({found.Zw.col(q).data(), static_cast<std::size_t>(rows)});
  for (std::size_t i = 0; i < priors.size(); ++i) {
    const FreeParameter& parameter = parameters[priors[i]];
    const auto row = rows + static_cast<Eigen::Index>(i);
    found.J(row, static_cast<Eigen::Index>(priors[i])) = 1 / parameter.prior;
    found.r[row] = (x[priors[i]] - *parameter.start) / parameter.prior;
  }
  if (!found.J.allFinite() || !found.Zw.allFinite() || !found.r.allFinite()) return std::nullopt;
  return found;
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
