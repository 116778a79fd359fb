#include "statistics/noise.h"

#include "statistics/readings.h"

namespace mixity {

double noise_of(const std::vector<double>& values) {
  constexpr std::size_t kFew = 12;
  if (values.size() < kFew) return 0;
  std::vector<double> bends;
  for (std::size_t i = 2; i < values.size(); ++i)
    bends.push_back(std::abs(values[i] - 2 * values[i - 1] + values[i - 2]));
  return kOfMedian * median(bends) / std::sqrt(6.0);
}

std::size_t remove_spikes(std::vector<double>& values) {
  constexpr double kSpike = 6;  // standard deviations; not reached by any of a million readings of noise
  const double noise = noise_of(values);
  if (!(noise > 0)) return 0;
  std::size_t removed = 0;
  const std::vector<double> read = values;
  for (std::size_t i = 2; i + 2 < read.size(); ++i) {
    if (std::abs(read[i] - read[i - 1]) <= kSpike * noise || std::abs(read[i] - read[i + 1]) <= kSpike * noise)
      continue;
    const double middle = median(part_of(read, i - 2, i + 3));
    if (!(std::abs(read[i] - middle) > kSpike * noise)) continue;
    values[i] = middle;
    ++removed;
  }
  return removed;
}

NoiseModel noise_model(const std::vector<std::vector<double>>& courses, double otherwise) {
  constexpr double kJump = 25;  // times the variance
  constexpr std::size_t kFew = 30;
  constexpr int kRounds = 6;
  std::vector<double> squares, size, noises;
  for (const std::vector<double>& y : courses) {
    for (std::size_t i = 2; i < y.size(); ++i) {
      squares.push_back(std::pow(y[i] - 2 * y[i - 1] + y[i - 2], 2) / 6);
      size.push_back(y[i - 1] * y[i - 1]);
    }
    if (const double noise = noise_of(y); noise > 0) noises.push_back(noise);
  }
  NoiseModel model{otherwise * otherwise, 0};
  if (squares.size() < kFew || noises.empty()) return model;
  model.constant = std::pow(median(noises), 2);
  for (int round = 0; round < kRounds; ++round) {
    double n = 0, x = 0, xx = 0, y = 0, xy = 0;  // weighted: the variance of a square is proportional to its square
    for (std::size_t i = 0; i < squares.size(); ++i) {
      const double expected = std::pow(model.at(std::sqrt(size[i])), 2);
      if (!(expected > 0) || squares[i] > kJump * expected) continue;
      const double w = 1 / (expected * expected);
      n += w;
      x += w * size[i];
      xx += w * size[i] * size[i];
      y += w * squares[i];
      xy += w * size[i] * squares[i];
    }
    const double spread = n * xx - x * x;
    double slope = spread > 1e-12 * n * xx ? (n * xy - x * y) / spread : 0;
    double level = (y - slope * x) / n;
    if (slope < 0) {
      slope = 0;
      level = y / n;
    } else if (level < 0) {
      level = 0;
      slope = xy / xx;
    }
    model = {level, std::sqrt(slope)};
  }
  return model;
}

}  // namespace mixity
