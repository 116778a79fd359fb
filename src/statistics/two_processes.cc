#include "statistics/two_processes.h"

#include <cmath>

#include "base/vector_loops.h"

namespace mixity {
namespace {

constexpr std::size_t kColumns = 1 + kMostOwn;  // the deviations, then those of the runs
// One number for each trial. The compilers' own vectors: they do not make any of so long a chain of loops.
using Packed [[gnu::vector_size(sizeof(Trials))]] = double;

/// Kalman's filter of a run at several correlations (Harvey 1989, Forecasting, Structural Time Series Models and the
/// Kalman Filter, chapter 3). Columns pass it with the same gains.
struct Filters {
  Packed first_decay, second_decay, first_factor, second_factor;
  Packed p11, p12, p22;  // the covariance of u and v predicted from the deviations before
  Packed u[kColumns], v[kColumns];
  Packed products[kColumns][kColumns];  // sums over the run, of decorrelated columns
  Packed product, logarithm;            // of the variances of all runs
};

/// Away from the loops, whose registers it would take.
[[gnu::noinline]] void to_power(Packed& x, double exponent) {
  for (std::size_t t = 0; t < kTrials; ++t) x[t] = std::pow(x[t], exponent);
}

/// Replaces products of variances by their logarithms: a logarithm each would take longer than all the rest.
[[gnu::noinline]] void take_logarithms(Filters& f) {
  for (std::size_t t = 0; t < kTrials; ++t) f.logarithm[t] += std::log(f.product[t]);
  f.product = Packed{} + 1;
}

/// The same where a product becomes so small or large that kFactors more of them might leave the range of a double.
[[gnu::noinline]] void limit_products(Filters& f) {
  constexpr double kSmall = 1e-50;
  bool inside = true;
  for (std::size_t t = 0; t < kTrials; ++t) inside &= f.product[t] > kSmall && f.product[t] < 1 / kSmall;
  if (!inside) take_logarithms(f);
}
constexpr std::size_t kFactors = 8;  // of more than 1e-31

MIXITY_LOOP void begin_run(Filters& f) {
  f.p11 = f.p22 = Packed{} + 1;
  f.p12 = Packed{};
  for (std::size_t c = 0; c < kColumns; ++c) {
    f.u[c] = f.v[c] = Packed{};
    for (Packed& sum : f.products[c]) sum = Packed{};
  }
}

/// From one deviation of a run to the next.
template <std::size_t kUsed>
MIXITY_LOOP void decay(Filters& f, double apart) {
  Packed d1 = f.first_decay, d2 = f.second_decay;
  if (apart != 1) {
    to_power(d1, apart);
    to_power(d2, apart);
  }
  f.p11 = d1 * d1 * f.p11 + 1 - d1 * d1;
  f.p22 = d2 * d2 * f.p22 + 1 - d2 * d2;
  f.p12 *= d1 * d2;
  for (std::size_t c = 0; c < kUsed; ++c) {
    f.u[c] *= d1;
    f.v[c] *= d2;
  }
}

/// `values`: those of the columns at a deviation; `first`, `second`: its weights.
template <std::size_t kUsed>
MIXITY_LOOP void pass(Filters& f, const double* values, double first, double second) {
  const Packed l1 = f.first_factor * first, l2 = f.second_factor * second, u = f.p11 * l1 + f.p12 * l2,
               v = f.p12 * l1 + f.p22 * l2, variance = l1 * u + l2 * v, per_variance = 1 / variance,
               gain_1 = u * per_variance, gain_2 = v * per_variance;
  f.p11 -= u * gain_1;
  f.p12 -= u * gain_2;
  f.p22 -= v * gain_2;
  Packed innovations[kUsed];
  for (std::size_t c = 0; c < kUsed; ++c) {
    innovations[c] = values[c] - l1 * f.u[c] - l2 * f.v[c];
    f.u[c] += gain_1 * innovations[c];
    f.v[c] += gain_2 * innovations[c];
    for (std::size_t d = 0; d <= c; ++d) f.products[c][d] += innovations[c] * innovations[d] * per_variance;
  }
  f.product *= variance;
}

/// `kUsed`: how many columns there are.
template <std::size_t kUsed>
MIXITY_LOOP void pass_run(const TwoProcesses& processes, std::span<const double> deviations,
                          const std::vector<std::size_t>& run, Filters& filters) {
  Filters f = filters;
  begin_run(f);
  for (std::size_t k = 0; k < run.size(); ++k) {
    const std::size_t i = run[k];
    if (k > 0) decay<kUsed>(f, processes.places[i] - processes.places[run[k - 1]]);
    double values[kUsed];
    values[0] = deviations[i];
    for (std::size_t c = 1; c < kUsed; ++c) values[c] = processes.own[c - 1][i];
    pass<kUsed>(f, values, processes.first[i], processes.second[i]);
    if (k % kFactors == kFactors - 1) limit_products(f);
  }
  take_logarithms(f);
  filters = f;
}

/// Adds a run to the sums: what multiples of its columns explain is subtracted, one column after the other.
void add_run(const Filters& f, std::size_t columns, double n, Independent& sums) {
  constexpr double kNone = 1e-12;  // of a column's square: it depends on those before
  for (std::size_t t = 0; t < kTrials; ++t) {
    double left[kColumns][kColumns];
    for (std::size_t c = 0; c < columns; ++c)
      for (std::size_t d = 0; d <= c; ++d) left[c][d] = left[d][c] = f.products[c][d][t];
    sums.n[t] += n;
    for (std::size_t q = 1; q < columns; ++q) {
      const double square = left[q][q];
      if (!(square > kNone * f.products[q][q][t])) continue;
      for (std::size_t c = 0; c < columns; ++c)
        for (std::size_t d = 0; d < columns; ++d)
          if (c != q && d != q) left[c][d] -= left[c][q] * left[q][d] / square;
      sums.log_determinant[t] += std::log(square);
      --sums.n[t];
    }
    sums.squares[t] += left[0][0];
  }
}

}  // namespace

Independent independent(const TwoProcesses& processes, std::span<const double> deviations,
                        const std::array<ScaledCorrelations, kTrials>& trials) {
  const std::size_t columns = 1 + processes.own.size();
  Filters f;
  for (std::size_t t = 0; t < kTrials; ++t) {
    f.first_decay[t] = trials[t].correlations.first;
    f.second_decay[t] = trials[t].correlations.second;
    f.first_factor[t] = trials[t].first;
    f.second_factor[t] = trials[t].second;
  }
  f.product = Packed{} + 1;
  f.logarithm = Packed{};
  Independent sums{};
  for (const auto& run : processes.runs) {
    if (run.empty()) continue;
    in_vectors([&] {
      if (columns == 1) return pass_run<1>(processes, deviations, run, f);
      if (columns == 2) return pass_run<2>(processes, deviations, run, f);
      pass_run<3>(processes, deviations, run, f);
    });
    add_run(f, columns, static_cast<double>(run.size()), sums);
  }
  for (std::size_t t = 0; t < kTrials; ++t) sums.log_determinant[t] += f.logarithm[t];
  return sums;
}

}  // namespace mixity
