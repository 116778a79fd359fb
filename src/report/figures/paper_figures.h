// The figures of Papangelo & Ciavarella (2019) from the equations, with data if any are given.
#pragma once

#include <string>
#include <vector>

#include "dataset/dataset.h"
#include "report/figures/figure.h"

namespace mixity {

/// Figures 3 (f against psi), 4 (a against P at constant T, one panel per model), 5 (regimes), 6 (T, A and u of whole
/// equilibrium curves), 7, 8 (Mergel et al., one panel per model), 9 (Waters & Guduru) and 10. Dimensionless, as
/// printed. In 6, models a and b follow their own equations, not those of c. Data sets with loads and constants appear
/// in 7 and 8, those of (psi, G_c) in 9.
std::vector<Figure> paper_figures(const std::vector<Dataset>& data = {});

/// The equations of one of these figures and the errors in the paper's print, one a line. The paper's equation numbers
/// are not known here.
struct PaperNotes {
  std::vector<std::string> equations, print;
};
PaperNotes paper_notes(const std::string& figure_name);

}  // namespace mixity
