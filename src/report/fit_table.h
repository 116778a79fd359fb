// The fits of a data set as rows of a table, rounded for a reader, and what is to be said about them in words: the same
// in the page and in the Markdown summary.
#pragma once

#include <string>
#include <vector>

#include "analysis/result.h"

namespace mixity {

/// Columns that say nothing of any fit are left out.
struct FitTable {
  struct Cell {
    std::vector<std::string> lines;
    bool alert = false;  // a status that is not ok, a published value that is not met
  };
  std::vector<std::string> headings, short_headings;
  std::vector<std::vector<Cell>> rows;  // [fit][column]
};

FitTable fit_table(const Analysis& result);

/// The table for a terminal: columns aligned, a line for each fit and further ones where a cell has
/// several.
std::string table_text(const Analysis& result);

/// Text with powers as ² and ³.
std::string with_powers(std::string text);

/// A sentence on which model predicts best, and one on every fit that did not end ok.
std::vector<std::string> findings(const Analysis& result);

/// What was taken as known or true.
std::vector<std::string> assumptions(const Analysis& result);

/// How the fits were made, as name and value.
std::vector<std::pair<std::string, std::string>> fit_settings(const Analysis& result);

}  // namespace mixity
