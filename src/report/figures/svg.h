// Draws figures as SVG.
#pragma once

#include <string>

#include "report/figures/figure.h"

namespace mixity {

/// For a file, on white; for a page, without a background and in the colours of the page's style: --ink and --color-N
/// for color(N).
enum class Medium { file, page };

/// A figure with its title and caption as text alternatives, and a title at each point that has something to say. A
/// wide one is 890 by 400, others and, for phones, `narrow` ones are 430 wide. One that is drawn already is taken as it
/// is.
std::string svg(const Figure& figure, Medium medium, bool narrow = false);

}  // namespace mixity
