// Sentences of the program as a page shows them.
#pragma once

#include <string>
#include <string_view>

namespace mixity {

/// Markup of a text with the letters of figures: λ<sub>II</sub> for lambda_II, ψ for psi, ² for ^2, ± for +/-. What
/// stands in double quotes, and options such as --free=lambda, stay as they are typed.
std::string sentence(std::string_view text);

}  // namespace mixity
