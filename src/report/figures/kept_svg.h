// SVG files of others for a page that holds many.
#pragma once

#include <optional>
#include <string>

#include "report/figures/figure.h"

namespace mixity {

/// What is kept of an SVG file: all but what runs, is styled or looked up elsewhere; its title and caption; ids that
/// begin with the figure's name. Null if the text is no SVG.
std::optional<Figure> kept_figure(const std::string& svg, const std::string& name);

/// "var(--ink)" for black, "var(--color-N)" for color(N), "var(--paper)" for white; other colours as they are.
std::string themed(const std::string& color);

/// The drawing of a kept figure without its background, in the colours of the page's style.
std::string themed_svg(const std::string& svg);

}  // namespace mixity
