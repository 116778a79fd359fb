// What tests of laws share: the area of a model by its key, and the same area of two.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "mechanics/contact_model.h"

namespace mixity {

/// NaN where `status` is not ok.
inline double area_of(const std::string& key, const std::vector<double>& p, double P, double T,
                      EquilibriumStatus& status) {
  double A = 0;
  std::vector<Values> parameters;
  for (const double& one : p) parameters.push_back({&one, 0});
  areas(key, parameters, {&P, 0}, {&T, 0}, {&A, 1}, {&status, 1});
  return A;
}

/// To 1e-12: psi is rounded, and a tangent of it magnifies that near 90 degrees.
inline void expect_same_area(const std::string& published, const std::string& other, const std::vector<double>& p,
                             double P, double T) {
  EquilibriumStatus status{}, other_status{};
  const double A = area_of(published, p, P, T, status), same = area_of(other, p, P, T, other_status);
  ASSERT_EQ(status, other_status) << other << ' ' << p[0] << " P " << P << " T " << T;
  if (status == EquilibriumStatus::ok) {
    EXPECT_NEAR(same, A, 1e-12 * A) << other << ' ' << p[0] << " P " << P << " T " << T;
  }
}

}  // namespace mixity
