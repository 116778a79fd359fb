#include "dataset/point_reader.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "base/input_error.h"
#include "dataset/energies.h"
#include "dataset/missing_constants.h"
#include "dataset/table/number.h"
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

/// What stands for {P} in "run_{P}mN", in SI. Throws InputError if the name is not of that form.
double load_in_name(const Dataset& data) {
  const std::string& pattern = data.metadata.load_from;
  const std::string name = data.path.substr(data.path.find_last_of('/') + 1);
  const std::size_t at = pattern.find("{P}");
  const std::string before = pattern.substr(0, at), behind = pattern.substr(at + 3);
  const auto fail = [&](const std::string& message) -> double {
    throw InputError(data.path, message + " (load_from is \"" + pattern + "\")");
  };
  // the unit is what can be one of the letters that follow, at once or behind a blank or a sign that parts words
  const std::size_t begin_of_unit = std::min(behind.find_first_not_of(" _"), behind.size());
  std::size_t letters = begin_of_unit;
  while (letters < behind.size() && std::isalpha(static_cast<unsigned char>(behind[letters]))) ++letters;
  std::optional<Unit> unit;
  for (std::size_t n = letters; n > begin_of_unit && !unit; --n)
    unit = parse_unit(behind.substr(begin_of_unit, n - begin_of_unit));
  if (!unit || unit->dimension != dimension::force) fail("no unit of force follows the load in the file's name");
  for (std::size_t begin = name.find(before); begin != std::string::npos; begin = name.find(before, begin + 1)) {
    const std::size_t first = begin + before.size();
    std::size_t end = first;
    while (end < name.size() && (std::isdigit(static_cast<unsigned char>(name[end])) || std::strchr("+-.,", name[end])))
      ++end;
    double value = 0;
    NumberStyle style;
    const std::string text = name.substr(first, end - first);
    if (name.compare(end, behind.size(), behind) == 0 && end > first &&
        (parse_number(text, '.', value, &style) || parse_number(text, ',', value, &style))) {
      if (style.doubtful) fail("'" + text + "' in the file's name may be a thousand or a decimal");
      if (text[0] == '-' && first > 0 && std::isalnum(static_cast<unsigned char>(name[first - 1])))
        fail("'-' in the file's name may be a sign or part two words; write it into load_from where it parts them");
      return value * unit->factor;
    }
    if (begin + 1 >= name.size()) break;
  }
  return fail("the file's name states no load");
}

std::optional<double> stated_load(const Dataset& data) {
  return data.metadata.load_from.empty() ? data.metadata.load : std::optional(load_in_name(data));
}

/// The values; throws MissingConstants, which names all that are not stated.
std::vector<double> demand(const std::vector<std::pair<std::string, std::optional<double>>>& constants,
                           const std::string& path, const std::string& metadata_path) {
  std::vector<double> values;
  std::vector<std::string> missing;
  std::string names, flags;
  for (const auto& [name, value] : constants) {
    values.push_back(value.value_or(0));
    if (value) continue;
    names += (names.empty() ? "" : ", ") + name;
    flags += (flags.empty() ? "--" : ", --") + name + "=...";
    missing.push_back(name);
  }
  if (missing.empty()) return values;
  const bool several = missing.size() > 1;
  throw MissingConstants(path,
                         "needs " + names + " to be made dimensionless: state " + (several ? "them" : "it") + " in " +
                             metadata_path + " or by " + (several ? "flags" : "a flag") + " (" + flags + ")",
                         missing);
}

}  // namespace

PointReader::PointReader(const std::string& metadata_path, const std::vector<Heading>& headings, Dataset& data)
    : load_(stated_load(data)), data_(data), columns_(data.path, headings, rules_of(data.metadata)) {
  if (columns_.has(ColumnId::P) && load_) {
    load_.reset();
    data_.notes.emplace_back(kLoadNotUsed);
  }
  data_.has_loads = columns_.holds_loads();
  data_.has_energies = columns_.holds_energies();
  data_.ignored_columns = columns_.ignored();
  require_constants(metadata_path);
  add_notes();
  if (data_.contact) set_display();
  if (!data_.has_loads) set_energy_display();
  if (columns_.has(ColumnId::P) && !columns_.has(ColumnId::include) && !has_axes()) set_wanted();
}

