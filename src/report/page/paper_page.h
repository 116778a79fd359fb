// A page with the paper's figures. Below each one are its equations and the errors in the paper's print.
#pragma once

#include <string>
#include <vector>

#include "report/figures/drawn_figures.h"

namespace mixity {

/// `drawn`: the files of `figures`, in the same order; the page is in their folder.
std::string paper_page(const std::vector<Figure>& figures, const DrawnFigures& drawn);

}  // namespace mixity
