// NIST's sets for nonlinear regression: what the solver calls ok is what NIST certifies, from both of its starts.
#include <gtest/gtest.h>

#include <cstdio>
#include <functional>
#include <memory>

#include "many_digits.h"
#include "solver/nist_problems.h"
#include "solver/solve.h"

namespace mixity {
namespace nist_test {

using nist::Set;
using truth::Digits50;

struct Entry {
  const char* name;
  std::unique_ptr<Problem> (*problem)(const Set&, const std::vector<double>& start);
  Digits50 (*sum_of_squares)(const Set&);  // of the certified values
};

template <class Model>
Digits50 certified_sum(const Set& set) {
  const nist::Observations<Model, Digits50> data(set);
  const std::vector<Digits50> b(set.values.begin(), set.values.end());
  Digits50 sum = 0;
  for (std::size_t i = 0; i < data.y.size(); ++i) {
    const Digits50 r = Model::value(b.data(), data.x[i].data()) - data.y[i];
    sum += r * r;
  }
  return sum;
}

const auto kSets = nist::for_each_set([]<class Model>(nist::Of<Model>, const char* name) {
  return Entry{name, nist::make_problem<Model>, certified_sum<Model>};
});

/// Digits that agree with a certified number: its 11 at most.
double digits(double value, const std::string& certified) {
  const double error = relative_error(value, std::stod(certified));
  return error > 0 ? std::min(11.0, -std::log10(error)) : 11;
}

struct Agreement {
  double values = 11, standard_deviations = 11;

  Agreement(const Verdict& verdict, const Set& set) {
    for (std::size_t k = 0; k < set.values.size(); ++k) {
      values = std::min(values, digits(verdict.best.x[k], set.values[k]));
      standard_deviations =
          std::min(standard_deviations, digits(verdict.standard_errors[k].value(), set.standard_deviations[k]));
    }
  }
};

TEST(Nist, SumsOfSquaresFollowFromTheCertifiedValues) {
  for (const Entry& each : kSets) {
    const Set set(each.name);
    const Digits50 certified(set.sum_of_squares), sum = each.sum_of_squares(set);
    const auto error = static_cast<double>(abs(sum - certified) / certified);
    std::printf("%-9s %3zu points  %4.1f digits\n", each.name, set.y.size(), -std::log10(error));
    // The parameters of Lanczos1 have errors of 5e-11, so that their eleventh digit is worth more than its residuals.
    if (set.name == "Lanczos1") continue;
    EXPECT_LE(error, 1.1e-10) << each.name;  // 10 digits, half a unit of Lanczos2's eleventh beside
  }
}

class Nist : public ::testing::TestWithParam<Engine> {};

TEST_P(Nist, OkIsCertifiedFromBothStarts) {
  int solved = 0;
  std::printf("               values  standard deviations\n");
  for (const Entry& each : kSets) {
    const Set set(each.name);
    for (const std::size_t s : {0, 1}) {
      SCOPED_TRACE(set.name + ", start " + std::to_string(s + 1));
      const auto problem = each.problem(set, set.starts[s]);
      const Verdict verdict = solve(*problem, {.near = set.starts[s]}, {.engine = GetParam()});
      if (verdict.status != FitStatus::ok) {
        std::printf("%-9s %zu  %s: %s\n", each.name, s + 1, std::string(to_string(verdict.status)).c_str(),
                    verdict.message.c_str());
        continue;
      }
      ++solved;
      const Agreement agreement(verdict, set);
      std::printf("%-9s %zu    %5.1f  %5.1f\n", each.name, s + 1, agreement.values, agreement.standard_deviations);
      // NIST's eleven digits are right to at least 10.3 (from refining them in 60 digits).
      EXPECT_GE(agreement.values, 9);
      // Lanczos1's residuals are of 1e-13, to which rounding of data and model adds 1e-16: its scatter, and with it the
      // standard deviations, has three digits in double arithmetic.
      EXPECT_GE(agreement.standard_deviations, set.name == "Lanczos1" ? 2 : 9);
    }
  }
  std::printf("%d of 54 starts solved\n", solved);
  // Ceres runs off from BoxBOD's far start, which is told. The kernel's damping is simpler.
  EXPECT_GE(solved, GetParam() == Engine::ceres ? 53 : 48);
}

INSTANTIATE_TEST_SUITE_P(Engines, Nist, ::testing::Values(Engine::ceres, Engine::kernel),
                         [](const auto& of) { return of.param == Engine::ceres ? "Ceres" : "Kernel"; });

}  // namespace nist_test
}  // namespace mixity
