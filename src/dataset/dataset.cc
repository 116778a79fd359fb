#include "dataset/dataset.h"

#include <cmath>
#include <filesystem>
#include <map>

#include "dataset/columns.h"
#include "dataset/csv.h"
#include "dataset/input_error.h"
#include "dataset/number_text.h"
#include "mechanics/measurement.h"

namespace mixity {
namespace {

/// What is positive in nature is so as a number, too: neither underflow nor overflow.
bool in_range(double value) { return std::isfinite(value) && value > 0; }

/// Reads the rows of one file into a data set.
class Loader {
 public:
  Loader(const std::string& path, const std::string& metadata_path, PointUse use, Dataset& data)
      : path_(path), metadata_path_(metadata_path), use_(use), data_(data) {}

  void row(const CsvRow& row) {
    if (!columns_) {
      columns_.emplace(path_, row);
      prepare();
    } else {
      ++data_.rows;
      require_width(path_, row, columns_->count());
      read_point(row);
    }
  }

  bool has_header() const { return columns_.has_value(); }

 private:
  double demand(std::optional<double> value, const std::string& key) const {
    if (value) return *value;
    throw InputError(path_, "needs " + key + " to be made dimensionless: state it in " + metadata_path_ +
                                " or by a flag (--" + key + "=...)");
  }

  void prepare() {
    data_.has_loads = columns_->holds_loads();
    data_.ignored_columns = columns_->ignored();
    if (!data_.has_loads) {
      const Column* Gc = columns_->find(ColumnId::Gc);
      if (Gc && Gc->unit.dimension != dimension::none) ratio_unit_ = demand(data_.metadata.toughness, "toughness");
      return;
    }
    const Unit& force = columns_->find(ColumnId::P)->unit;
    if (force.dimension == dimension::none) return;
    data_.contact =
        Contact{demand(data_.metadata.radius, "radius"), demand(data_.metadata.plane_strain_modulus(), "modulus"),
                demand(data_.metadata.toughness, "toughness")};
    for (const double unit : {data_.contact->force_unit(), data_.contact->length_unit(), data_.contact->area_unit()})
      if (!in_range(unit)) throw InputError(path_, "radius, modulus and toughness together are out of range");
    const Unit& shear = columns_->find(ColumnId::T)->unit;
    data_.display.force = shear.text;
    data_.display.force_scale = data_.contact->force_unit() / shear.factor;
    const Column* area = columns_->find(ColumnId::A);
    const Unit& unit = area ? area->unit : columns_->find(ColumnId::a)->unit;
    data_.display.area = area ? unit.text : unit.text + "^2";
    data_.display.area_scale = data_.contact->area_unit() / (area ? unit.factor : unit.factor * unit.factor);
    if (!in_range(data_.display.force_scale) || !in_range(data_.display.area_scale))
      throw InputError(path_, "the units of its columns are out of range beside radius, modulus and toughness");
  }

  /// The field of a column in SI or as it stands; null if it is empty.
  std::optional<double> number(const CsvRow& row, ColumnId id) const {
    const Column* column = columns_->find(id);
    if (!column) return std::nullopt;
    const auto value = number_at(path_, row, column->index, to_string(id));
    if (!value) return std::nullopt;
    return *value * column->unit.factor;
  }

  void exclude(const CsvRow& row, std::string reason) { data_.excluded.push_back({row.line(), std::move(reason)}); }

  void read_point(const CsvRow& row) {
    if (const Column* include = columns_->find(ColumnId::include)) {
      const std::string_view text = trim(row[include->index]);
      if (text != "0" && text != "1")
        throw InputError(path_, row.line(), row.column(include->index),
                         "column 'include': '" + printable(text, 60) + "' is neither 0 nor 1");
      if (text == "0") return exclude(row, "include = 0");
    }
    Point point{};
    point.line = row.line();
    if (data_.has_loads ? read_loads(row, point) : read_toughness(row, point)) {
      point.curve = curve_of(row, point);
      data_.points.push_back(point);
    }
  }

  /// A value that must be there and finite; excludes the row and returns null otherwise.
  std::optional<double> finite(const CsvRow& row, ColumnId id) {
    const auto value = number(row, id);
    const std::string name(to_string(id));
    if (!value) return exclude(row, name + " is empty"), std::nullopt;
    if (!std::isfinite(*value)) return exclude(row, name + " is not finite"), std::nullopt;
    return value;
  }

  /// A standard error in the units of `value`; 0 where the column or the field is missing.
  std::optional<double> sigma(const CsvRow& row, ColumnId id, double value, double unit) {
    const Column* column = columns_->find(id);
    if (!column || trim(row[column->index]).empty()) return 0.0;
    const auto error = finite(row, id);
    if (!error) return std::nullopt;
    if (*error < 0) return exclude(row, std::string(to_string(id)) + " < 0"), std::nullopt;
    const double result = column->unit.text == "%" ? *error * std::abs(value) : *error / unit;
    if (!std::isfinite(result)) return exclude(row, std::string(to_string(id)) + " is out of range"), std::nullopt;
    return result;
  }

