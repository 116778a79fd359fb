#include "dataset/peak_forces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/input_error.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace peak_forces_test {

PeakForces load(const std::string& csv, const std::string& toml = {}) {
  const TemporaryFolder folder;
  if (!toml.empty()) folder.write("peaks.toml", toml);
  return load_peak_forces(folder.write("peaks.csv", csv));
}

void expect_refused(const std::string& csv, const std::string& toml, const std::string& message) {
  try {
    load(csv, toml);
    ADD_FAILURE() << "accepted: " << csv;
  } catch (const InputError& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find(message), std::string::npos) << what;
  }
}

constexpr const char* kContact = "radius = \"2 mm\"\nmodulus = \"3 MPa\"\n";

TEST(PeakForces, BeyondTheRangeOfNumbersAreListed) {
  const PeakForces peaks = load("P,T_peak\n1e-300,1e300\n1,2\n");
  ASSERT_EQ(peaks.excluded.size(), 1u);
  EXPECT_EQ(peaks.excluded[0].reason, "the mean stress is out of range");
}

TEST(PeakForces, AreStressesOverTheAreaOfHertz) {
  const PeakForces peaks = load("P [mN],T_peak [mN],T_min [mN],note\n8,30,20,x\n-5.5,10,8,x\n3.5,,12,x\n", kContact);
  ASSERT_EQ(peaks.rows.size(), 2u);
  const double area = std::acos(-1.0) * std::pow(0.75 * 8e-3 * 2e-3 / 3e6, 2.0 / 3);
  EXPECT_NEAR(*peaks.rows[0].peak, 30e-3 / area / 1e3, 1e-12 * 30e-3 / area);
  EXPECT_NEAR(*peaks.rows[0].minimum, 20e-3 / area / 1e3, 1e-12 * 20e-3 / area);
  EXPECT_FALSE(peaks.rows[1].peak);
  EXPECT_EQ(peaks.rows[1].line, 4u);
  ASSERT_EQ(peaks.excluded.size(), 1u);
  EXPECT_EQ(peaks.excluded[0].line, 3u);
  EXPECT_EQ(peaks.excluded[0].reason, "P is not above 0: no area of Hertz");
}

TEST(PeakForces, MayBeDimensionless) {
  const PeakForces peaks = load("P,T_min\n2,7\n");
  EXPECT_NEAR(*peaks.rows[0].minimum, 7 / (std::acos(-1.0) * std::pow(1.5, 2.0 / 3)), 1e-12);
  EXPECT_EQ(peaks.stress_unit, "");
}

TEST(PeakForces, ThatCannotBeUsedAreRefusedWithTheirPlace) {
  expect_refused("", kContact, "peaks.csv:1:1: is empty");
  expect_refused("P,T_min\n", "", "peaks.csv:2:1: has a header but no data rows");
  expect_refused("P [mN],T [mN]\n1,2\n", kContact, "peaks.csv:1:1: column 'T_peak' or 'T_min' is missing");
  expect_refused("T_min [mN]\n1\n", kContact, "peaks.csv:1:1: column 'P' is missing");
  expect_refused("P [mN],T_min\n1,2\n", kContact, "peaks.csv:1:8: column 'T_min' and P are either both");
  expect_refused("P [mN],P [mN],T_min [mN]\n1,2,3\n", kContact, "peaks.csv:1:8: column 'P' stands twice");
  expect_refused("P [mN],T_min [mm]\n1,2\n", kContact, "peaks.csv:1:8: unit 'mm' of column 'T_min' does not fit");
  expect_refused("P [mN],T_min [mN]\n1,two\n", kContact, "peaks.csv:2:3: column 'T_min': 'two' is not a number");
  expect_refused("P [mN],T_min [mN]\n1\n", kContact, "peaks.csv:2:2: the row has 1 fields");
  expect_refused("P [mN],T_min [mN]\n1,2\n", "radius = \"2 mm\"\n", "needs modulus for the area of Hertz");
}

}  // namespace peak_forces_test
}  // namespace mixity
