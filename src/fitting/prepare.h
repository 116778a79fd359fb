// From a data set and options to the least-squares problem of one model: the points used, the parameters held and the
// constants fitted.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fitting/model_problem.h"
#include "fitting/result.h"
#include "fitting/stated_constants.h"
#include "mechanics/contact_model.h"

namespace mixity {

struct PreparedFit {
  ContactModel model;
  Objective objective;
  std::vector<std::size_t> used{};                       // indices into Dataset::points
  std::vector<Excluded> excluded{};                      // points this model cannot describe
  std::shared_ptr<const std::string> excluded_reason{};  // a text to which `excluded` refers
  ParameterValues base{};                                // held values, and typical ones for the rest
  std::vector<bool> held{};
  std::shared_ptr<StandardErrors> errors{};  // where the objective uses them; copies share them
  Constants constants{};                     // of which those that are not fitted count
  std::vector<FittedConstant> fitted{};      // the free ones first
  std::vector<double> start{};               // of the fitted ones, in the solver's numbers; empty: their means
};

/// The constants that a fit with these options fits: those that are free, then those that are uncertain.
std::vector<FittedConstant> fitted_constants(const Dataset& data, const FitOptions& options);

/// Why a point with loads has no predicted area.
inline constexpr std::string_view kBelowPullOff =
    "the load lies below the JKR pull-off load -3/2 pi R G_Ic, at which no model predicts an area";

/// `points`: indices of those to fit; null: all. Throws InputError where the options ask for what the data set does not
/// have, or hold a parameter outside its range.
PreparedFit prepare(const Dataset& data, const ContactModel& model, const FitOptions& options, Objective objective,
                    const std::vector<std::size_t>* points);

/// `weights`: of objective toughness, 1/standard error; empty: 1. The data set must outlive the problem, and stay where
/// it is.
std::unique_ptr<ModelProblem> make_problem(const Dataset& data, const FitOptions& options, const PreparedFit& prepared,
                                           std::vector<double> weights = {});

/// 1/standard error of ln f (or f) minus the model's with parameters p, at each point's psi. sigma_A and sigma_T act
/// through both f and psi; without loads the errors are the file's sigma_Gc. Throws InputError where a point has none.
std::vector<double> toughness_weights(const Dataset& data, const FitOptions& options, const PreparedFit& prepared,
                                      std::span<const double> p);

/// Starts of the fitted constants, from a JKR fit of the points without shear (T up to 1 % of the largest).
std::vector<double> jkr_start(const Dataset& data, const FitOptions& options, const PreparedFit& prepared);

/// A fit's values in the solver's numbers. Constants of the experiment that the fit does not have are at their starts;
/// empty if another value is missing.
std::vector<double> solver_values(const Problem& problem, const std::vector<FittedParameter>& fitted);

}  // namespace mixity
