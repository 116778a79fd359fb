// The shape of contacts as an option of a fit: shape = "ellipse" in place of a constant of the data.
#pragma once

#include <string>
#include <string_view>

#include "analysis/request.h"

namespace mixity {

/// Whether this text of the constant `shape` means elliptic contacts; as a number, shape is a constant (constants.h).
bool means_ellipse(const std::string& text);

/// Removes shape = "ellipse" from the constants; whether it was there.
bool take_ellipse(Overrides& constants);

/// Why this text is no value of the constant; empty if it is one, as shape = "ellipse" is.
std::string problem_of_constant(std::string_view name, const std::string& text);

/// Where the constants say so, replaces each model by that of its law with elliptic contacts (elliptic_model.h), and
/// removes the statement. With equal couplings, by that with one coupling for both modes.
void take_shape(FitRequest& request);

}  // namespace mixity
