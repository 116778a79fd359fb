#include "statistics/break_times.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mixity {
namespace {

using Columns = std::vector<std::vector<double>>;

/// The sum of squares of y that remains after least squares, by modified Gram-Schmidt. Skips columns that others
/// contain.
double squares_left(Columns& columns, std::vector<double> y) {
  const auto dot = [](const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
  };
  const auto take_off = [&](const std::vector<double>& of, double share, std::vector<double>& from) {
    for (std::size_t i = 0; i < from.size(); ++i) from[i] -= share * of[i];
  };
  for (std::size_t k = 0; k < columns.size(); ++k) {
    std::vector<double>& column = columns[k];
    const double whole = dot(column, column);
    for (std::size_t j = 0; j < k; ++j) take_off(columns[j], dot(columns[j], column), column);
    const double left = dot(column, column);
    const bool new_one = left > 1e-12 * whole;
    for (double& one : column) one *= new_one ? 1 / std::sqrt(left) : 0;
    take_off(column, dot(column, y), y);
  }
  return dot(y, y);
}

/// One of the forms of a shape: a sum of powers of the time u after the break, or a line that turns at a knee.
struct Form {
  std::size_t degree;
  std::vector<double> powers;  // of u; empty: no break
  bool jumps = false, turns = false;

  bool breaks() const { return !powers.empty(); }
  std::size_t parameters() const { return 1 + degree + powers.size() + jumps + turns + breaks(); }
  std::size_t columns() const { return 1 + degree + powers.size() + jumps + turns; }
};

std::vector<Form> forms_of(const BreakShape& shape) {
  std::vector<std::vector<double>> courses{{1}};
  if (shape.bends) courses = {{0.5}, {2.0 / 3}, {5.0 / 6}, {1}, {7.0 / 6}, {4.0 / 3}, {1.5}, {1, 1.5}, {1, 2}};
  std::vector<Form> forms;
  for (std::size_t degree = shape.least_degree; degree <= shape.most_degree; ++degree) {
    if (shape.may_be_none) forms.push_back({degree, {}});
    for (const auto& powers : courses) {
      forms.push_back({degree, powers});
      forms.push_back({degree, powers, true});
    }
    if (shape.knee > 0) forms.push_back({degree, {1}, false, true});
  }
  return forms;
}

double power(double u, double exponent) { return exponent == 1 ? u : exponent == 2 ? u * u : std::pow(u, exponent); }

class Breaks {
 public:
  Breaks(const std::vector<double>& time, const std::vector<double>& values, const BreakShape& shape)
      : time_(time), values_(values), shape_(shape), length_(time.back() - time.front()) {}

  /// The number of readings up to this time.
  std::ptrdiff_t before(double at) const { return std::upper_bound(time_.begin(), time_.end(), at) - time_.begin(); }

  double squares(const Form& form, double at) {
    const double knee = shape_.knee / length_;
    columns_.resize(form.columns(), std::vector<double>(time_.size()));
    for (std::size_t i = 0; i < time_.size(); ++i) {
      const double u = (time_[i] - at) / length_;
      const bool behind = form.breaks() && u > 0;
      std::size_t k = 0;
      columns_[k++][i] = 1;
      double before = behind ? 0 : 1;
      for (std::size_t degree = 1; degree <= form.degree; ++degree) columns_[k++][i] = before *= u;
      for (const double exponent : form.powers)
        columns_[k++][i] = !behind ? 0 : form.turns ? std::max(u - knee, 0.0) : power(u, exponent);
      if (form.turns) columns_[k++][i] = behind ? std::min(u, knee) : 0;
      if (form.jumps) columns_[k++][i] = behind;
    }
    return squares_left(columns_, values_);
  }

 private:
  const std::vector<double>&time_, &values_;
  const BreakShape& shape_;
  double length_;
  Columns columns_;
};

}  // namespace

