// Numbers and names in the form that readers expect.
#pragma once

#include <string>
#include <string_view>

#include "fitting/result.h"

namespace mixity {

/// The parameter in a unit that suits its value: MPa rather than Pa.
FittedParameter readable(FittedParameter parameter);

/// "not converged" for not_converged.
std::string in_words(FitStatus status);

/// A parameter's letter, or its name: λ for "lambda".
std::string parameter_symbol(const std::string& name);
/// The same in a sentence, without the signs of figures: λ_II.
std::string parameter_in_text(const std::string& name);

/// Escapes characters that gnuplot would read as markup.
std::string plain(std::string_view text);

}  // namespace mixity
