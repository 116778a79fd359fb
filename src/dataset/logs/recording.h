// A log: forces, areas or both over time, recorded with one clock.
#pragma once

#include <string>
#include <vector>

#include "dataset/logs/time_base.h"
#include "dataset/metadata.h"
#include "dataset/table/heading.h"

namespace mixity {

/// In SI. Quantities without a column are empty; NaN replaces empty fields.
struct Recording {
  std::string path;
  std::vector<double> time;  // s, rising
  TimeBase clock;
  std::vector<double> P, T, A;
  std::string force_unit, area_unit;         // of the file; mm^2 for areas in pixels and areas from radii or axes
  double force_factor = 1, area_factor = 1;  // one unit in SI
  std::string reading;                       // the format of the file: "tabs, decimal commas"
  std::vector<std::string> taken;            // "P from 'Normalkraft (mN)'"

  bool holds_forces() const { return !T.empty(); }
  bool holds_areas() const { return !A.empty(); }
};

/// Reads a log with a column of times, and P and T, or A (or a, or axes), or all of these, with units. The load may be
/// stated beside the file, as for data. Throws InputError as load_dataset does, and for times that go back, or
/// that rows share in a way that no constant rate explains (time_base.h). `one_of_two`: the mapping of columns is that
/// of two files, and this one may lack some.
Recording read_recording(const std::string& path, const Metadata& metadata, Inputs& inputs, bool one_of_two = false);
inline Recording read_recording(const std::string& path, const Metadata& metadata) {
  Inputs inputs;
  return read_recording(path, metadata, inputs);
}

/// The headings of its table; none if it has no table.
std::vector<Heading> headings_of_log(const std::string& path, const Metadata& metadata);

}  // namespace mixity