TimeDensity break_times(const std::vector<double>& time, const std::vector<double>& values, double noise, double first,
                        double last, double step, const BreakShape& shape) {
  TimeDensity density{first, step, {}};
  const std::vector<Form> forms = forms_of(shape);
  const double n = static_cast<double>(time.size());
  const auto spare = [&](const Form& form) { return n - static_cast<double>(form.parameters()) - 1; };
  if (!(last > first) || !(spare(forms.front()) > 0)) return density;
  Breaks breaks(time, values, shape);
  const auto count = static_cast<std::size_t>((last - first) / step) + 1;
  std::vector<std::vector<double>> squares;
  double variance = std::numeric_limits<double>::infinity();
  for (const Form& form : forms) {
    squares.emplace_back();
    if (!(spare(form) > 0)) continue;
    for (std::size_t k = 0; k < (form.breaks() ? count : 1); ++k)
      // between two readings, a course in two unconnected parts is the same
      if (k > 0 && form.jumps && breaks.before(density.time(k)) == breaks.before(density.time(k - 1)))
        squares.back().push_back(squares.back().back());
      else
        squares.back().push_back(breaks.squares(form, density.time(k)));
    variance = std::min(variance, *std::min_element(squares.back().begin(), squares.back().end()) / spare(form));
  }
  variance = std::max(variance, noise * noise);
  if (!(variance > 0)) return density;
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < forms.size(); ++f)
    for (double& one : squares[f]) {
      one = -one / (2 * variance) - static_cast<double>(forms[f].parameters()) / 2 * std::log(n);
      most = std::max(most, one);
    }
  density.p.assign(count, 0);
  const auto knee = static_cast<std::size_t>(shape.knee / step);
  double sum = 0;
  for (std::size_t f = 0; f < forms.size(); ++f) {
    const auto& likelihoods = squares[f];
    // a jump is at any time up to the knee
    const std::size_t earlier = forms[f].jumps ? knee : 0;
    for (std::size_t k = 0; k < count && !likelihoods.empty(); ++k) {
      const double likely = std::exp(likelihoods[likelihoods.size() == 1 ? 0 : k] - most);
      sum += likely;
      for (std::size_t i = 0; i <= std::min(earlier, k); ++i)
        density.p[k - i] += likely / static_cast<double>(earlier + 1);
    }
  }
  for (double& one : density.p) one /= sum;
  return density;
}

TimeDensity normal_times(double mean, double deviation, double step) {
  constexpr double kWidth = 4;
  const auto half = static_cast<std::ptrdiff_t>(kWidth * deviation / step);
  TimeDensity density{mean - static_cast<double>(half) * step, step, {}};
  double sum = 0;
  for (std::ptrdiff_t k = -half; k <= half; ++k) {
    const double z = static_cast<double>(k) * step / std::max(deviation, step / kWidth);
    density.p.push_back(std::exp(-z * z / 2));
    sum += density.p.back();
  }
  for (double& one : density.p) one /= sum;
  return density;
}

void add_differences(const TimeDensity& earlier, const TimeDensity& later, TimeDensity& onto) {
  constexpr double kNothing = 1e-12;
  for (std::size_t i = 0; i < earlier.p.size(); ++i)
    for (std::size_t j = 0; j < later.p.size() && earlier.p[i] > kNothing; ++j) {
      const double k = (later.time(j) - earlier.time(i) - onto.begin) / onto.step + 0.5;
      if (k >= 0 && k < static_cast<double>(onto.p.size()))
        onto.p[static_cast<std::size_t>(k)] += earlier.p[i] * later.p[j];
    }
}

MeanAndDeviation moments(const TimeDensity& density) {
  double sum = 0, mean = 0, square = 0;
  for (std::size_t k = 0; k < density.p.size(); ++k) {
    sum += density.p[k];
    mean += density.p[k] * density.time(k);
  }
  mean /= sum;
  for (std::size_t k = 0; k < density.p.size(); ++k) square += density.p[k] * std::pow(density.time(k) - mean, 2);
  return {mean, std::sqrt(square / sum)};
}

double quantile(const TimeDensity& density, double share) {
  double sum = 0, below = 0;
  for (const double one : density.p) sum += one;
  for (std::size_t k = 0; k < density.p.size(); ++k) {
    const double next = below + density.p[k] / sum;
    // each time represents the step around it
    if (next >= share) return density.time(k) + density.step * ((share - below) / (next - below) - 0.5);
    below = next;
  }
  return density.time(density.p.size() - 1);
}

}  // namespace mixity
