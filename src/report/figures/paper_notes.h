// What the figures of the paper stand on, and where its print is wrong.
#pragma once

#include <string>
#include <vector>

namespace mixity {

/// One a line, as text; the paper's numbers of equations are not known here.
struct PaperNotes {
  std::vector<std::string> equations, print;
};

/// Of a figure of paper_figures, by its name.
PaperNotes paper_notes(const std::string& name);

}  // namespace mixity
