#include "fitting/error_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/threads.h"
#include "fitting/limited_residuals.h"
#include "fitting/run_differences.h"
#include "statistics/distributions.h"
#include "statistics/variance_components.h"

namespace mixity {
namespace {

// Components of the variance, as bits of a choice.
enum : std::uint32_t { kConstantA = 1, kShareA = 2, kConstantT = 4, kShareT = 8 };
constexpr std::uint32_t kOfA = kConstantA | kShareA, kOfT = kConstantT | kShareT;

double square(double x) { return x * x; }

/// How many neighbours become one row: of many points those of a run have almost the same variance.
std::size_t pool_of(std::size_t points) {
  constexpr std::size_t kRows = kManyPoints / 2;
  return points < kManyPoints ? 1 : points / kRows;
}

/// The rows that add(g, rows) makes of each run. Pooled rows are of one run, and their runs are handled in parallel.
template <class Add>
Deviations rows_of_runs(const PointsByRun& in_runs, std::size_t pool, const Add& add) {
  Deviations rows(4, pool);
  if (pool == 1) {
    for (std::size_t g = 0; g < in_runs.runs(); ++g) add(g, rows);
    return rows;
  }
  std::vector<Deviations> of_runs(in_runs.runs(), rows);
  parallel_for(of_runs.size(), [&](std::size_t g) { add(g, of_runs[g]); });
  for (const Deviations& one : of_runs) rows.append(one);
  return rows;
}

Deviations residual_rows(const Dataset& data, const PointIndices& used, const NearestPlaces& nearest,
                         const LimitedResiduals& residuals, std::span<const double> leverages, const AxisErrors& T,
                         const AxisErrors& A, const ErrorModels& before, std::size_t pool) {
  constexpr double kMostLeverage = 0.9;  // a residual with a larger one says little about its error
  const auto add = [&](std::size_t i, Deviations& rows) {
    const double share = 1 - leverages[i], r = residuals[i];
    if (share < 1 - kMostLeverage) return;
    const double alone = square(nearest.load_A[i]) * independence(before.correlations.first) +
                         square(nearest.load_T[i]) * independence(before.correlations.second);
    const double factor = square(before.factor(data.points[used[i]].curve));
    const double by_T = square(nearest.load_T[i] / T.sigma[i]), by_A = square(nearest.load_A[i] / A.sigma[i]);
    const double fixed = by_T * square(T.known ? T.sigma[i] : T.least) + by_A * square(A.known ? A.sigma[i] : A.least);
    const std::array<double, 4> shape{factor * by_A, factor * by_A * square(nearest.A[i]), factor * by_T,
                                      factor * by_T * square(nearest.T[i])};
    rows.add(r * r / share, share * alone, fixed, shape);
  };
  if (pool > 1) {
    const PointsByRun in_runs(data, used);
    return rows_of_runs(in_runs, pool, [&](std::size_t g, Deviations& rows) {
      for (std::size_t k = 0; k < in_runs.size(g); ++k) add(in_runs.at(g, k), rows);
    });
  }
  Deviations rows(4);
  for (std::size_t i = 0; i < residuals.size(); ++i) add(i, rows);
  return rows;
}

/// The fraction of the variance of second differences that remains if neighbours correlate.
double kept(double rho) { return (6 - 8 * rho + 2 * rho * rho) / 6; }

/// Second differences of T's readings in each run; rows of different runs may alternate.
Deviations differences_of_T(const Dataset& data, const PointIndices& used, const NearestPlaces& nearest, double least,
                            const ErrorModels& before, std::size_t pool) {
  constexpr double kShare = 0.5;  // neighbouring second differences of white noise correlate by -2/3 and 1/6
  const PointsByRun in_runs(data, used);
  return rows_of_runs(in_runs, pool, [&](std::size_t g, Deviations& rows) {
    const double factor = kept(before.correlations.second) * square(before.factor(in_runs.run(g)));
    const auto T = [&](std::size_t k) { return data.points[used[in_runs.at(g, k)]].shear(); };
    const auto place = [&](std::size_t k) { return square(nearest.T[in_runs.at(g, k)]); };
    for (std::size_t k = 2; k < in_runs.size(g); ++k) {
      const double d = T(k) - 2 * T(k - 1) + T(k - 2), squares = place(k) + 4 * place(k - 1) + place(k - 2);
      rows.add(d * d, kShare, 6 * least * least, std::array<double, 4>{0, 0, 6 * factor, squares * factor});
    }
  });
}

/// Sum of the squared second differences of T divided by their variances under these errors without correlation, and
/// the number of independent ones that they equal.
struct ReadingsOfT {
  double squares = 0, rows = 0;
};

/// `differences`: of T, without correlation.
ReadingsOfT readings_of_T(const Deviations& differences, const ErrorModels& models) {
  ReadingsOfT sum;
  const ErrorModel now = models.T.value_or(ErrorModel{});
  for (std::size_t i = 0; i < differences.size(); ++i) {
    const double variance = differences.fixed[i] + differences.shapes[2][i] * square(now.constant) +
                            differences.shapes[3][i] * square(now.share);
    sum.squares += differences.shares[i] * differences.squares[i] / variance;
    sum.rows += differences.shares[i];
  }
  return sum;
}

/// What decides about correlations: the first deviations, one run after the other.
struct Deciding {
  TwoProcesses processes;
  std::vector<double> deviations{};
};

/// `own`: as estimate_errors has it.
Deciding deciding_deviations(const Dataset& data, const PointIndices& used, const NearestPlaces& nearest,
                             const LimitedResiduals& residuals, const std::vector<std::vector<double>>& own) {
  struct Found {
    std::size_t row, place;
  };
  std::vector<std::vector<Found>> runs(data.curves.size());
  std::vector<std::size_t> passed(data.curves.size());
  std::vector<std::uint32_t> places;  // of all points, where some are not used
  if (!used.are_first()) {
    places.reserve(data.points.size());
    for (const Point& point : data.points) places.push_back(static_cast<std::uint32_t>(passed[point.curve]++));
  }
  for (std::size_t row = 0; row < used.size(); ++row) {
    const std::size_t curve = data.points[used[row]].curve,
                      place = places.empty() ? passed[curve]++ : places[used[row]];
    if (runs[curve].size() < kDeciding) runs[curve].push_back({row, place});
  }
  Deciding some{{{}, {}, {}, {}, std::vector<std::vector<double>>(own.size())}};
  for (const auto& run : runs) {
    auto& list = some.processes.runs.emplace_back();
    for (const auto [i, place] : run) {
      if (some.deviations.size() == kDeciding) break;
      list.push_back(some.deviations.size());
      some.deviations.push_back(residuals[i]);
      some.processes.places.push_back(static_cast<double>(place));
      some.processes.first.push_back(nearest.load_A[i]);
      some.processes.second.push_back(nearest.load_T[i]);
      for (std::size_t q = 0; q < own.size(); ++q) some.processes.own[q].push_back(own[q][i]);
    }
  }
  return some;
}

/// Improves the sizes of the errors that are not known, and all correlations, by the likelihood of the correlated
/// residuals and of the second differences of T.
void improve_correlated(const Deciding& deciding, const ReadingsOfT& readings, bool T_known, bool A_known,
                        ErrorModels& models) {
  const auto [squares, rows] = models.differences ? readings : ReadingsOfT{};
  const auto of_readings = [&, squares = squares, rows = rows](const ScaledCorrelations& at) {
    const double variance = square(at.second) * kept(at.correlations.second);
    return -(rows * std::log(variance) + squares / variance) / 2;
  };
  ScaledCorrelations found = improve(deciding.processes, deciding.deviations, models.correlations, of_readings);
  models.correlations = found.correlations;
  const auto scale = [](std::optional<ErrorModel>& model, bool known, double factor) {
    if (model && !known) *model = {model->constant * factor, model->share * factor};
  };
  scale(models.A, A_known, found.first);
  scale(models.T, T_known, found.second);
}

/// Every choice of at least one part for each axis that is not known; of none for T, too, if `may_be_exact`.
std::vector<std::uint32_t> choices(bool T_known, bool A_known, bool may_be_exact) {
  std::vector<std::uint32_t> list;
  for (std::uint32_t one = 0; one < 16; ++one) {
    const bool some_A = one & kOfA, some_T = one & kOfT;
    if (some_A != A_known && (T_known ? !some_T : some_T || may_be_exact)) list.push_back(one);
  }
  return list;
}

/// Factors of the runs' errors, relative to the geometric mean; empty if they agree. `innovations`: of variance 1 if
/// the errors are as estimated.
template <class Innovations>
std::vector<double> run_factors(const Dataset& data, const PointIndices& used, const Innovations& innovations,
                                std::span<const double> leverages, const ErrorModels& before) {
  constexpr double kChance = 1e-3, kFewest = 4;
  std::vector<double> squares(data.curves.size()), freedom(data.curves.size());
  for (std::size_t i = 0; i < used.size(); ++i) {
    const std::size_t run = data.points[used[i]].curve;
    squares[run] += square(innovations[i] * before.factor(run));
    freedom[run] += 1 - leverages[i];
  }
  // Bartlett's statistic with its correction
  double total = 0, sum = 0, logarithms = 0, inverses = 0, runs = 0;
  for (std::size_t k = 0; k < squares.size(); ++k) {
    if (!(freedom[k] >= kFewest && squares[k] > 0)) continue;
    total += freedom[k];
    sum += squares[k];
    logarithms += freedom[k] * std::log(squares[k] / freedom[k]);
    inverses += 1 / freedom[k];
    ++runs;
  }
  if (runs < 2) return {};
  const double statistic =
      (total * std::log(sum / total) - logarithms) / (1 + (inverses - 1 / total) / (3 * (runs - 1)));
  if (!(chi_squared_p_value(statistic, runs - 1) < kChance)) return {};
  // ln s^2 of each run has the variance 2/freedom; the excess over this is the spread of the runs.
  double mean = 0, spread = 0, noise = 0;
  for (std::size_t k = 0; k < squares.size(); ++k)
    if (freedom[k] >= kFewest && squares[k] > 0) mean += std::log(squares[k] / freedom[k]) / runs;
  for (std::size_t k = 0; k < squares.size(); ++k)
    if (freedom[k] >= kFewest && squares[k] > 0) {
      spread += square(std::log(squares[k] / freedom[k]) - mean) / (runs - 1);
      noise += 2 / freedom[k] / runs;
    }
  const double own = std::max(spread - noise, 0.0);
  std::vector<double> factors(squares.size(), 1.0);
  for (std::size_t k = 0; k < squares.size(); ++k)
    if (freedom[k] >= kFewest && squares[k] > 0)
      factors[k] = std::exp(0.5 * own / (own + 2 / freedom[k]) * (std::log(squares[k] / freedom[k]) - mean));
  return factors;
}

/// The four components in the order of the bits of `parts`.
std::array<double, 4> components_of(const ErrorModels& models) {
  const ErrorModel A = models.A.value_or(ErrorModel{}), T = models.T.value_or(ErrorModel{});
  return {square(A.constant), square(A.share), square(T.constant), square(T.share)};
}

}  // namespace

TwoProcesses processes_of(const Dataset& data, const PointIndices& used, std::span<const double> load_T,
                          std::span<const double> load_A) {
  TwoProcesses processes{std::vector<std::vector<std::size_t>>(data.curves.size()), {}, {}, {}};
  std::vector<std::size_t> passed(data.curves.size());
  std::vector<double> places(data.points.size());
  for (std::size_t i = 0; i < data.points.size(); ++i) places[i] = static_cast<double>(passed[data.points[i].curve]++);
  processes.places.reserve(used.size());
  for (std::size_t i = 0; i < used.size(); ++i) {
    processes.runs[data.points[used[i]].curve].push_back(i);
    processes.places.push_back(places[used[i]]);
  }
  processes.first.assign(load_A.begin(), load_A.end());
  processes.second.assign(load_T.begin(), load_T.end());
  return processes;
}

std::optional<ErrorModels> estimate_errors(const Dataset& data, const PointIndices& used, const NearestPlaces& nearest,
                                           std::span<const double> leverages, const AxisErrors& T, const AxisErrors& A,
                                           const ErrorModels& before, Stage stage,
                                           const std::vector<std::vector<double>>& own, bool may_correlate) {
  constexpr double kContradicted = 6;  // fall of ln L of the residuals when the differences of T are included
  ErrorModels models = before;
  const std::size_t pool = pool_of(used.size());
  constexpr std::size_t kFewest = 12;  // residuals needed to estimate a correlation
  constexpr double kScatter = 0.5;
  const bool choose = stage == Stage::weighting || stage == Stage::choosing, ends = stage == Stage::ending;
  ErrorModels independent = models;
  independent.correlations = {};
  const Deviations differences =
      T.known || ends ? Deviations(4) : differences_of_T(data, used, nearest, T.least, independent, pool);
  const ReadingsOfT readings = T.known || ends ? ReadingsOfT{} : readings_of_T(differences, models);
  const LimitedResiduals limited(data, used, nearest.residuals);
  std::optional<Deciding> made;
  const auto deciding = [&]() -> const Deciding& {
    if (!made) made = deciding_deviations(data, used, nearest, limited, own);
    return *made;
  };
  // Points that scatter far less than their stated errors say nothing about these errors.
  double squares = 0;
  for (const double r : nearest.residuals) squares += r * r;
  const bool scatter = !(T.known && A.known) || squares > kScatter * static_cast<double>(used.size());
  if (stage == Stage::choosing && may_correlate && scatter && used.size() >= kFewest) {
    const ChosenCorrelations chosen = choose_correlations(deciding().processes, deciding().deviations, [&](double rho) {
      return rho > 0 && readings.rows > 0 ? std::sqrt(readings.squares / readings.rows / kept(rho)) : 1.0;
    });
    models.correlations = chosen.correlations;
    models.log_likelihood = chosen.log_likelihood;
  }
  if (models.correlations.any() && !choose) {
    if (!ends) improve_correlated(deciding(), readings, T.known, A.known, models);
  } else if (!T.known || !A.known) {
    made.reset();
    const Deviations residuals = residual_rows(data, used, nearest, limited, leverages, T, A, models, pool);
    Deviations all = residuals;
    if (!T.known && (choose || before.differences))
      all.append(differences.size() > 0 && !models.correlations.any()
                     ? differences
                     : differences_of_T(data, used, nearest, T.least, models, pool));
    std::optional<VarianceComponents> found;
    models.differences = all.size() > residuals.size();
    if (choose) {
      const std::array<double, 4> last = components_of(before);
      const std::vector<std::uint32_t> every{(A.known ? 0u : kOfA) | (T.known ? 0u : kOfT)};
      const auto among = [&](bool may_be_exact) {
        return stage == Stage::weighting ? every : choices(T.known, A.known, may_be_exact);
      };
      std::optional<VarianceComponents> with;
      if (models.differences) with = choose_variances(all, among(false), last);
      // Where all parts together make the residuals hardly more likely, no choice of parts does.
      const auto most = with ? choose_variances(residuals, every, with->theta) : std::nullopt;
      const auto contradicts = [&](const VarianceComponents& without) {
        return !(without.log_likelihood - log_likelihood(residuals, with->theta) < kContradicted);
      };
      if (!most || contradicts(*most)) found = choose_variances(residuals, among(true), last);
      models.differences = with && !(found && contradicts(*found));
      if (models.differences) found = std::move(with);
    } else {
      found = fit_variances(all, before.parts, components_of(before));
    }
    if (!found) return std::nullopt;
    models.parts = 0;
    for (std::uint32_t k = 0; k < 4; ++k) models.parts |= (found->theta[k] > 0 ? 1u : 0u) << k;
    if (!A.known) models.A = {std::sqrt(found->theta[0]), std::sqrt(found->theta[1])};
    if (!T.known) models.T = {std::sqrt(found->theta[2]), std::sqrt(found->theta[3])};
  }
  // While parts are being chosen, factors could replace them, since areas of different runs differ.
  if (!choose && !T.known && !A.known) {
    if (models.correlations.any() || used.size() < kManyPoints) {
      std::vector<double> innovations;
      for (std::size_t i = 0; i < limited.size(); ++i) innovations.push_back(limited[i]);
      Decorrelation(processes_of(data, used, nearest.load_T, nearest.load_A), {models.correlations}).apply(innovations);
      models.run_factors = run_factors(data, used, innovations, leverages, before);
    } else {
      models.run_factors = run_factors(data, used, limited, leverages, before);
    }
  }
  const bool estimated = !(ends && models.correlations.any());
  const double larger = estimated ? std::sqrt(limited.inflation()) : 1;
  if (!T.known && models.T) *models.T = {models.T->constant * larger, models.T->share * larger};
  if (!A.known && models.A) *models.A = {models.A->constant * larger, models.A->share * larger};
  return models;
}

}  // namespace mixity
