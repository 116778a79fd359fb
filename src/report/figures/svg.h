// Draws figures as SVG, and sanitises drawings from other sources.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/figures/figure.h"

namespace mixity {

/// file: on white. page: without background, in the colours of the page's style, --ink and --color-N for color(N).
enum class Medium { file, page };

/// A figure with title and caption as text alternatives, and a tooltip at each point that has a hover text. Wide
/// figures are 890 by 400, others and `narrow` ones, for phones, 430 wide. A finished drawing is returned unchanged.
std::string svg(const Figure& figure, Medium medium, bool narrow = false);

/// A figure drawn elsewhere, or why it is unusable.
struct KeptFigure {
  std::optional<Figure> figure;
  std::string reason;                // "is no SVG"
  std::vector<std::string> dropped;  // removed elements and attributes that our own drawings do not use, each once
};
/// An SVG file as a figure with its title and caption, rebuilt from the elements and attributes that our own drawings
/// use: it contains no scripts, references or ids.
KeptFigure kept_figure(const std::string& svg, const std::string& name);

/// "var(--ink)" for black, "var(--color-N)" for color(N), "var(--paper)" for white; other colours unchanged.
std::string themed(const std::string& color);

/// A kept figure's drawing without background, in the colours of the page's style.
std::string themed_svg(const std::string& svg);

}  // namespace mixity
