// Weights of the points under the objective `toughness`, for --weighted.
#pragma once

#include <optional>
#include <vector>

#include "fitting/options.h"
#include "mechanics/contact_model.h"

namespace mixity {

/// 1/standard error of ln f (or f) minus the model's at the point's psi: through f and psi at once, from sigma_A and
/// sigma_T, or from the file's sigma_Gc. Throws InputError where a point has no error.
///
/// `errors`: of T and A, where the data have loads. Indices `used` into Dataset::points.
std::vector<double> toughness_weights(const Dataset& data, Scale scale, const std::vector<std::size_t>& used,
                                      const std::optional<StandardErrors>& errors, const ContactModel& model,
                                      std::span<const double> p);

}  // namespace mixity
