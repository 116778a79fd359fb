// The paper's figures on one page. Below each figure are its equations and the errors of the paper's print.
#pragma once

#include <string>
#include <vector>

#include "report/figures/drawn_figures.h"

namespace mixity {

/// `drawn`: the figures, in order; the page lies in their folder.
std::string paper_page(const std::vector<Figure>& figures, const DrawnFigures& drawn);

}  // namespace mixity
