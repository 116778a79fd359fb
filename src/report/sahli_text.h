// The parabolas A = A0 - alpha T^2 fitted to a data set, as text and CSV, in the units of the file.
#pragma once

#include <string>

#include "fitting/sahli.h"

namespace mixity {

/// `predicted_by`: model and parameters of the prediction; empty: none.
std::string sahli_text(const Dataset& data, const SahliResult& result, const std::string& predicted_by,
                       Wording words = in_neutral_words);

/// Header: provenance,curve,P,points,A0,A0_stderr,alpha,alpha_stderr,alpha_predicted, with units.
std::string sahli_csv(const Dataset& data, const SahliResult& result);

}  // namespace mixity