void PointReader::require_constants(const std::string& metadata_path) {
  const Metadata& stated = data_.metadata;
  if (!data_.has_loads) {
    const Column* Gc = toughness_column();
    if (!Gc || Gc->unit.dimension == dimension::none) return;
    data_.toughness_known = stated.toughness || !data_.has_energies;
    if (data_.toughness_known) ratio_unit_ = demand({{"toughness", stated.toughness}}, data_.path, metadata_path)[0];
    return;
  }
  const Column* const kind = columns_.find(columns_.has(ColumnId::P) ? ColumnId::P : ColumnId::T);
  if (kind->unit.dimension == dimension::none) {
    if (load_) throw InputError(data_.path, "states a load in a unit, but its columns have none");
    return;
  }
  const auto known =
      demand({{"radius", stated.radius}, {"modulus", stated.plane_strain_modulus()}, {"toughness", stated.toughness}},
             data_.path, metadata_path);
  data_.contact = Contact{known[0], known[1], known[2]};
  force_unit_ = data_.contact->force_unit();
  length_unit_ = data_.contact->length_unit();
  if (!data_.contact->usable()) throw InputError(data_.path, "radius, modulus and toughness together are out of range");
}

void PointReader::add_notes() {
  for (const std::string_view name : {"toughness_II", "shear_strength"})
    if (data_.metadata.standard_error(name) > 0)
      data_.notes.push_back("the standard error of " + std::string(name) +
                            " is in no result: its value is taken as exact");
  std::string constants;
  const auto unused = [&](bool stated, std::string_view name) {
    if (stated) constants += (constants.empty() ? "" : ", ") + std::string(name);
  };
  const Column* Gc = toughness_column();
  if (data_.has_loads && !data_.contact) {
    unused(data_.metadata.radius.has_value(), "radius");
    unused(data_.metadata.plane_strain_modulus().has_value(), "modulus");
    unused(data_.metadata.toughness.has_value(), "toughness");
  } else if (Gc && Gc->unit.dimension == dimension::none) {
    unused(data_.metadata.toughness.has_value(), "toughness");
  }
  const std::string taken = data_.has_loads      ? "the columns have no unit and are taken as dimensionless"
                            : data_.has_energies ? "G_I and G_II have no unit and are taken for G_I/GIc and G_II/GIc"
                                                 : "Gc has no unit and is taken for Gc/GIc";
  if (!constants.empty()) data_.notes.push_back(taken + ": " + constants + " (stated) not used");
  for (const std::string& one : columns_.taken())
    if (one.starts_with("sigma_")) data_.notes.push_back("standard errors: " + one);
  if (!columns_.beside().empty())
    data_.notes.push_back(
        "one run is read and those beside it are not: " + columns_.beside() +
        " have the names of its columns but for a number; they are to stand below it, or in files of their own");
  for (const auto& [name, quantity] : columns_.misspelt())
    data_.notes.push_back("column '" + name + "' is not used; it is read if it is called '" + quantity + "'");
}

void PointReader::set_display() {
  DisplayUnits& display = data_.display;
  if (const Column* shear = columns_.find(ColumnId::T)) {
    display.force = shear->unit.text;
    display.force_scale = data_.contact->force_unit() / shear->unit.factor;
  }
  const Column *area = columns_.find(ColumnId::A), *length = columns_.find(ColumnId::a);
  if (!area && !length) length = columns_.find(columns_.has(ColumnId::a_par) ? ColumnId::a_par : ColumnId::major);
  const Column& size = area ? *area : *length;
  const auto parsed = parse_unit(size.unit.text);
  if (parsed && parsed->dimension.pixel != 0) {  // nobody thinks in pixels
    display.area = "mm^2";
    display.area_scale = data_.contact->area_unit() / 1e-6;
  } else if (area) {
    display.area = area->unit.text;
    display.area_scale = data_.contact->area_unit() / area->unit.factor;
  } else {
    display.area = length->unit.text + "^2";
    display.area_scale = data_.contact->area_unit() / (length->unit.factor * length->unit.factor);
  }
  if (!in_range(display.force_scale) || !in_range(display.area_scale))
    throw InputError(data_.path, "the units of its columns are out of range beside radius, modulus and toughness");
}

void PointReader::set_energy_display() {
  const Column* Gc = toughness_column();
  if (!Gc || Gc->unit.dimension == dimension::none) return;
  data_.display.energy = Gc->unit.text;
  data_.display.energy_scale = ratio_unit_ / Gc->unit.factor;
  if (!in_range(data_.display.energy_scale))
    throw InputError(data_.path,
                     "the unit of " + std::string(to_string(Gc->id)) + " is out of range beside the toughness");
}

void PointReader::set_wanted() {
  wanted_.emplace().count = columns_.count();
  for (std::size_t i = 0; i < kColumnCount; ++i) {
    const Column* column = columns_.find(static_cast<ColumnId>(i));
    if (!column) continue;
    place_[i] = wanted_->numbers.size();
    (column->id == ColumnId::curve ? wanted_->texts : wanted_->numbers).push_back(column->index);
  }
}

std::optional<std::string_view> PointReader::run_name(const CsvRow& row) const {
  const Column* column = columns_.find(ColumnId::curve);
  return column && !row[column->index].empty() ? std::optional(row[column->index]) : std::nullopt;
}

