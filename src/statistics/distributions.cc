#include "statistics/distributions.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace mixity {
namespace {

namespace bm = boost::math;

// Each interval needs a quantile, and each constant a p-value. In long double one takes eight times as long.
using InDouble = bm::policies::policy<bm::policies::promote_double<false>>;

}  // namespace

double normal_below(double z) { return cdf(bm::normal(), z); }
double normal_quantile(double p) { return quantile(bm::normal(), p); }

double student_p_value(double t, double freedom) {
  constexpr double kSmall = 0.1;  // from there on doubles give it to 1e-13
  if (std::isnan(t)) return 1;
  if (std::isinf(t)) return 0;
  const double below = -std::abs(t);
  return 2 * (below > -kSmall ? cdf(bm::students_t(freedom), below)
                              : cdf(bm::students_t_distribution<double, InDouble>(freedom), below));
}

double chi_squared_p_value(double chi2, double freedom) {
  if (!(chi2 > 0)) return 1;
  if (std::isinf(chi2)) return 0;
  // Below the mean, Chernoff's bound on 1 - p. Boost's series (1.74) overflows for a tiny chi^2 with more than about
  // 3,510 degrees of freedom.
  constexpr double kRounding = -40;  // ln
  const double ratio = chi2 / freedom;
  if (ratio < 1 && 0.5 * freedom * (1 - ratio + std::log(ratio)) < kRounding) return 1;
  return cdf(complement(bm::chi_squared(freedom), chi2));
}
double chi_squared_quantile(double p, double freedom) {
  return quantile(bm::chi_squared_distribution<double, InDouble>(freedom), p);
}

double fisher_p_value(double F, double freedom, double rest) {
  if (!(F > 0)) return 1;
  return std::isinf(F) ? 0 : cdf(complement(bm::fisher_f(freedom, rest), F));
}
double fisher_quantile(double p, double freedom, double rest) {
  return quantile(bm::fisher_f_distribution<double, InDouble>(freedom, rest), p);
}

}  // namespace mixity
