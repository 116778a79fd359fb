#include "dataset/point_reader.h"

#include <array>
#include <cmath>

#include "dataset/input_error.h"
#include "mechanics/measurement.h"

namespace mixity {
namespace {

enum Complaint { kEmpty, kNotFinite, kNegative, kOutOfRange };

/// What a column's value is, said once: a file may have millions of them.
std::string_view said_of(ColumnId id, Complaint complaint) {
  static const auto kTexts = [] {
    std::array<std::array<std::string, 4>, kColumnCount> texts;
    for (std::size_t i = 0; i < kColumnCount; ++i)
      for (std::size_t k = 0; k < 4; ++k)
        texts[i][k] = std::string(to_string(static_cast<ColumnId>(i))) +
                      std::array{" is empty", " is not finite", " < 0", " is out of range"}[k];
    return texts;
  }();
  return kTexts[static_cast<std::size_t>(id)][complaint];
}

}  // namespace

PointReader::PointReader(const std::string& metadata_path, PointUse use, const CsvRow& header, Dataset& data)
    : data_(data), use_(use), columns_(data.path, header) {
  data_.has_loads = columns_.holds_loads();
  data_.ignored_columns = columns_.ignored();
  require_constants(metadata_path);
  if (data_.contact) set_display();
}

void PointReader::require_constants(const std::string& metadata_path) {
  const auto demand = [&](std::optional<double> value, const std::string& key) {
    if (value) return *value;
    throw InputError(data_.path, "needs " + key + " to be made dimensionless: state it in " + metadata_path +
                                     " or by a flag (--" + key + "=...)");
  };
  if (!data_.has_loads) {
    const Column* Gc = columns_.find(ColumnId::Gc);
    if (Gc && Gc->unit.dimension != dimension::none) ratio_unit_ = demand(data_.metadata.toughness, "toughness");
    return;
  }
  if (columns_.find(ColumnId::P)->unit.dimension == dimension::none) return;
  data_.contact =
      Contact{demand(data_.metadata.radius, "radius"), demand(data_.metadata.plane_strain_modulus(), "modulus"),
              demand(data_.metadata.toughness, "toughness")};
  force_unit_ = data_.contact->force_unit();
  length_unit_ = data_.contact->length_unit();
  if (!data_.contact->usable()) throw InputError(data_.path, "radius, modulus and toughness together are out of range");
}

void PointReader::set_display() {
  DisplayUnits& display = data_.display;
  if (const Column* shear = columns_.find(ColumnId::T)) {
    display.force = shear->unit.text;
    display.force_scale = data_.contact->force_unit() / shear->unit.factor;
  }
  if (const Column* area = columns_.find(ColumnId::A)) {
    display.area = area->unit.text;
    display.area_scale = data_.contact->area_unit() / area->unit.factor;
  } else if (const Column* radius = columns_.find(ColumnId::a)) {
    display.area = radius->unit.text + "^2";
    display.area_scale = data_.contact->area_unit() / (radius->unit.factor * radius->unit.factor);
  }
  if (!in_range(display.force_scale) || !in_range(display.area_scale))
    throw InputError(data_.path, "the units of its columns are out of range beside radius, modulus and toughness");
}

std::optional<std::string_view> PointReader::run_name(const CsvRow& row) const {
  const Column* column = columns_.find(ColumnId::curve);
  return column ? std::optional(row[column->index]) : std::nullopt;
}

std::string_view PointReader::read(const CsvRow& row, Point& point) const {
  require_width(data_.path, row, columns_.count());
  if (const Column* include = columns_.find(ColumnId::include)) {
    const std::string_view text = row[include->index];
    if (text != "0" && text != "1")
      throw InputError(data_.path, row.line(), row.column(include->index),
                       "column 'include': '" + printable(text, 60) + "' is neither 0 nor 1");
    if (text == "0") return "include = 0";
  }
  point = {};
  point.line = row.line();
  return data_.has_loads ? read_loads(row, point) : read_toughness(row, point);
}

/// In SI or as it stands.
std::string_view PointReader::number(const CsvRow& row, ColumnId id, double& value) const {
  const Column& column = *columns_.find(id);
  if (!number_at(data_.path, row, column.index, to_string(id), value)) return said_of(id, kEmpty);
  value *= column.unit.factor;
  return std::isfinite(value) ? std::string_view() : said_of(id, kNotFinite);
}

/// In the units of what it is the error `of`; 0 where the column or the field is missing.
std::string_view PointReader::standard_error(const CsvRow& row, ColumnId id, double of, double unit,
                                             double& error) const {
  error = 0;
  const Column* column = columns_.find(id);
  if (!column || row[column->index].empty()) return {};
  if (const auto unusable = number(row, id, error); !unusable.empty()) return unusable;
  if (error < 0) return said_of(id, kNegative);
  error = column->unit.text == "%" ? error * std::abs(of) : error / unit;
  return error == 0 || in_range(error) ? std::string_view() : said_of(id, kOutOfRange);
}

std::string_view PointReader::read_loads(const CsvRow& row, Point& point) const {
  const bool by_area = columns_.has(ColumnId::A);
  double P = 0, T = 0, size = 0;
  if (const auto unusable = number(row, ColumnId::P, P); !unusable.empty()) return unusable;
  if (const auto unusable = number(row, ColumnId::T, T); !unusable.empty()) return unusable;
  if (const auto unusable = number(row, by_area ? ColumnId::A : ColumnId::a, size); !unusable.empty()) return unusable;
  if (T < 0) return "T < 0";
  if (size <= 0) return by_area ? "A <= 0" : "a <= 0";
  point.P = P / force_unit_;
  point.T = T / force_unit_;
  const double a = (by_area ? std::sqrt(size / pi<double>()) : size) / length_unit_;
  point.A = by_area ? size / (length_unit_ * length_unit_) : area_from_radius(a);
  if (!(std::abs(point.P) <= kMostQuantity) || !(point.T <= kMostQuantity) || !in_range(point.A))
    return "P, T or A is out of range";
  if (edge_load(a, point.P) > 0) {
    const auto measured = measured_toughness(point.P, point.T, a);
    if (!in_range(measured.ratio)) return "the toughness ratio is out of range";
    point.mixity = measured.mixity;
    point.ratio = measured.ratio;
  } else if (use_ == PointUse::toughness) {
    return "y <= 0: the area does not exceed that of Hertz at this load, so no phase angle exists";
  }
  const auto unusable = standard_error(row, ColumnId::sigma_T, point.T, force_unit_, point.sigma_T);
  return unusable.empty() ? standard_error(row, ColumnId::sigma_A, point.A, length_unit_ * length_unit_, point.sigma_A)
                          : unusable;
}

std::string_view PointReader::read_toughness(const CsvRow& row, Point& point) const {
  const bool by_angle = columns_.has(ColumnId::psi);
  double mixity = 0, Gc = 0;
  if (const auto unusable = number(row, by_angle ? ColumnId::psi : ColumnId::mode_ratio, mixity); !unusable.empty())
    return unusable;
  // the double next to pi/2 is what 90 degrees become
  if (mixity < 0 || mixity > (by_angle ? 1.5707963267948968 : 1))
    return by_angle ? "psi outside 0..90 degrees" : "mode_ratio outside 0..1";
  point.mixity = by_angle ? mixity_from_angle(mixity) : mixity_from_mode_ratio(mixity);
  const ColumnId toughness = columns_.has(ColumnId::Gc) ? ColumnId::Gc : ColumnId::Gc_over_GIc;
  if (const auto unusable = number(row, toughness, Gc); !unusable.empty()) return unusable;
  if (Gc <= 0) return "Gc <= 0";
  point.ratio = Gc / ratio_unit_;
  if (!in_range(point.ratio)) return "the toughness ratio is out of range";
  return standard_error(row, ColumnId::sigma_Gc, point.ratio, ratio_unit_, point.sigma_ratio);
}

}  // namespace mixity
