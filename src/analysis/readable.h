// Numbers and names as a reader would have them.
#pragma once

#include <string>
#include <string_view>

#include "fitting/result.h"

namespace mixity {

/// MPa rather than Pa, by the size of the value; the drawn profile stays as it is.
FittedParameter readable(FittedParameter parameter);

/// "not converged".
std::string in_words(FitStatus status);

/// A parameter's letter, or its name: λ for "lambda".
std::string parameter_symbol(const std::string& name);

/// Foreign text without what gnuplot would take for markup.
std::string plain(std::string_view text);

}  // namespace mixity
