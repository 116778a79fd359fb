// What the tests of the whole curve share.
#pragma once

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "mechanics/base/law.h"

namespace mixity {

/// The tests of a suite must have one fixture, so files that share a suite share the type.
template <class Model>
class WholeCurve : public ::testing::Test {};

template <class Model>
std::string describe(const Parameters<Model>& p, double P, double phi) {
  std::ostringstream text;
  text.precision(17);
  text << Model::info.key << " p0=" << p[0] << " p1=" << (p.size() > 1 ? p[1] : 0) << " P=" << P << " phi=" << phi;
  return text.str();
}

}  // namespace mixity
