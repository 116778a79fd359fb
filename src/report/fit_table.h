// The fits of a data set as a rounded table, and sentences about them, for the page and the Markdown summary.
#pragma once

#include <string>
#include <vector>

#include "analysis/result.h"

namespace mixity {

/// Columns that are empty for all fits are left out.
struct FitTable {
  struct Cell {
    std::vector<std::string> lines;
    bool alert = false;  // a status other than ok, or disagreement with a published value
  };
  std::vector<std::string> headings, short_headings;
  std::vector<std::vector<Cell>> rows;  // [fit][column]
};

FitTable fit_table(const Analysis& result);

/// The table for a terminal: aligned columns; a fit takes several lines where a cell does.
std::string table_text(const Analysis& result);

/// A weight or probability of a model: "1", "0.0318" or, where it is negligible, "< 0.0001".
std::string weight_text(double weight);

/// Replaces powers in a text by ² and ³.
std::string with_powers(std::string text);

/// Sentences on the model that predicts best, on every fit whose status is not ok, and the notes on the data.
std::vector<std::string> findings(const Analysis& result);

/// What was assumed.
std::vector<std::string> assumptions(const Analysis& result);

/// How the fits were made, as names and values.
std::vector<std::pair<std::string, std::string>> fit_settings(const Analysis& result);

}  // namespace mixity
