// Finds oddities of a data set: what an experienced colleague would ask about.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "dataset/dataset.h"

namespace mixity {

/// A summary of one loading run. Dimensionless.
struct CurveSummary {
  std::string name;
  std::size_t points = 0;
  double P = 0;                                                             // of the first point
  double P_min = 0, P_max = 0, T_min = 0, T_max = 0, A_min = 0, A_max = 0;  // T as Point::T, which may be negative
  /// Area of the point with the smallest |T| over the JKR area at its load; null if T is not small there
  /// (|T| over a tenth of the run's largest) or the load lies below pull-off.
  std::optional<double> area_over_jkr;
};

/// One summary per run, of readings corrected by the stated constants; empty for data without loads.
std::vector<CurveSummary> summarise_curves(const Dataset& data);

/// Counts the areas that do not exceed Hertz's at their load.
struct BelowHertz {
  explicit BelowHertz(const Dataset& data) : rows(data.rows) {
    for (std::size_t i = 0; i < data.points.size(); ++i)
      if (!data.toughness(i) && ++points == 1) first_line = data.points[i].line;
  }
  std::size_t points = 0, first_line = 0, rows;
  bool most() const { return 2 * points > rows; }  // then a unit is probably wrong
};

/// One sentence per oddity, with line numbers where they apply; empty if nothing is odd.
std::vector<std::string> find_oddities(const Dataset& data, Wording words = in_neutral_words);

}  // namespace mixity
