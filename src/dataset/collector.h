// Builds a data set from the rows of a file, or from arrays.
#pragma once

#include <complex>
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

/// The loading runs of the rows, in order of appearance. Rows of a run share its name, or else their load.
class Runs {
 public:
  /// The index of the row's run, which is added if it is new.
  std::size_t of(const std::optional<std::string_view>& name, const Point& point, const Dataset& data);
  /// Changes the sign of loads in run names made from them; loads() are unchanged.
  void reverse_loads_in_names(const Dataset& data);
  const std::vector<double>& loads() const { return loads_; }  // of each run's first point
  /// The names as shown, made distinct.
  std::vector<std::string> names() const;

 private:
  using Key = std::pair<std::string, bool>;  // a name, and whether a row states it: a run may be called "P=3 mN"
  std::map<Key, std::size_t> index_;
  std::vector<Key> keys_;
  std::vector<double> loads_;
  std::size_t last_ = 0;  // the run of the last row; the next row usually belongs to it, too
  double last_load_ = 0;
};

class Collector {
 public:
  /// Throws InputError for headings that cannot be used, and as take_header does.
  /// `load`: of the first rows, in N, if titles or comments above the rows of each run state their load.
  Collector(const std::string& metadata_path, const std::vector<Heading>& headings, const ColumnRules& rules,
            const std::optional<double>& load, Dataset& data);
  /// Adds the row as a point or as excluded. Throws InputError for a row that cannot be understood.
  void row(const CsvRow& row, const std::optional<std::string_view>& run = {});  // `run`: its name if no column has it
  void set_load(double load) { reader_.set_load(load); }                         // in N, of the rows to come
  /// Adds a line that is not a row as excluded. `reason`: a fixed text.
  void leave_out(std::size_t line, std::string_view reason);
  void comment(const CsvRow& row);
  /// The next rows are those of another table, which is a run if there are several and no column names runs.
  void begin_table(const std::string& title);
  bool tables_are_runs() const { return tables_.size() > 1 && !columns().has(ColumnId::curve); }
  /// Completes what needs all points: runs, signs, notes. Throws InputError if there were no rows.
  void finish();

  const Columns& columns() const { return reader_.columns(); }

 private:
  bool has_times() const;
  void take_tables_as_runs();
  void finish_angles();
  void add_note_on_axes();
  void add_note_on_areas();

  void begin_run_at(const std::string& title, double load);

  std::string metadata_path_;
  Dataset& data_;
  const Vocabulary* titles_ = nullptr;  // by which titles state loads; null: they do not
  PointReader reader_;
  bool has_errors_;                // the table has a column of standard errors, or fields with them
  bool errors_in_fields_ = false;  // "0.61 +/- 0.05"
  bool named_ = false;             // the runs of rows, where they stand side by side
  Runs runs_;
  std::vector<std::size_t> negative_angles_;  // points
  struct TableBegin {
    std::size_t point;  // the first point of the table
    std::string title;
  };
  std::vector<TableBegin> tables_;
  std::size_t comments_ = 0, first_comment_ = 0;  // comments that would be rows without '#'; the line of the first
  bool has_axes_ = false;
  double largest_axes_ = 1;  // the largest ratio of the axes of elliptic contacts
  std::size_t line_of_largest_ = 0;
  bool along_ = false;               // the longer of these axes lies along the shear
  std::complex<double> direction_;   // sum of those of the axes; of their sizes: weight_
  double weight_ = 0, squares_ = 0;  // and of their squares
  double largest_turn_ = 0;          // of the angles of the axes, in rad
  double beside_axes_ = 0;           // the largest of ReadPoint::beside_axes, and its line
  std::size_t line_beside_axes_ = 0;
};

}  // namespace mixity
