// SVG as gnuplot writes it, made fit for readers and for a page that holds many.
#pragma once

#include <optional>
#include <string>

#include "report/figures/figure.h"

namespace mixity {

/// Title and caption as text alternatives, hover texts as titles that every browser shows, ids that no other figure
/// has, and nothing that draws nothing. Throws OutputError if the text is no SVG.
std::string readable_svg(const std::string& svg, const Figure& figure);

/// What is kept of an SVG file for a page: all but what runs, is styled or looked up elsewhere; its title and caption.
/// Null if the text is no SVG.
std::optional<Figure> kept_figure(const std::string& svg);

/// For a page: without XML declaration and background, colours as variables of the page's style: --ink, --paper and
/// --color-N for color(N).
std::string inline_svg(const std::string& svg);

}  // namespace mixity
