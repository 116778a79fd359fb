// A data set ready to fit: points with phase angle and toughness ratio, made from a CSV and its metadata.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dataset/input_error.h"
#include "dataset/metadata.h"
#include "dataset/printable.h"
#include "mechanics/contact.h"
#include "mechanics/measurement.h"

namespace mixity {

/// One usable point. P, T, A are dimensionless and zero where the data set has no loads.
struct Point {
  std::size_t line;   // in the CSV
  std::size_t curve;  // index into Dataset::curves
  double P, T, A;
};

/// Standard errors in the units of T, A and the toughness ratio; 0 where not given.
struct PointErrors {
  double T, A, ratio;
};

/// Why a point with loads has no toughness.
inline constexpr std::string_view kNoPhaseAngle =
    "y <= 0: the area does not exceed that of Hertz at this load, so no phase angle exists";

struct Excluded {
  std::size_t line;
  std::string_view reason;  // a fixed text: a file may have millions of excluded rows
};

/// How the file's own units relate to the dimensionless ones: value in file = dimensionless * scale.
struct DisplayUnits {
  std::string force, area;  // as written in the header; empty if dimensionless
  double force_scale = 1, area_scale = 1;
};

struct Dataset {
  std::string path, name;  // as opened; the file's without folder and ending
  Metadata metadata;
  bool has_loads = false;                 // (P, T, A) rather than (psi, Gc)
  std::optional<Contact> contact;         // null if the data are dimensionless or (psi, f)
  std::size_t rows = 0;                   // data rows in the file: points + excluded
  std::vector<Point> points;              // usable, in file order
  std::vector<ToughnessPoint> converted;  // of each point, if the data set has no loads
  std::vector<PointErrors> errors;        // of each point, if the file states any
  std::vector<Excluded> excluded;
  std::vector<std::string> curves;  // names of the loading runs: the curve column, or one per load
  std::vector<double> curve_loads;  // dimensionless load of each run's first point; empty without loads
  std::vector<std::string> ignored_columns;
  std::vector<std::string> notes;  // what was stated and is passed over, as sentences that every fit shows
  DisplayUnits display;

  /// What point i says of the toughness; null where its area does not exceed that of Hertz (PointUse::areas).
  std::optional<ToughnessPoint> toughness(std::size_t i) const {
    if (!has_loads) return converted[i];
    return toughness_of_area(points[i].P, points[i].T, points[i].A);
  }
  std::string shown_path() const { return printable(path, std::string::npos); }
  PointErrors errors_of(std::size_t i) const { return errors.empty() ? PointErrors{} : errors[i]; }
};

/// Where a point's value of that column stands; the file is read again, and if that cannot be, the line alone is known.
FilePlace place_of(const Dataset& data, const Point& point, std::string_view column);

/// Indices into Dataset::points, by run.
std::vector<std::vector<std::size_t>> points_by_curve(const Dataset& data);

/// What a file's points are read for. A point whose area does not exceed that of Hertz (y <= 0) has no phase angle and
/// is excluded where a toughness is asked for; its area says as much as any other.
enum class PointUse { toughness, areas };

/// Reads PATH.csv and PATH.toml beside it. Throws InputError, with file, line and column, for anything in them that
/// cannot be understood, and for a constant that this kind of data needs and neither the TOML nor an override states.
/// Points that are understood but cannot be used are listed in `excluded`.
Dataset load_dataset(const std::string& path, const Overrides& overrides = {}, PointUse use = PointUse::toughness);

}  // namespace mixity
