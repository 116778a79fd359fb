// Makes a point of a row, or gives the reason why it cannot be used.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "dataset/dataset.h"
#include "dataset/header.h"
#include "dataset/table/columns.h"
#include "dataset/table/csv.h"

namespace mixity {

/// A point, with what some files hold beside it.
struct ReadPoint {
  Point point;
  ToughnessPoint converted;
  PointErrors errors;
  PointEnergies energies;
  double axes = 1;  // of an elliptic contact, the longer over the shorter
};

class PointReader {
 public:
  /// Understands the headings, and fills in what they say of the data set (take_header). Throws InputError for headings
  /// that cannot be used, MissingConstants for constants that are needed.
  PointReader(const std::string& metadata_path, const std::vector<Heading>& headings, Dataset& data);

  /// Reads a row into a point, whose run is not set. Returns why the row cannot be used, or an empty text. Throws
  /// InputError for a row that cannot be understood.
  std::string_view read(const CsvRow& row, ReadPoint& point) const;

  /// Whether a comment would be a row of numbers without its '#'.
  bool resembles_data(const CsvRow& comment) const;

  const Columns& columns() const { return columns_; }
  /// Which headings were taken for which quantities, if they are not the program's own.
  const std::vector<std::string>& taken() const { return columns_.taken(); }
  bool names_runs() const { return columns_.has(ColumnId::curve); }
  bool has_axes() const { return columns_.holds_axes(); }
  /// Whether the file has a column of standard errors.
  bool has_errors() const {
    return columns_.has(ColumnId::sigma_T) || columns_.has(ColumnId::sigma_A) || columns_.has(ColumnId::sigma_Gc) ||
           columns_.has(ColumnId::sigma_GI) || columns_.has(ColumnId::sigma_GII);
  }
  /// The name of the row's run; null if it states none.
  std::optional<std::string_view> run_name(const CsvRow& row) const;

 private:
  struct Numbers;
  std::string_view read_loads(Numbers& number, ReadPoint& point) const;
  std::string_view read_toughness(Numbers& number, ReadPoint& point) const;
  std::string_view read_energies(Numbers& number, ReadPoint& point) const;

  std::optional<double> load_;  // of all points, in SI; null where a column states it
  std::string path_;
  Columns columns_;
  PointUnits units_;
};

}  // namespace mixity
