// Internal to the paper's figures; other code uses paper_figures.h.
#pragma once

#include <string>
#include <vector>

#include "dataset/dataset.h"
#include "report/figures/figure.h"

namespace mixity {

/// Axis labels of the paper's dimensionless quantities, written out.
inline const std::string kPaperT = "T/(R G_{Ic})", kPaperA = "A ξ^2/R^2";
inline constexpr double kMergelLambda = 0.0023;
inline constexpr std::size_t kPaperPoints = 400;  // points of a curve, enough to look smooth

/// The key's label for measured points: "data, reconstructed".
std::string data_label(const Dataset& data);

/// Figures 5 and 6.
std::vector<Figure> paper_behaviours();
/// Figure 8, one panel per model, with points of data that have loads and constants.
std::vector<Figure> paper_areas_of_mergel(const std::vector<Dataset>& data);
/// Figure 10.
Figure paper_areas_of_waters();

}  // namespace mixity
