// The paper's figures on one page: below each the equations that it stands on, and where the paper's print is wrong.
#pragma once

#include <string>
#include <vector>

#include "report/figures/drawn_figures.h"

namespace mixity {

/// `drawn`: the figures, in order; the page lies in their folder.
std::string paper_page(const std::vector<Figure>& figures, const DrawnFigures& drawn);

}  // namespace mixity
