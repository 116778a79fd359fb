#include "report/set_table.h"

#include <algorithm>
#include <string_view>

#include "base/phrases.h"
#include "report/data_text.h"

namespace mixity {
namespace {

/// Columns of the fits' table that this one takes, by the beginning of their headings.
constexpr std::string_view kTaken[] = {"Model", "Parameters", "Status", "AICc weight"};

}  // namespace

FitTable set_table(const ReportContent& content) {
  using Cell = FitTable::Cell;
  FitTable table;
  if (content.entries.size() < 2) return table;
  table.headings = {"Data set", "Best model", "Parameters", "Status", "AICc weight"};
  for (const ReportEntry& entry : content.entries) {
    const Analysis& result = entry.shown->result;
    const Dataset& data = result.data;
    std::vector<Cell> row{{{data.title(), counted(data.points.size(), "point") + runs_of_points(data),
                            "provenance: " + std::string(to_string(data.metadata.provenance))}}};
    row.resize(table.headings.size());
    if (const FitResult* const best = entry.shown->answer.fit) {
      FitTable fits = fit_table(result);
      auto& cells = fits.rows[static_cast<std::size_t>(best - result.fits.data())];
      for (std::size_t k = 0; k < cells.size(); ++k)
        for (std::size_t taken = 0; taken < std::size(kTaken); ++taken)
          if (fits.headings[k].starts_with(kTaken[taken])) {
            row[1 + taken] = std::move(cells[k]);
            if (taken == 1) table.headings[2] = fits.headings[k];  // with the confidence of the intervals
          }
    } else {
      row[3] = {{"no fit has a value"}, true};
    }
    table.rows.push_back(std::move(row));
  }
  // of a single model there is no weight
  if (std::all_of(table.rows.begin(), table.rows.end(), [](const auto& row) { return row.back().lines.empty(); })) {
    table.headings.pop_back();
    for (auto& row : table.rows) row.pop_back();
  }
  table.short_headings = table.headings;
  return table;
}

}  // namespace mixity
