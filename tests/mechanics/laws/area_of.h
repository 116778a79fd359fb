// What tests of laws share: models by their keys, their areas, and the comparison of two.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "mechanics/contact_model.h"

namespace mixity {

inline ContactModel model_of(const std::string& key) { return ContactModel::find(key).value(); }

/// NaN where `status` is not ok.
inline double area_of(const std::string& key, const std::vector<double>& p, double P, double T,
                      EquilibriumStatus& status) {
  double A = 0;
  model_of(key).areas_at(p, P, {&T, 1}, {&A, 1}, {&status, 1});
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
