// Runs that stand side by side in a table, each in columns with the same headings.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "dataset/table/csv.h"
#include "dataset/table/heading.h"

namespace mixity {

struct RunsBeside {
  std::size_t width = 0;             // columns of each run; 0: there is only one run
  std::vector<std::string> names{};  // of the runs
};

/// How many of the headings the first run has if all others repeat them, texts and units; else 0.
std::size_t width_of_runs(const std::vector<Heading>& headings);

/// The fields of a line above the headings, one for each run, if each has one of its own; else numbers.
std::vector<std::string> names_of_runs(const std::vector<CsvRow>& above, std::size_t headings, std::size_t width,
                                       std::size_t count);

}  // namespace mixity
