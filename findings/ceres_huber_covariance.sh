#!/bin/sh
# Ceres 2.1.0 (Debian 12): the covariance of a fit under Huber's loss, apply_loss_function being true, its default.
#
# What we guessed: it is the inverse of the second derivative of half the cost, to which a point beyond the loss's scale adds
# nothing, since the loss is a straight line there.
# What we saw: a point that is off by q times the scale counts as 1/q of a plain one, because the corrector leaves out the loss's
# second derivative where it is negative. For a mean of 19 normal readings and one at ten scales the variance is 0.053; the
# curvature says 0.062, the sandwich of curvature and scores 0.056. Where only points that are off fix the parameter, one at ten
# scales below and one above, Ceres says 5, ten times plain least squares, while the curvature is 0: every value between them has
# the same cost, and nothing is said.
# What we do: src/solver/robust.h gives the second derivative of the loss beside its residuals, 0 beyond the scale, and
# src/solver/covariance.cc takes no covariance of Ceres.
set -eu
version=2.1.0+really2.1.0+dfsg-1
[ "$(dpkg-query -W -f '${Version}' libceres-dev)" = "$version" ] || { echo "needs libceres-dev $version" >&2; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat >huber.cc <<'CODE'
#include <ceres/ceres.h>
#include <cmath>
#include <cstdio>
#include <vector>
constexpr double kScale = 1.345;
struct Offset {
  double y;
  template <class T>
  bool operator()(const T* mean, T* residual) const {
    residual[0] = y - mean[0];
    return true;
  }
};
// Minimum and variance by Ceres; variances from the second derivative of half the cost and from the sandwich, by hand.
void fit(const char* name, const std::vector<double>& ys) {
  ceres::Problem problem;
  double mean = 0.01;
  for (const double y : ys)
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<Offset, 1, 1>(new Offset{y}), new ceres::HuberLoss(kScale), &mean);
  ceres::Solver::Options options;
  options.function_tolerance = options.gradient_tolerance = options.parameter_tolerance = 1e-14;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  ceres::Covariance covariance({});
  const std::vector<std::pair<const double*, const double*>> wanted = {{&mean, &mean}};
  const bool computed = covariance.Compute(wanted, &problem);
  double by_ceres = 0, curvature = 0, scores = 0;
  covariance.GetCovarianceBlock(&mean, &mean, &by_ceres);
  for (const double y : ys) {
    const double r = std::fmin(std::fabs(y - mean), kScale);
    curvature += r < kScale;
    scores += r * r;
  }
  std::printf("%s: %s; variance by Ceres %.4f, curvature %.4f, sandwich %.4f, without a loss %.4f\n", name,
              summary.IsSolutionUsable() && computed ? "a solution with a covariance" : "none", by_ceres, 1 / curvature,
              scores / (curvature * curvature), 1.0 / ys.size());
}
int main() {
  std::vector<double> ys = {0};  // quantiles of the normal distribution at 1/20, ..., 19/20
  for (const double y : {0.1257, 0.2533, 0.3853, 0.5244, 0.6745, 0.8416, 1.0364, 1.2816, 1.6449}) ys.insert(ys.end(), {-y, y});
  ys.push_back(10 * kScale);
  fit("19 readings and one off", ys);
  fit("two readings, both off", {-10 * kScale, 10 * kScale});
}
CODE
g++ -std=c++17 -O1 -isystem /usr/include/eigen3 huber.cc -o huber -lceres -lglog
./huber >seen
cat seen
cat >wanted <<'TEXT'
19 readings and one off: a solution with a covariance; variance by Ceres 0.0534, curvature 0.0625, sandwich 0.0557, without a loss 0.0500
two readings, both off: a solution with a covariance; variance by Ceres 5.0000, curvature inf, sandwich inf, without a loss 0.5000
TEXT
cmp seen wanted
