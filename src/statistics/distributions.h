// Probabilities and quantiles of the normal, Student's, chi-squared and F distributions. Boost's headers take seconds
// to compile: only distributions.cc includes them. Degrees of freedom are positive and need not be whole numbers.
#pragma once

namespace mixity {

/// Probability of a standard normal variable below z.
double normal_below(double z);
/// The z below which a standard normal variable lies with probability p, 0 < p < 1.
double normal_quantile(double p);

/// Two-sided p-value of t under Student's distribution; 1 if t is not a number.
double student_p_value(double t, double freedom);

/// Probability of a chi^2 this large or larger; 1 unless chi2 > 0.
double chi_squared_p_value(double chi2, double freedom);
/// The chi^2 exceeded with probability 1 - p, 0 <= p < 1; accurate to a few roundings.
double chi_squared_quantile(double p, double freedom);

/// Probability of an F this large or larger; 1 unless F > 0. `freedom`: of the numerator, `rest`: of the denominator.
double fisher_p_value(double F, double freedom, double rest);
/// The F exceeded with probability 1 - p, 0 <= p < 1; accurate to a few roundings.
double fisher_quantile(double p, double freedom, double rest);

}  // namespace mixity
