#include "dataset/peak_forces.h"

#include <array>
#include <cmath>

#include "base/input_error.h"
#include "dataset/table/columns.h"
#include "dataset/table/csv_file.h"
#include "mechanics/contact.h"

namespace mixity {
namespace {

enum Force { kLoad, kPeak, kMinimum };
constexpr std::array<std::string_view, 3> kNames{"P", "T_peak", "T_min"};
constexpr std::array<std::string_view, 3> kForceNotFinite{"column 'P' is not finite", "column 'T_peak' is not finite",
                                                          "column 'T_min' is not finite"};
constexpr std::array<std::string_view, 3> kForceNegative{"P is not above 0: no area of Hertz", "T_peak < 0",
                                                         "T_min < 0"};

class Reader {
 public:
  Reader(const CsvRow& header, const std::string& metadata_path, PeakForces& forces)
      : forces_(forces), width_(header.size()) {
    const std::string& path = forces.path;
    for (std::size_t i = 0; i < header.size(); ++i) {
      const Heading heading = split_heading(header[i], header.place(i));
      for (const Force q : {kLoad, kPeak, kMinimum}) {
        if (heading.name != kNames[q]) continue;
        if (columns_[q]) throw InputError(path, header.place(i), "column '" + heading.name + "' stands twice");
        columns_[q] = i;
        units_[q] = unit_of(heading, kind_of(ColumnId::P), path, header.size() == 1);
      }
    }
    if (!columns_[kLoad]) throw InputError(path, header.line(), 1, "column 'P' is missing");
    if (!columns_[kPeak] && !columns_[kMinimum])
      throw InputError(path, header.line(), 1, "column 'T_peak' or 'T_min' is missing");
    const bool bare = units_[kLoad].dimension == dimension::none;
    for (const Force q : {kPeak, kMinimum})
      if (columns_[q] && bare != (units_[q].dimension == dimension::none))
        throw InputError(path, header.place(*columns_[q]),
                         "column '" + std::string(kNames[q]) + "' and P are either both dimensionless or neither is");
    if (bare) return;
    const auto needed = [&](const std::optional<double>& value, const std::string& key) {
      if (!value) throw InputError(path, "needs " + key + " for the area of Hertz: state it in " + metadata_path);
      return *value;
    };
    radius_ = needed(forces.metadata.radius, "radius");
    modulus_ = needed(forces.metadata.plane_strain_modulus(), "modulus");
    forces.force_unit = units_[kLoad].text;
    forces.stress_unit = "kPa";
    stress_ = 1e3;
  }

  void row(const CsvRow& row) {
    require_width(forces_.path, row, width_, width_);
    std::array<std::optional<double>, 3> values;
    double value = 0;
    for (const Force q : {kLoad, kPeak, kMinimum})
      if (columns_[q] && number_at(forces_.path, row, *columns_[q], kNames[q], value)) values[q] = value;
    const auto exclude = [&](std::string_view why) { forces_.excluded.push_back({row.line(), why}); };
    for (const Force q : {kLoad, kPeak, kMinimum})
      if (values[q] && !std::isfinite(*values[q])) return exclude(kForceNotFinite[q]);
    if (!values[kLoad]) return exclude("column 'P' is empty");
    if (!values[kPeak] && !values[kMinimum]) return exclude("neither T_peak nor T_min is given");
    if (!(*values[kLoad] > 0)) return exclude(kForceNegative[kLoad]);
    for (const Force q : {kPeak, kMinimum})
      if (values[q] && *values[q] < 0) return exclude(kForceNegative[q]);
    PeakForce point{row.line(), *values[kLoad], {}, {}};
    // Hertz: a^3 = 3 P R/(4 E*); dimensionless with R = E* = 1
    const double area = area_from_radius(std::cbrt(0.75 * *values[kLoad] * units_[kLoad].factor * radius_ / modulus_));
    for (const Force q : {kPeak, kMinimum}) {
      if (!values[q]) continue;
      const double stress = *values[q] * units_[q].factor / area / stress_;
      if (!std::isfinite(stress)) return exclude("the mean stress is out of range");
      (q == kPeak ? point.peak : point.minimum) = stress;
    }
    forces_.rows.push_back(point);
  }

  /// Adds a comment that would be a row without its '#' as excluded.
  void comment(const CsvRow& row) {
    if (row.size() >= width_ && holds_a_number(row))
      forces_.excluded.push_back({row.line(), "passed over as a comment: it begins with '#'"});
  }

 private:
  PeakForces& forces_;
  std::size_t width_;
  std::array<std::optional<std::size_t>, 3> columns_;
  std::array<Unit, 3> units_;
  double radius_ = 1, modulus_ = 1, stress_ = 1;
};

}  // namespace

PeakForces load_peak_forces(const std::string& path) {
  PeakForces forces;
  forces.path = path;
  forces.name = data_name(path);
  Inputs inputs;
  forces.metadata = read_metadata(metadata_path(path), inputs);
  require_whole_modulus(forces.metadata, metadata_path(path));
  CsvFile file(path, inputs, {forces.metadata.sheet, forces.metadata.decimal});
  CsvRow row;
  if (!file.next(row)) throw InputError(path, 1, 1, "is empty: a header row is missing");
  Reader reader(row, metadata_path(path), forces);
  while (file.next(row)) row.is_comment() ? reader.comment(row) : reader.row(row);
  if (forces.rows.empty() && forces.excluded.empty()) throw InputError(path, 2, 1, "has a header but no data rows");
  forces.inputs = inputs.files();
  return forces;
}

}  // namespace mixity
