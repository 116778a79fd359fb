// The fits of a data set as a table, rounded for a reader, and sentences about them, for the page and the Markdown
// summary.
#pragma once

#include <string>
#include <vector>

#include "analysis/result.h"

namespace mixity {

/// Without columns that are empty for all fits.
struct FitTable {
  struct Cell {
    std::vector<std::string> lines;
    bool alert = false;  // a status other than ok, or a published value with which the fit does not agree
  };
  std::vector<std::string> headings, short_headings;
  std::vector<std::vector<Cell>> rows;  // [fit][column]
};

FitTable fit_table(const Analysis& result);

/// The table for a terminal: aligned columns, a line for each fit and more where a cell has several lines.
std::string table_text(const Analysis& result);

/// Text with powers as ² and ³.
std::string with_powers(std::string text);

/// Sentences on the model that predicts best, on every fit with a status other than ok, and the notes on the data.
std::vector<std::string> findings(const Analysis& result);

/// What was taken as known or true.
std::vector<std::string> assumptions(const Analysis& result);

/// How the fits were made, as name and value.
std::vector<std::pair<std::string, std::string>> fit_settings(const Analysis& result);

}  // namespace mixity