  bool read_loads(const CsvRow& row, Point& point) {
    const double force = data_.contact ? data_.contact->force_unit() : 1;
    const double length = data_.contact ? data_.contact->length_unit() : 1;
    const bool by_area = columns_->has(ColumnId::A);
    const auto P = finite(row, ColumnId::P);
    const auto T = P ? finite(row, ColumnId::T) : std::nullopt;
    const auto size = T ? finite(row, by_area ? ColumnId::A : ColumnId::a) : std::nullopt;
    if (!size) return false;
    if (*T < 0) return exclude(row, "T < 0"), false;
    if (*size <= 0) return exclude(row, by_area ? "A <= 0" : "a <= 0"), false;
    point.P = *P / force;
    point.T = *T / force;
    const double a = (by_area ? std::sqrt(*size / pi<double>()) : *size) / length;
    point.A = by_area ? *size / (length * length) : area_from_radius(a);
    if (!std::isfinite(point.P) || !std::isfinite(point.T) || !in_range(point.A))
      return exclude(row, "P, T or A is out of range"), false;
    if (edge_load(a, point.P) > 0) {
      const auto measured = measured_toughness(point.P, point.T, a);
      if (!in_range(measured.ratio)) return exclude(row, "the toughness ratio is out of range"), false;
      point.mixity = measured.mixity;
      point.ratio = measured.ratio;
      point.psi = phase_angle(point.mixity);
    } else if (use_ == PointUse::toughness) {
      return exclude(row, "y <= 0: the area does not exceed that of Hertz at this load, so no phase angle exists"),
             false;
    }
    const auto sigma_T = sigma(row, ColumnId::sigma_T, point.T, force);
    const auto sigma_A = sigma_T ? sigma(row, ColumnId::sigma_A, point.A, length * length) : std::nullopt;
    if (!sigma_A) return false;
    point.sigma_T = *sigma_T;
    point.sigma_A = *sigma_A;
    return true;
  }

  bool read_toughness(const CsvRow& row, Point& point) {
    if (columns_->has(ColumnId::psi)) {
      const auto psi = finite(row, ColumnId::psi);
      if (!psi) return false;
      // the double next to pi/2 is what 90 degrees become
      if (*psi < 0 || *psi > 1.5707963267948968) return exclude(row, "psi outside 0..90 degrees"), false;
      point.mixity = mixity_from_angle(*psi);
    } else {
      const auto ratio = finite(row, ColumnId::mode_ratio);
      if (!ratio) return false;
      if (*ratio < 0 || *ratio > 1) return exclude(row, "mode_ratio outside 0..1"), false;
      point.mixity = mixity_from_mode_ratio(*ratio);
    }
    point.psi = phase_angle(point.mixity);
    const auto Gc = finite(row, columns_->has(ColumnId::Gc) ? ColumnId::Gc : ColumnId::Gc_over_GIc);
    if (!Gc) return false;
    if (*Gc <= 0) return exclude(row, "Gc <= 0"), false;
    point.ratio = *Gc / ratio_unit_;
    if (!in_range(point.ratio)) return exclude(row, "the toughness ratio is out of range"), false;
    const auto error = sigma(row, ColumnId::sigma_Gc, point.ratio, ratio_unit_);
    if (!error) return false;
    point.sigma_ratio = *error;
    return true;
  }

  /// Points belong together by their curve column; failing that, by equal load.
  std::size_t curve_of(const CsvRow& row, const Point& point) {
    const Column* column = columns_->find(ColumnId::curve);
    std::string key;
    if (column)
      key = trim(row[column->index]);
    else if (data_.has_loads)
      key = "P=" + rounded(point.P * data_.display.force_scale, 6) +
            (data_.display.force.empty() ? "" : " " + data_.display.force);
    const auto [found, is_new] = curve_index_.try_emplace(key, data_.curves.size());
    if (is_new) {
      data_.curves.push_back(key);
      if (data_.has_loads) data_.curve_loads.push_back(point.P);
    }
    return found->second;
  }

  const std::string& path_;
  const std::string& metadata_path_;
  PointUse use_;
  Dataset& data_;
  std::optional<Columns> columns_;
  std::map<std::string, std::size_t> curve_index_;
  double ratio_unit_ = 1;
};

}  // namespace

std::vector<std::vector<std::size_t>> points_by_curve(const Dataset& data) {
  std::vector<std::vector<std::size_t>> runs(data.curves.size());
  for (std::size_t i = 0; i < data.points.size(); ++i) runs[data.points[i].curve].push_back(i);
  return runs;
}

Dataset load_dataset(const std::string& path, const Overrides& overrides, PointUse use) {
  Dataset data;
  const std::filesystem::path file(path);
  data.path = path;
  data.name = file.stem().string();
  const std::string metadata_path = std::filesystem::path(file).replace_extension(".toml").string();
  data.metadata = read_metadata(metadata_path);
  apply_overrides(overrides, data.metadata);
  const std::string problem = modulus_problem(data.metadata);
  if (!problem.empty()) throw InputError(metadata_path, problem);
  Loader loader(path, metadata_path, use, data);
  read_csv(path, [&](const CsvRow& row) { loader.row(row); });
  if (!loader.has_header()) throw InputError(path, 1, 1, "is empty: a header row is missing");
  if (data.rows == 0) throw InputError(path, 2, 1, "has a header but no data rows");
  return data;
}

}  // namespace mixity
