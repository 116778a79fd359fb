// What a header and the experiment's constants make of a data row: a point, or a reason why it cannot be used.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "dataset/dataset.h"
#include "dataset/table/columns.h"
#include "dataset/table/csv.h"

namespace mixity {

/// A point, and what there may be beside it.
struct ReadPoint {
  Point point;
  ToughnessPoint converted;
  PointErrors errors;
  PointEnergies energies;
  double axes = 1;  // of an elliptic contact, the longer over the shorter
};

/// Points of rows that come several at a time, by quantity. What is not usable is still to be read one by one.
struct PointBatch {
  template <class T>
  using Values = std::array<T, CsvNumbers::kMost>;
  Values<double> P, T, A, toughness_ratio, sigma_T, sigma_A;
  Values<bool> usable;
};

class PointReader {
 public:
  /// Understands the header and fills in what it says of the data set: loads or toughness, scales, ignored columns.
  /// Throws InputError for a header that cannot be used, and for a constant that is needed and not stated.
  PointReader(const std::string& metadata_path, const std::vector<Heading>& headings, Dataset& data);

  /// Reads a row into a point whose run is left open. Empty, or why the row cannot be used. Throws InputError for a row
  /// that cannot be understood. Several threads may read rows at once.
  std::string_view read(const CsvRow& row, ReadPoint& point) const;

  /// Of a line behind '#': whether it would be a row of the table, with numbers.
  bool resembles_data(const CsvRow& comment) const;

  /// The fields that rows must bring to be read several at a time; null if this kind of file is read one by one.
  const CsvWanted* wanted() const { return wanted_ ? &*wanted_ : nullptr; }
  /// The same points as read() makes of each row, if it makes one.
  void read(const CsvNumbers& rows, PointBatch& batch) const;

  const Columns& columns() const { return columns_; }
  /// What was taken for what, where the headings are not the program's own.
  const std::vector<std::string>& taken() const { return columns_.taken(); }
  bool names_runs() const { return columns_.has(ColumnId::curve); }
  bool has_axes() const { return columns_.holds_axes(); }
  /// Whether the file has a column of standard errors.
  bool has_errors() const {
    return columns_.has(ColumnId::sigma_T) || columns_.has(ColumnId::sigma_A) || columns_.has(ColumnId::sigma_Gc) ||
           columns_.has(ColumnId::sigma_GI) || columns_.has(ColumnId::sigma_GII);
  }
  /// What the header's column names the row's run; null without such a column.
  std::optional<std::string_view> run_name(const CsvRow& row) const;
  std::optional<std::string_view> run_name(const CsvNumbers& rows, std::size_t i) const;

 private:
  void require_constants(const std::string& metadata_path);
  void add_notes();
  void set_display();
  void set_energy_display();
  void set_wanted();
  // Each reads what its last argument takes, and says why there is none; empty if there is.
  std::string_view number(const CsvRow& row, ColumnId id, double& value) const;
  std::string_view standard_error(const CsvRow& row, ColumnId id, double of, double unit, double& error) const;
  std::string_view read_axes(const CsvRow& row, double& area, ReadPoint& point) const;
  std::string_view read_loads(const CsvRow& row, ReadPoint& point) const;
  std::string_view read_toughness(const CsvRow& row, ReadPoint& point) const;
  std::string_view read_energies(const CsvRow& row, ReadPoint& point) const;
  /// The column that says in which unit toughness is given; null without one.
  const Column* toughness_column() const {
    return columns_.find(columns_.holds_energies() ? ColumnId::G_I : ColumnId::Gc);
  }

  /// The load of all points, in SI; null where a column states it.
  std::optional<double> load_;
  Dataset& data_;  // for the constants; changed by the constructor only
  Columns columns_;
  std::optional<CsvWanted> wanted_;
  std::array<std::size_t, kColumnCount> place_{};             // of a column among the wanted numbers
  double force_unit_ = 1, length_unit_ = 1, ratio_unit_ = 1;  // SI units in one of those of a point
};

}  // namespace mixity
