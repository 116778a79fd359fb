// The figures of Papangelo & Ciavarella (2019) from the equations, and with data where these are given.
#pragma once

#include <string>
#include <vector>

#include "dataset/dataset.h"
#include "report/figures/figure.h"

namespace mixity {

/// Figure 3 (f against psi), 4 (a against P at constant T, a panel for each model), 5 (what becomes of a contact), 6
/// (T, A and u of whole equilibrium curves), 7, 8 (Mergel et al., a panel for each model), 9 (Waters & Guduru) and 10.
/// Dimensionless, as printed there. Models a and b follow their own equations in 6, not those of c. Points of data sets
/// with loads and constants appear in 7 and 8, those of (psi, G_c) in 9.
std::vector<Figure> paper_figures(const std::vector<Dataset>& data = {});

/// The equations of one of these figures and where the paper's print is wrong, one a line. The paper's numbers of
/// equations are not known here.
struct PaperNotes {
  std::vector<std::string> equations, print;
};
PaperNotes paper_notes(const std::string& figure_name);

}  // namespace mixity
