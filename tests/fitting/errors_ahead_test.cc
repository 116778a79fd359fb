// Rounds that come nearer to their end by a constant factor, or swing about it, end after a few.
#include "fitting/errors_ahead.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace mixity {
namespace errors_ahead_test {

ErrorModels sized(double constant, double share, double correlation = 0) {
  ErrorModels models;
  models.A = {constant, share};
  models.correlations.first = correlation;
  return models;
}

/// What a round finds, whose logarithms are off by `factor` times what they were.
ErrorModels round_of(const ErrorModels& from, const ErrorModels& end, double factor) {
  const auto nearer = [&](double x, double to) { return x > 0 ? to * std::pow(x / to, factor) : 0; };
  return sized(nearer(from.A->constant, end.A->constant), nearer(from.A->share, end.A->share), from.correlations.first);
}

/// How far the sizes are off after some rounds.
double off_after(int rounds, double factor) {
  const ErrorModels end = sized(0.3, 0.01);
  ErrorModels now = sized(0.6, 0.03);
  ErrorsAhead ahead;
  for (int k = 0; k < rounds; ++k) now = ahead.next(now, round_of(now, end, factor));
  return std::max(std::abs(std::log(now.A->constant / 0.3)), std::abs(std::log(now.A->share / 0.01)));
}

TEST(ErrorsAhead, OfRoundsThatConvergeLinearlyAreTheirEnd) {
  EXPECT_LT(off_after(2, 0.5), 1e-12);  // rounding; two plain rounds leave 0.27
  EXPECT_LT(off_after(2, 0.85), 1e-12);
}

TEST(ErrorsAhead, OfRoundsThatSwingAreBetweenThem) { EXPECT_LT(off_after(2, -1), 1e-12); }

/// A step of twenty times the last change is far from anything that was tried.
TEST(ErrorsAhead, OfRoundsThatHardlyConvergeAreNotBelieved) {
  const ErrorModels from = sized(0.6, 0.03), end = sized(0.3, 0.01);
  ErrorsAhead ahead;
  const ErrorModels first = ahead.next(from, round_of(from, end, 0.95)), found = round_of(first, end, 0.95);
  EXPECT_EQ(ahead.next(first, found).A->constant, found.A->constant);
}

TEST(ErrorsAhead, AreThoseFoundWhereAPartVanishes) {
  ErrorsAhead ahead;
  ErrorModels now = sized(0.6, 0.03);
  now = ahead.next(now, sized(0.5, 0.02));
  const ErrorModels left = ahead.next(now, sized(0, 0.018));
  EXPECT_EQ(left.A->constant, 0);
  EXPECT_EQ(left.A->share, 0.018);
  const ErrorModels next = ahead.next(left, sized(0, 0.017));
  EXPECT_EQ(next.A->constant, 0);
  EXPECT_DOUBLE_EQ(next.A->share, 0.017);  // nothing is known of rounds with this part alone
}

/// Each change is larger than the last: what they lead away from is before the first.
TEST(ErrorsAhead, OfRoundsThatLeadAwayAreThoseFound) {
  ErrorsAhead ahead;
  const ErrorModels now = ahead.next(sized(0.3, 0, 0.5), sized(0.3, 0, 0.8));
  EXPECT_DOUBLE_EQ(ahead.next(now, sized(0.3, 0, 0.95)).correlations.first, 0.95);
}

TEST(ErrorsAhead, CorrelationsStayBelowOne) {
  ErrorsAhead ahead;
  const ErrorModels now = ahead.next(sized(0.3, 0, 0.1), sized(0.3, 0, 0.9));
  const double next = ahead.next(now, sized(0.3, 0, 0.97)).correlations.first;
  EXPECT_GT(next, 0.97);
  EXPECT_LT(next, 1);
}

}  // namespace errors_ahead_test
}  // namespace mixity
