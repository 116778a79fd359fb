// Makes a data set of rows, which a file or arrays hold.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "dataset/dataset.h"
#include "dataset/point_reader.h"
#include "dataset/table/csv.h"

namespace mixity {

/// The loading runs of rows, in the order in which they appear: by the name that the row states, else by equal load.
class Runs {
 public:
  /// The index of the row's run, a new one if it is the first of its run.
  std::size_t of(const std::optional<std::string_view>& name, const Point& point, const Dataset& data);
  /// Names that state the load state the one of opposite sign from now on; loads() stay.
  void turn_loads(const Dataset& data);
  const std::vector<double>& loads() const { return loads_; }  // of the first point of each run
  /// What readers see, no two the same.
  std::vector<std::string> names() const;

 private:
  using Key = std::pair<std::string, bool>;  // a name, and whether a row states it: a run may be called "P=3 mN"
  std::map<Key, std::size_t> index_;
  std::vector<Key> keys_;
  std::vector<double> loads_;
  std::size_t last_ = 0;  // rows of a run mostly follow each other
  double last_load_ = 0;
};

class Collector {
 public:
  Collector(const PointReader& reader, Dataset& data) : reader_(reader), data_(data) {}
  /// Makes a point of a row, or lists it as excluded. Throws InputError for a row that cannot be understood.
  void row(const CsvRow& row);
  /// Lists a row of a summary as excluded.
  void leave_out(const CsvRow& row);
  void comment(const CsvRow& row);
  /// Does what needs all points: runs, signs, notes. Throws InputError if there were no rows.
  void finish(const std::string& metadata_path);

 private:
  bool has_times() const;
  void add_note_on_axes();

  const PointReader& reader_;
  Dataset& data_;
  Runs runs_;
  std::size_t comments_ = 0, first_comment_ = 0;  // that would be rows; the line of the first
  double largest_axes_ = 1;                       // of elliptic contacts, the longer axis over the shorter
  std::size_t line_of_largest_ = 0;
};

}  // namespace mixity
