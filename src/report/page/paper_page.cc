#include "report/page/paper_page.h"

#include "report/figures/paper_figures.h"
#include "report/page/document.h"

namespace mixity {

std::string paper_page(const std::vector<Figure>& figures, const DrawnFigures& drawn) {
  const std::string title = "The figures of Papangelo & Ciavarella (2019)";
  PageDocument document(title);
  pugi::xml_node header = add(document.body(), "header");
  add(header, "h1", title);
  add(header, "p",
      "A. Papangelo, M. Ciavarella, On mixed-mode fracture mechanics models for contact area reduction under shear "
      "load "
      "in soft materials, J. Mech. Phys. Solids (2019); drawn by mixity " MIXITY_VERSION
      " from the equations below each figure.",
      "soft");
  add(header, "p",
      "All quantities are dimensionless, with ξ = (E* R/G_Ic)^(1/3): a = ξ a/R, A = π a², u = ξ² u/R, P = P/(R G_Ic), "
      "T = T/(R G_Ic), τ0 = ξ τ0/E*. The equations stand for their numbers in the paper, which are not known here.",
      "soft");
  if (!drawn.missing.empty()) add(header, "p", drawn.missing, "banner");
  pugi::xml_node page = add(add(document.body(), "main"), "div", {}, "figures");
  for (const Figure& figure : figures) {
    pugi::xml_node caption = add_figure(page, figure, drawn.endings.at(figure.name), "");
    const PaperNotes notes = paper_notes(figure.name);
    if (!notes.equations.empty()) add(caption, "p", "It stands on", "head");
    if (!notes.equations.empty()) add_list(caption, notes.equations);
    if (!notes.print.empty()) add(caption, "p", "Notes on the paper's print", "head");
    if (!notes.print.empty()) add_list(caption, notes.print);
  }
  return document.text();
}

}  // namespace mixity
