// A log: forces, areas or both over time, recorded with one clock.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/message.h"
#include "dataset/logs/time_base.h"
#include "dataset/metadata.h"
#include "dataset/table/heading.h"

namespace mixity {

/// Values are in SI. Quantities without a column are empty; empty fields are NaN.
struct Recording {
  std::string path;
  std::size_t line = 0;      // of the first row; 0 if the file has one log
  std::vector<double> time;  // s, rising
  TimeBase clock;
  std::vector<double> P, T, A;
  std::vector<double> q;                       // ln(a/b) of the axes along and across the shear, where the log has both
  bool load_is_stated = false;                 // P has no column and no zero to be read
  std::string force_unit, area_unit;           // in the file; mm^2 for areas in pixels and areas from radii or axes
  double force_factor = 1, area_factor = 1;    // one unit in SI
  std::string reading;                         // the format of the file: "tabs, decimal commas"
  std::vector<Heading> headings;               // of the table
  Message advice;                              // which column may hold the forces or areas, if none is known to
  std::vector<std::string> taken;              // "P from 'Normalkraft (mN)'"
  std::map<std::string, std::string> mapping;  // as Dataset::mapping

  bool holds_forces() const { return !T.empty(); }
  bool holds_areas() const { return !A.empty(); }
};

/// Reads the logs of a file, each with a column of times or a rate, and columns P and T, or A (or a, or axes), or all
/// of these, with units. A file has several logs if its clock starts anew. The load may be stated beside the file, as
/// for data. Throws InputError as load_dataset does, for decreasing times, and for repeated times that no constant rate
/// explains (time_base.h). `one_of_two`: the mapping of columns is that of two files, and this one may lack some.
std::vector<Recording> read_recordings(const std::string& path, const Metadata& metadata, Inputs& inputs,
                                       bool one_of_two = false);
inline std::vector<Recording> read_recordings(const std::string& path, const Metadata& metadata) {
  Inputs inputs;
  return read_recordings(path, metadata, inputs);
}

/// The headings of its table; none if it has no table.
std::vector<Heading> headings_of_log(const std::string& path, const Metadata& metadata, Inputs& inputs);

}  // namespace mixity
