#include "report/page/paper_page.h"

#include "report/figures/paper_figures.h"
#include "report/page/document.h"

namespace mixity {

std::string paper_page(const std::vector<Figure>& figures, const DrawnFigures& drawn) {
  const std::string title = "The figures of Papangelo & Ciavarella (2019)";
  std::string header =
      text_element("h1", title) +
      text_element("p",
                   "A. Papangelo, M. Ciavarella, On mixed-mode fracture mechanics models for contact area reduction "
                   "under shear load in soft materials, J. Mech. Phys. Solids (2019); drawn by mixity " MIXITY_VERSION
                   " from the equations below each figure.",
                   "soft") +
      text_element(
          "p",
          "All quantities are dimensionless: a is in units of R/ξ with ξ = (E* R/G_Ic)^(1/3), A = π a² of "
          "(R/ξ)², u of R/ξ², P and T of R G_Ic, τ0 of E*/ξ. The paper's numbers of the equations are not known "
          "here.",
          "soft");
  if (!drawn.missing.empty()) header += text_element("p", drawn.missing, "banner");
  std::string content;
  for (const Figure& figure : figures) {
    const auto [equations, print] = paper_notes(figure.name);
    std::string notes;
    if (!equations.empty()) notes += text_element("p", "Equations", "head") + list_of(equations);
    if (!print.empty()) notes += text_element("p", "Where the printed paper differs", "head") + list_of(print);
    content += figure_element(figure, drawn.endings.at(figure.name), {}, notes);
  }
  return html_page(title, element("header", header) + element("main", element("div", content, {{"class", "figures"}})));
}

}  // namespace mixity
