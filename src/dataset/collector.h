// Points of rows that are read, from a file or from arrays, as they become a data set.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dataset/dataset.h"
#include "dataset/point_reader.h"
#include "dataset/runs.h"
#include "dataset/shear_sign.h"
#include "dataset/table/csv.h"

namespace mixity {

/// How far from circles elliptic contacts are: the longest axis over the shorter one, and where.
struct EllipseAxes {
  double ratio = 1;
  std::size_t line = 0;
  void add(const EllipseAxes& other) {
    if (other.ratio > ratio) *this = other;
  }
};

/// Rows that follow each other, and what they hold.
struct Part {
  std::size_t rows = 0, commented = 0, first_commented = 0;  // rows; those behind '#', and the line of the first
  std::vector<Point> points;
  std::vector<ToughnessPoint> converted;
  std::vector<PointErrors> errors;
  std::vector<PointEnergies> energies;
  std::vector<Excluded> excluded;
  Runs runs;
  std::vector<ShearRange> shear;  // of each run
  PointBatch batch;
  EllipseAxes axes;

  void clear(std::size_t expected) {
    rows = commented = 0;
    points.clear();
    points.reserve(expected);
    converted.clear();
    errors.clear();
    energies.clear();
    excluded.clear();
    runs = {};
    axes = {};
  }
  void row(const PointReader& reader, const Dataset& data, const CsvRow& row) {
    ++rows;
    ReadPoint read;
    const std::string_view unusable = reader.read(row, read);
    if (!unusable.empty()) {
      excluded.push_back({row.line(), unusable});
      return;
    }
    axes.add({read.axes, row.line()});
    read.point.curve = runs.of(reader.run_name(row), read.point, data);
    points.push_back(read.point);
    if (!data.has_loads) converted.push_back(read.converted);
    if (reader.has_errors()) errors.push_back(read.errors);
    if (data.has_energies) energies.push_back(read.energies);
  }
  void leave_out(const CsvRow& row) {
    ++rows;
    excluded.push_back({row.line(), "a summary of the rows above: words where they have numbers"});
  }
  void comment(const PointReader& reader, const CsvRow& row) {
    if (reader.resembles_data(row) && commented++ == 0) first_commented = row.line();
  }
  void numbers(const PointReader& reader, const Dataset& data, const CsvNumbers& numbers) {
    reader.read(numbers, batch);
    const bool has_errors = reader.has_errors();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (!batch.usable[i]) {
        row(reader, data, numbers.row(i));
        continue;
      }
      ++rows;
      Point& point = points.emplace_back();
      point.line = numbers.line(i);
      point.P = batch.P[i];
      point.T = batch.T[i];
      point.A = batch.A[i];
      point.curve = runs.of(reader.run_name(numbers, i), point, data);
      if (has_errors) errors.push_back({batch.sigma_T[i], batch.sigma_A[i], 0});
    }
  }
};

/// Puts parts together in their order, and finishes what can only be told of all.
class Collector {
 public:
  explicit Collector(Dataset& data) : data_(data) {}
  void take(const Part& part);
  /// Throws InputError if there were no rows.
  void finish(const PointReader& reader, const std::string& metadata_path);

 private:
  bool has_times() const;
  void finish_axes();

  Dataset& data_;
  Runs runs_;
  std::vector<ShearRange> shear_;  // of each run
  EllipseAxes axes_;
  std::size_t commented_ = 0, first_commented_ = 0;
};

}  // namespace mixity
