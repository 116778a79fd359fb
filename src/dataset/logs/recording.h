// A log: forces, areas or both over time, recorded with one clock.
#pragma once

#include <string>
#include <vector>

#include "dataset/metadata.h"

namespace mixity {

/// In SI. Quantities that the file does not hold are empty; where a row leaves one empty it is NaN.
struct Recording {
  std::string path;
  std::vector<double> time;  // s, rising
  std::vector<double> P, T, A;
  std::string force_unit, area_unit;         // as the file has them; empty: not there
  double force_factor = 1, area_factor = 1;  // SI units in one of them
  std::string reading;                       // the format of the file, where that is not plain
  std::vector<std::string> taken;            // which headings were taken for which quantities

  bool holds_forces() const { return !T.empty(); }
  bool holds_areas() const { return !A.empty(); }
};

/// Reads a log with the columns time, and P and T, or A (or a, or axes), or all, all with units; the load may be stated
/// beside it, as for data. Throws InputError for what load_dataset refuses of a table, and for times that do not rise.
Recording read_recording(const std::string& path, const Metadata& metadata);

}  // namespace mixity
