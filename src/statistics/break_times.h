// When a course breaks: a distribution over times between its readings.
#pragma once

#include <cstddef>
#include <vector>

namespace mixity {

/// A polynomial before the break; behind it a line or another course, which begins where the polynomial ends or
/// elsewhere.
struct BreakShape {
  std::size_t least_degree = 1, most_degree = 3;  // before the break
  bool bends = false;                             // behind the break: powers 2/3, 1 and 3/2 of the time, or a parabola
  double knee = 0;                                // behind the break: where the line turns again; 0: nowhere
  bool may_be_none = true;                        // the polynomial may go on instead
};

/// Probabilities, with a sum of 1, on times `begin` + k `step`.
struct TimeDensity {
  double begin = 0, step = 0;
  std::vector<double> p;

  double time(std::size_t k) const { return begin + static_cast<double>(k) * step; }
};

/// The time of the break within first..last, all times being equally likely beforehand. The forms that a shape allows
/// are averaged with their probabilities by BIC (Schwarz 1978, Ann. Stat. 6, 461). `noise`: standard deviation of a
/// reading; the residuals of the best form replace it if they are larger. Empty for too few readings.
TimeDensity break_times(const std::vector<double>& time, const std::vector<double>& values, double noise, double first,
                        double last, double step, const BreakShape& shape);

/// A normal distribution.
TimeDensity normal_times(double mean, double deviation, double step);

/// How probable each difference `later` - `earlier` is, on the times of `onto`, which gets the result. The sum is less
/// than 1 by what lies outside.
void add_differences(const TimeDensity& earlier, const TimeDensity& later, TimeDensity& onto);

struct MeanAndDeviation {
  double mean = 0, deviation = 0;
};
MeanAndDeviation moments(const TimeDensity& density);
/// The time before which this share of the probability lies.
double quantile(const TimeDensity& density, double share);

}  // namespace mixity
