// Draws figures as SVG, and keeps drawings that others made.
#pragma once

#include <optional>
#include <string>

#include "report/figures/figure.h"

namespace mixity {

/// For a file, on white; for a page, without a background and in the colours of the page's style: --ink and --color-N
/// for color(N).
enum class Medium { file, page };

/// A figure with its title and caption as text alternatives, and a tooltip at each point that has a hover text. A wide
/// one is 890 by 400, others and, for phones, `narrow` ones are 430 wide. One that is already drawn stays as it is.
std::string svg(const Figure& figure, Medium medium, bool narrow = false);

/// An SVG file as a figure: without scripts, styles and references to elsewhere, with its title and caption, and with
/// ids that begin with the figure's name. Null if the text is no SVG.
std::optional<Figure> kept_figure(const std::string& svg, const std::string& name);

/// "var(--ink)" for black, "var(--color-N)" for color(N), "var(--paper)" for white; other colours stay.
std::string themed(const std::string& color);

/// The drawing of a kept figure without its background, in the colours of the page's style.
std::string themed_svg(const std::string& svg);

}  // namespace mixity
