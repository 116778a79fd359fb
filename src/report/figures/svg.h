// Draws figures as SVG, and keeps drawings that others made.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/figures/figure.h"

namespace mixity {

/// For a file, on white; for a page, without a background and in the colours of the page's style: --ink and --color-N
/// for color(N).
enum class Medium { file, page };

/// A figure with its title and caption as text alternatives, and a tooltip at each point that has a hover text. A wide
/// one is 890 by 400, others and, for phones, `narrow` ones are 430 wide. One that is already drawn stays as it is.
std::string svg(const Figure& figure, Medium medium, bool narrow = false);

/// A figure that somebody else drew, or why there is none.
struct KeptFigure {
  std::optional<Figure> figure;
  std::string reason;                // "is no SVG"
  std::vector<std::string> dropped;  // names of elements and attributes that our own drawings do not use, each once
};
/// An SVG file as a figure with its title and caption, rebuilt from the elements and attributes that our own drawings
/// use: nothing in it runs, looks anything up or has an id.
KeptFigure kept_figure(const std::string& svg, const std::string& name);

/// "var(--ink)" for black, "var(--color-N)" for color(N), "var(--paper)" for white; other colours stay.
std::string themed(const std::string& color);

/// The drawing of a kept figure without its background, in the colours of the page's style.
std::string themed_svg(const std::string& svg);

}  // namespace mixity
