// Turns a data set and options into the least-squares problem of one model: selects the points used, the parameters
// held and the constants fitted.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fitting/model_problem.h"
#include "fitting/point_indices.h"
#include "fitting/result.h"
#include "fitting/stated_constants.h"
#include "mechanics/contact_model.h"

namespace mixity {

struct PreparedFit {
  ContactModel model;
  Objective objective;
  PointIndices used{};
  std::vector<Excluded> excluded{};                      // points that this model cannot describe
  std::shared_ptr<const std::string> excluded_reason{};  // owns the text that `excluded` refers to
  ParameterValues base{};                                // held values; typical ones for the other parameters
  std::vector<bool> held{};
  double poisson_error = 0;  // of elliptic contacts: the stated standard error of Poisson's ratio; 0: held
  std::shared_ptr<StandardErrors> errors{};  // if the objective uses them; shared by copies
  Constants constants{};                     // only those that are not fitted are used
  std::vector<FittedConstant> fitted{};      // free ones first
  std::vector<double> start{};               // of the fitted constants, in the solver's numbers; empty: their means
};

/// The constants to fit with these options: free ones, then uncertain ones.
std::vector<FittedConstant> fitted_constants(const Dataset& data, const FitOptions& options);

/// The points' errors before a fit, as these options state them.
StandardErrors errors_before_fit(const Dataset& data, const FitOptions& options, Objective objective);

/// Why a point with loads has no predicted area.
inline constexpr std::string_view kBelowPullOff =
    "the load lies below the JKR pull-off load -3/2 pi R G_Ic, at which no model predicts an area";

inline constexpr std::string_view kBelowPullOffOfApproach =
    "the approach lies below that of JKR pull-off, at which no model predicts an area";

/// `points`: indices of the points to fit; null: all. Throws InputError if the options require what the data set lacks,
/// or hold a parameter outside its range.
PreparedFit prepare(const Dataset& data, const ContactModel& model, const FitOptions& options, Objective objective,
                    const std::vector<std::size_t>* points);

/// `weights`: 1/standard error, for objective toughness; empty: 1. The data set must outlive the problem and not move.
std::unique_ptr<ModelProblem> make_problem(const Dataset& data, const FitOptions& options, const PreparedFit& prepared,
                                           std::vector<double> weights = {});

/// 1/standard error of ln f (or f) minus the model's value for parameters p, at each point's psi. sigma_A and sigma_T
/// act on f and on psi; without loads the errors are the file's sigma_Gc. Throws InputError where a point has none.
std::vector<double> toughness_weights(const Dataset& data, const FitOptions& options, const PreparedFit& prepared,
                                      std::span<const double> p);

/// Start values of the fitted constants, from a JKR fit of the points without shear (T up to 1 % of the largest).
std::vector<double> jkr_start(const Dataset& data, const FitOptions& options, const PreparedFit& prepared);

/// A fit's values in the solver's numbers. Constants of the experiment that the fit lacks take their start values;
/// empty if another value is missing.
std::vector<double> solver_values(const Problem& problem, const std::vector<FittedParameter>& fitted);

}  // namespace mixity
