// The curves of a fitted model in the user's units, for drawing.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "dataset/dataset.h"
#include "fitting/options.h"
#include "fitting/result.h"
#include "mechanics/contact_model.h"

namespace mixity {

struct DrawnPoint {
  double T, A, u;
  bool stable;  // under load control
  double P;     // the normal load
};

/// A place where the contact loses stability.
struct DrawnFold {
  Control::Kind control;
  double T, A, u;
  std::string jumps_to;
  double area_after;  // 0 off contact
};

/// An equilibrium curve from T = 0, with the folds reached on loading, under load and under displacement control. Empty
/// where there is no contact.
struct DrawnCurve {
  std::vector<DrawnPoint> points;
  std::vector<DrawnFold> folds;
};

/// A fit's curve at the normal load `load`, up to T_most (both as measured, dimensionless), accurate to 2e-4 of the
/// curve's size. The fit must have values. `sign_of_shear`: Dataset::sign_of_shear of the run.
DrawnCurve drawn_curve(const Dataset& data, const FitOptions& options, const FitResult& fit, double load, double T_most,
                       double sign_of_shear = 1);

/// States of the stable branch at a run's load from T = 0 to the instability, or to 1.2 times the largest measured T of
/// the run, denser towards the fold. T and A as measured, dimensionless; empty where there is no contact.
struct StableState {
  double T, A, psi, f;
  double q;  // ln(a/b), 0 for circles
};
std::vector<StableState> stable_states(const Dataset& data, const FitOptions& options, const FitResult& fit,
                                       std::size_t run, std::size_t points);

/// a/b of elliptic contacts along a run from T = 0 to the end of the stable branch, or to the largest measured T; T as
/// measured, dimensionless. Empty for circles, and where there is no contact.
std::vector<std::pair<double, double>> drawn_axes(const Dataset& data, const FitOptions& options, const FitResult& fit,
                                                  std::size_t run, std::size_t points = 100);

/// Pull-off loads at shears from 0 to `most`, both as they would be read, dimensionless.
std::vector<std::pair<double, double>> drawn_pull_off(const Dataset& data, const FitOptions& options,
                                                      const FitResult& fit, HeldShear held, double most,
                                                      std::size_t points = 101);

/// Contact radius a(P) at a tangential load T (as measured, dimensionless) for loads up to P_most: the stable and the
/// unstable part, which meet at pull-off.
struct DrawnRadii {
  std::vector<std::pair<double, double>> stable, unstable;
};
DrawnRadii drawn_radii(const Dataset& data, const FitOptions& options, const FitResult& fit, double T, double P_most,
                       std::size_t points = 400);

/// f(psi) at equal steps of psi from 0 to last_psi, limited to `most`, a number outside the frame.
std::vector<std::pair<double, double>> toughness_curve(const ContactModel& model, std::span<const double> p,
                                                       double last_psi, double most, std::size_t steps);
/// The same for a fit.
std::vector<std::pair<double, double>> drawn_toughness(const Dataset& data, const FitResult& fit, double last_psi,
                                                       double most, std::size_t steps = 300);

/// The fit with its first free parameter at one end of the interval; null if that end is open.
std::optional<FitResult> at_interval_end(const FitResult& fit, bool high);

/// The fits whose parameters all have values.
std::vector<const FitResult*> fits_with_values(const std::vector<FitResult>& all);

/// The largest modulus of T, dimensionless.
double largest_shear(const Dataset& data);

/// The stated shear strength, dimensionless; null if there is none, or no contact to scale it by.
std::optional<double> stated_strength(const Dataset& data);

/// The first parameter of the fit that was not held; null if there is none.
const FittedParameter* leading_parameter(const FitResult& fit);

}  // namespace mixity
