// The time at which a course breaks, as a distribution over times between its readings.
#pragma once

#include <cstddef>
#include <vector>

namespace mixity {

/// A polynomial before the break, and after it a line or another curve, which may begin at the polynomial's end or
/// elsewhere.
struct BreakShape {
  std::size_t least_degree = 1, most_degree = 3;  // before the break
  bool bends = false;                             // after the break: a power 2/3 to 3/2 of the time, or a parabola
  // After the break: where the line turns again; 0: nowhere. A jump may be anywhere between the break and the knee.
  double knee = 0;
  bool may_be_none = true;  // the polynomial may also continue without a break
};

/// Probabilities at the times `begin` + k `step`; their sum is 1.
struct TimeDensity {
  double begin = 0, step = 0;
  std::vector<double> p;

  double time(std::size_t k) const { return begin + static_cast<double>(k) * step; }
};

/// The time of the break within first..last, with equal prior probabilities. The forms that a shape allows are averaged
/// with their probabilities by BIC (Schwarz 1978, Ann. Stat. 6, 461). `noise`: standard deviation of a reading,
/// replaced by the residuals of the best form if these are larger. Empty if there are too few readings.
TimeDensity break_times(const std::vector<double>& time, const std::vector<double>& values, double noise, double first,
                        double last, double step, const BreakShape& shape);

/// A discretised normal distribution.
TimeDensity normal_times(double mean, double deviation, double step);

/// Adds the distribution of the difference `later` - `earlier` to `onto`, at its times. The part outside these is lost
/// from the sum.
void add_differences(const TimeDensity& earlier, const TimeDensity& later, TimeDensity& onto);

struct MeanAndDeviation {
  double mean = 0, deviation = 0;
};
MeanAndDeviation moments(const TimeDensity& density);
/// The time below which this fraction of the probability lies.
double quantile(const TimeDensity& density, double share);

}  // namespace mixity