std::optional<std::string_view> PointReader::run_name(const CsvNumbers& rows, std::size_t i) const {
  if (!columns_.has(ColumnId::curve)) return std::nullopt;
  const std::string_view name = rows.text(0, i);
  return name.empty() ? std::nullopt : std::optional(name);
}

bool PointReader::resembles_data(const CsvRow& comment) const {
  return comment.size() >= columns_.count() && holds_a_number(comment);
}

std::string_view PointReader::read(const CsvRow& row, ReadPoint& point) const {
  require_width(data_.path, row, columns_.count());
  if (const Column* include = columns_.find(ColumnId::include)) {
    const std::string_view text = row[include->index];
    if (text != "0" && text != "1")
      throw InputError(data_.path, row.place(include->index),
                       "column 'include': '" + printable(text, 60) + "' is neither 0 nor 1");
    if (text == "0") return "include = 0";
  }
  point = {};
  point.point.line = row.line();
  return data_.has_loads      ? read_loads(row, point)
         : data_.has_energies ? read_energies(row, point)
                              : read_toughness(row, point);
}

/// In SI or as it stands.
std::string_view PointReader::number(const CsvRow& row, ColumnId id, double& value) const {
  const Column& column = *columns_.find(id);
  if (!number_at(data_.path, row, column.index, to_string(id), value)) return said_of(id, kEmpty);
  value *= column.unit.factor;
  return std::isfinite(value) ? std::string_view() : said_of(id, kNotFinite);
}

/// In the units of what it is the error `of`; left as it is where the column or the field is missing.
std::string_view PointReader::standard_error(const CsvRow& row, ColumnId id, double of, double unit,
                                             double& error) const {
  const Column* column = columns_.find(id);
  if (!column || row[column->index].empty()) return {};
  if (const auto unusable = number(row, id, error); !unusable.empty()) return unusable;
  if (error < 0) return said_of(id, kNegative);
  error = column->unit.text == "%" ? error * std::abs(of) : error / unit;
  return error == 0 || in_range(error) ? std::string_view() : said_of(id, kOutOfRange);
}

/// The area of an ellipse, of semi-axes or of whole ones.
std::string_view PointReader::read_axes(const CsvRow& row, double& area, ReadPoint& read) const {
  const bool halves = columns_.has(ColumnId::a_par);
  double one = 0, other = 0;
  if (const auto unusable = number(row, halves ? ColumnId::a_par : ColumnId::major, one); !unusable.empty())
    return unusable;
  if (const auto unusable = number(row, halves ? ColumnId::a_perp : ColumnId::minor, other); !unusable.empty())
    return unusable;
  if (!(one > 0) || !(other > 0)) return "an axis of the ellipse <= 0";
  area = std::numbers::pi * one * other / (halves ? 1 : 4);
  read.axes = one > other ? one / other : other / one;
  return {};
}

std::string_view PointReader::read_loads(const CsvRow& row, ReadPoint& read) const {
  const bool by_radius = columns_.has(ColumnId::a), by_area = !by_radius;
  double P = load_.value_or(0), T = 0, size = 0;
  if (const auto unusable = load_ ? std::string_view() : number(row, ColumnId::P, P); !unusable.empty())
    return unusable;
  if (const auto unusable = number(row, ColumnId::T, T); !unusable.empty()) return unusable;
  if (has_axes())
    if (const auto unusable = read_axes(row, size, read); !unusable.empty()) return unusable;
  if (by_radius || columns_.has(ColumnId::A))
    if (const auto unusable = number(row, by_area ? ColumnId::A : ColumnId::a, size); !unusable.empty())
      return unusable;
  if (size <= 0) return by_area ? "A <= 0" : "a <= 0";
  Point& point = read.point;
  point.P = P / force_unit_ + 0.0;  // a load of -0 is one of 0
  point.T = T / force_unit_;
  const double area_unit = length_unit_ * length_unit_;
  point.A = by_area ? size / area_unit : area_from_radius(size / length_unit_);
  if (!(std::abs(point.P) <= kMostQuantity) || !(point.shear() <= kMostQuantity) || !in_range(point.A))
    return "P, T or A is out of range";
  const double a = radius_from_area(point.A), y = edge_load(a, point.P);
  if (y > 0 && !in_range(toughness_ratio(y, point.T, a))) return kOutOfRangeRatio;
  const auto unusable = standard_error(row, ColumnId::sigma_T, point.T, force_unit_, read.errors.T);
  return unusable.empty() ? standard_error(row, ColumnId::sigma_A, point.A, area_unit, read.errors.A) : unusable;
}

