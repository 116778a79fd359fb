// Makes a point of a row, or gives the reason why the row cannot be used.
#pragma once

#include <complex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dataset/dataset.h"
#include "dataset/table/channel_clocks.h"
#include "dataset/table/columns.h"
#include "dataset/table/csv.h"

namespace mixity {

/// The units of points in SI: force, length, toughness ratio, and displacement or approach; 1 for dimensionless data.
struct PointUnits {
  double force = 1, length = 1, ratio = 1, displacement = 1;
};

/// The load common to all points, in SI, from the metadata or the name of the file; null if neither states it. Throws
/// InputError for a file name that does not match `load_from`.
std::optional<double> stated_load(const Dataset& data);

/// Throws InputError, with the units to state, if constants with units are stated beside columns without, which would
/// be taken as dimensionless.
void require_units(const Columns& columns, const std::vector<Heading>& headings, bool load_stated,
                   const std::string& metadata_path, const Dataset& data);

/// Throws InputError if the convention of mode III is stated for data without loads.
void require_shear(const Columns& columns, const std::vector<Heading>& headings, const Dataset& data);

/// Sets what the header of a table and the constants determine: the kind of data, the contact, the display units, the
/// ignored columns, and notes. Throws InputError if units are out of range, MissingConstants if needed constants are
/// not stated.
PointUnits take_header(const Columns& columns, const std::string& metadata_path, Dataset& data);

/// A point, with the quantities that only some files contain.
struct ReadPoint {
  Point point;
  ToughnessPoint converted;
  PointErrors errors;
  PointEnergies energies;
  PointAxes axes, load;            // load: measured beside a held approach
  std::complex<double> direction;  // of the axes: ln(longer/shorter)^2 e^(4i angle)
  double turn = 0;                 // that angle in rad, as it was read
  double beside_axes = 0;          // A/(pi a b) - 1, where both were read in units that can be compared
  PullOffReading pull_off;
  bool states_errors = false;   // the fields of its values contain standard errors
  bool negative_angle = false;  // psi is read without its sign
};

class PointReader {
 public:
  /// Reads the headings and calls take_header. Throws as take_header does, and InputError for unusable headings.
  /// `load`: of the first rows, in N, if the file states it above them.
  PointReader(const std::string& metadata_path, const std::vector<Heading>& headings, const ColumnRules& rules,
              const std::optional<double>& load, Dataset& data);
  void set_load(double load) { load_ = load; }  // of the rows to come

  /// Reads a row into a point, except for its run. Returns why the row cannot be used, or an empty text. Throws
  /// InputError for a row that cannot be understood.
  std::string_view read(const CsvRow& row, ReadPoint& point);

  const Columns& columns() const { return columns_; }

 private:
  struct Numbers;
  std::string_view read_loads(Numbers& number, ReadPoint& point) const;
  std::string_view read_pull_off(Numbers& number, ReadPoint& point) const;
  std::string_view read_axes(const ContactLengths& lengths, Numbers& number, double& area, double& sigma_A,
                             ReadPoint& read) const;
  std::string_view read_toughness(Numbers& number, ReadPoint& point) const;
  std::string_view read_energies(Numbers& number, ReadPoint& point) const;

  std::optional<double> load_;  // common to all points, in SI; null if a column states the loads
  std::string path_;
  Columns columns_;
  ChannelClocks clocks_;
  PointUnits units_;
  double compliance_ = 0;
};

}  // namespace mixity
