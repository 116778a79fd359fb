#include "statistics/distributions.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace mixity {
namespace {

namespace bm = boost::math;

// Each interval needs a quantile. In long double it takes eight times as long, a sixth of a whole fit.
using InDouble = bm::policies::policy<bm::policies::promote_double<false>>;

}  // namespace

double normal_below(double z) { return cdf(bm::normal(), z); }
double normal_quantile(double p) { return quantile(bm::normal(), p); }

double student_p_value(double t, double freedom) { return 2 * cdf(bm::students_t(freedom), -std::abs(t)); }

double chi_squared_p_value(double chi2, double freedom) {
  return chi2 > 0 ? cdf(complement(bm::chi_squared(freedom), chi2)) : 1;
}
double chi_squared_quantile(double p, double freedom) {
  return quantile(bm::chi_squared_distribution<double, InDouble>(freedom), p);
}

double fisher_p_value(double F, double freedom, double rest) { return cdf(complement(bm::fisher_f(freedom, rest), F)); }
double fisher_quantile(double p, double freedom, double rest) {
  return quantile(bm::fisher_f_distribution<double, InDouble>(freedom, rest), p);
}

}  // namespace mixity
