// A log: forces, areas or both over time, recorded with one clock.
#pragma once

#include <string>
#include <vector>

#include "dataset/logs/time_base.h"
#include "dataset/metadata.h"

namespace mixity {

/// Values are in SI. Quantities without a column are empty; empty fields are NaN.
struct Recording {
  std::string path;
  std::vector<double> time;  // s, rising
  TimeBase clock;
  std::vector<double> P, T, A;
  std::string force_unit, area_unit;         // in the file; mm^2 for areas in pixels and areas from radii or axes
  double force_factor = 1, area_factor = 1;  // one unit in SI
  std::string reading;                       // the format of the file: "tabs, decimal commas"
  std::vector<std::string> taken;            // "P from 'Normalkraft (mN)'"

  bool holds_forces() const { return !T.empty(); }
  bool holds_areas() const { return !A.empty(); }
};

/// Reads a log with a column of times, and columns P and T, or A (or a, or axes), or all of these, with units. The load
/// may be stated beside the file, as for data. Throws InputError as load_dataset does, for decreasing times, and for
/// repeated times that no constant rate explains (time_base.h).
Recording read_recording(const std::string& path, const Metadata& metadata, Inputs& inputs);
inline Recording read_recording(const std::string& path, const Metadata& metadata) {
  Inputs inputs;
  return read_recording(path, metadata, inputs);
}

}  // namespace mixity
