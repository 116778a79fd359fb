// Fits as text for a terminal, in the manner of lmfit's fit_report.
#pragma once

#include <string>

#include "analysis/result.h"

namespace mixity {

std::string to_text(const Analysis& result);

}  // namespace mixity
