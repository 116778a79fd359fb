// The figures of Papangelo & Ciavarella (2019) from the equations alone, without any data.
#pragma once

#include "report/figures/figure.h"

namespace mixity {

/// Figure 3 (f against psi), 4 (a against P at constant T, a panel for each model), 6 (T, A and u of whole equilibrium
/// curves), and the model curves of 7, 8 (Mergel et al.) and 9 (Waters & Guduru). Dimensionless, as printed there.
/// Models a and b follow their own equations in 6, not those of c. Figure 10 is not among them: the paper's constants
/// of that experiment are not known here.
std::vector<Figure> paper_figures();

}  // namespace mixity