void PointReader::read(const CsvNumbers& rows, PointBatch& batch) const {
  const std::size_t n = rows.size();
  const auto scaled = [&](ColumnId id, double unit, PointBatch::Values<double>& values) {
    const double *const in = rows.numbers(place_[static_cast<std::size_t>(id)]),
                        factor = columns_.find(id)->unit.factor;
    for (std::size_t i = 0; i < n; ++i) values[i] = in[i] * factor / unit;
  };
  const double area_unit = length_unit_ * length_unit_;
  scaled(ColumnId::P, force_unit_, batch.P);
  for (std::size_t i = 0; i < n; ++i) batch.P[i] += 0.0;  // a load of -0 is one of 0
  scaled(ColumnId::T, force_unit_, batch.T);
  if (columns_.has(ColumnId::A)) {
    scaled(ColumnId::A, area_unit, batch.A);
  } else {
    scaled(ColumnId::a, length_unit_, batch.A);
    for (std::size_t i = 0; i < n; ++i) batch.A[i] = batch.A[i] > 0 ? area_from_radius(batch.A[i]) : 0;
  }
  toughness_ratios(batch.P.data(), batch.T.data(), batch.A.data(), batch.toughness_ratio.data(), n);
  for (std::size_t i = 0; i < n; ++i) {
    const double ratio = batch.toughness_ratio[i];
    batch.usable[i] = std::abs(batch.P[i]) <= kMostQuantity && std::abs(batch.T[i]) <= kMostQuantity &&
                      in_range(batch.A[i]) && (in_range(ratio) || ratio < 0);
  }
  const auto standard_errors = [&](ColumnId id, const PointBatch::Values<double>& of, double unit,
                                   PointBatch::Values<double>& errors) {
    errors.fill(kNotStated);
    const Column* column = columns_.find(id);
    if (!column) return;
    const bool relative = column->unit.text == "%";
    scaled(id, relative ? 1 : unit, errors);
    for (std::size_t i = 0; i < n; ++i) {
      if (relative) errors[i] *= std::abs(of[i]);
      batch.usable[i] &= errors[i] == 0 || in_range(errors[i]);
    }
  };
  if (!has_errors()) return;
  standard_errors(ColumnId::sigma_T, batch.T, force_unit_, batch.sigma_T);
  standard_errors(ColumnId::sigma_A, batch.A, area_unit, batch.sigma_A);
}

std::string_view PointReader::read_toughness(const CsvRow& row, ReadPoint& read) const {
  const bool by_angle = columns_.has(ColumnId::psi);
  double mixity = 0, Gc = 0;
  if (const auto unusable = number(row, by_angle ? ColumnId::psi : ColumnId::mode_ratio, mixity); !unusable.empty())
    return unusable;
  if (mixity < 0 || mixity > (by_angle ? kLargestPhaseAngle : 1))
    return by_angle ? "psi outside 0..90 degrees" : "mode_ratio outside 0..1";
  ToughnessPoint& point = read.converted;
  point.mixity = by_angle ? mixity_from_angle(mixity) : mixity_from_mode_ratio(mixity);
  const ColumnId toughness = columns_.has(ColumnId::Gc) ? ColumnId::Gc : ColumnId::Gc_over_GIc;
  if (const auto unusable = number(row, toughness, Gc); !unusable.empty()) return unusable;
  if (Gc <= 0) return "Gc <= 0";
  point.ratio = Gc / ratio_unit_;
  if (!in_range(point.ratio)) return kOutOfRangeRatio;
  return standard_error(row, ColumnId::sigma_Gc, point.ratio, ratio_unit_, read.errors.ratio);
}

std::string_view PointReader::read_energies(const CsvRow& row, ReadPoint& read) const {
  double G_I = 0, G_II = 0;
  if (const auto unusable = number(row, ColumnId::G_I, G_I); !unusable.empty()) return unusable;
  if (const auto unusable = number(row, ColumnId::G_II, G_II); !unusable.empty()) return unusable;
  PointEnergies& energies = read.energies;
  energies.G_I = G_I / ratio_unit_;
  energies.G_II = G_II / ratio_unit_;
  if (!(std::abs(energies.G_I) <= kMostQuantity)) return said_of(ColumnId::G_I, kOutOfRange);
  if (!(std::abs(energies.G_II) <= kMostQuantity)) return said_of(ColumnId::G_II, kOutOfRange);
  if (const auto unusable = convert(energies, read.converted); !unusable.empty()) return unusable;
  if (const auto unusable = standard_error(row, ColumnId::sigma_GI, energies.G_I, ratio_unit_, energies.sigma_GI);
      !unusable.empty())
    return unusable;
  const auto unusable = standard_error(row, ColumnId::sigma_GII, energies.G_II, ratio_unit_, energies.sigma_GII);
  read.errors.ratio = error_of_sum(energies);
  return unusable;
}

}  // namespace mixity
