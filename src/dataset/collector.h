// Builds a data set from the rows of a file, or from arrays.
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

/// The loading runs of rows, in order of appearance: by the name that the row states, otherwise by equal load.
class Runs {
 public:
  /// The index of the row's run. The first row of a run adds it.
  std::size_t of(const std::optional<std::string_view>& name, const Point& point, const Dataset& data);
  /// Reverses the loads in names that are made of them; loads() stay.
  void reverse_loads_in_names(const Dataset& data);
  const std::vector<double>& loads() const { return loads_; }  // of the first point of each run
  /// The names as they are shown, all different.
  std::vector<std::string> names() const;

 private:
  using Key = std::pair<std::string, bool>;  // a name, and whether a row states it: a run may be called "P=3 mN"
  std::map<Key, std::size_t> index_;
  std::vector<Key> keys_;
  std::vector<double> loads_;
  std::size_t last_ = 0;  // the run of the last row, which is mostly that of the next, too
  double last_load_ = 0;
};

class Collector {
 public:
  /// Throws InputError for headings that cannot be used, and as take_header does.
  Collector(const std::string& metadata_path, const std::vector<Heading>& headings, const ColumnRules& rules,
            Dataset& data);
  /// Makes a point of a row, or lists it as excluded. Throws InputError for a row that cannot be understood.
  void row(const CsvRow& row);
  /// Lists a line that is no row as excluded. `reason`: a fixed text.
  void leave_out(std::size_t line, std::string_view reason);
  void comment(const CsvRow& row);
  /// The next rows are those of a table of their own, which is a run if there are several, and no column names runs.
  void begin_table(const std::string& title);
  bool tables_are_runs() const { return tables_.size() > 1 && !columns().has(ColumnId::curve); }
  /// Does what needs all points: runs, signs, notes. Throws InputError if there were no rows.
  void finish();

  const Columns& columns() const { return reader_.columns(); }

 private:
  bool has_times() const;
  void take_tables_as_runs();
  void finish_angles();
  void add_note_on_axes();

  std::string metadata_path_;
  Dataset& data_;
  PointReader reader_;
  bool has_errors_;                // the table has a column of standard errors, or fields that state them
  bool errors_in_fields_ = false;  // "0.61 +/- 0.05"
  Runs runs_;
  std::vector<std::size_t> negative_angles_;  // points
  struct TableBegin {
    std::size_t point;  // its first
    std::string title;
  };
  std::vector<TableBegin> tables_;
  std::size_t comments_ = 0, first_comment_ = 0;  // that would be rows without their '#'; the line of the first
  double largest_axes_ = 1;                       // of elliptic contacts, the longer axis over the shorter
  std::size_t line_of_largest_ = 0;
};

}  // namespace mixity
