// From a data set and options to what one model fits: the points used, the parameters held, the constants fitted.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fitting/result.h"
#include "fitting/stated_constants.h"
#include "mechanics/contact_model.h"

namespace mixity {

struct PreparedFit {
  ContactModel model;
  Objective objective;
  std::vector<std::size_t> used{};                       // indices into Dataset::points
  std::vector<Excluded> excluded{};                      // points this model cannot describe
  std::shared_ptr<const std::string> excluded_reason{};  // a text that `excluded` refers to
  ParameterValues base{};                                // held values, and typical ones for the rest
  std::vector<bool> held{};
  std::optional<StandardErrors> errors{};  // where the objective uses them
  Constants constants{};                   // of those that are not fitted
  std::vector<FittedConstant> fitted{};    // the free ones first
  std::vector<double> start{};             // of these, in the solver's numbers; empty: their means
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

}  // namespace mixity
