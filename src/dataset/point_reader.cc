#include "dataset/point_reader.h"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/input_error.h"
#include "dataset/energies.h"
#include "mechanics/held_approach.h"
#include "mechanics/measurement.h"

namespace mixity {
namespace {

enum Problem { kEmpty, kMissing, kNotFinite, kNegative, kOutOfRange };

/// Why the value of a column cannot be used, as a fixed text, since a file may have millions of such values.
std::string_view reason_of(ColumnId id, Problem problem) {
  static const auto kTexts = [] {
    std::array<std::array<std::string, 5>, kColumnCount> texts;
    for (std::size_t i = 0; i < kColumnCount; ++i)
      for (std::size_t k = 0; k < 5; ++k)
        texts[i][k] = std::string(to_string(static_cast<ColumnId>(i))) +
                      std::array{" is empty", " is missing", " is not finite", " < 0", " is out of range"}[k];
    return texts;
  }();
  return kTexts[static_cast<std::size_t>(id)][problem];
}

}  // namespace

/// The numbers of a row, up to the first that cannot be used.
struct PointReader::Numbers {
  const std::string& path;
  const Columns& columns;
  const CsvRow& row;
  std::string_view unusable{};  // the reason; empty: none so far

  /// The number in a column, in SI. `error`: receives the standard error stated in the field; null: none is allowed.
  double operator()(ColumnId id, double* error = nullptr) {
    double value = 0;
    if (!unusable.empty()) return value;
    const Column& column = *columns.find(id);
    if (!number_at(path, row, column.index, to_string(id), value, error))
      unusable = reason_of(id, row[column.index].empty() ? kEmpty : kMissing);  // "NA", -9999
    else if (!std::isfinite(value *= column.unit.factor))
      unusable = reason_of(id, kNotFinite);
    if (error && *error >= 0) *error *= column.unit.factor;
    return value;
  }
  /// The same for a quantity whose standard error is in the column `sigma` if there is one.
  double with_error(ColumnId id, ColumnId sigma, double& in_field) {
    return (*this)(id, columns.has(sigma) ? nullptr : &in_field);
  }

  /// Sets the standard error of a quantity with the value `of`, in the same unit. Leaves it unchanged if the column or
  /// the field is missing. `in_field`: the error stated in the value's field, in SI.
  void standard_error(ColumnId id, double of, double unit, double in_field, double& error) {
    const Column* column = columns.find(id);
    const bool in_column = column && !row[column->index].empty();
    if (!unusable.empty() || (!in_column && in_field < 0)) return;
    error = in_column ? (*this)(id) : in_field;
    if (!unusable.empty()) return;
    if (error < 0) unusable = reason_of(id, kNegative);
    error = in_column && column->unit.text == "%" ? error * std::abs(of) : error / unit;
    if (unusable.empty() && error != 0 && !in_range(error)) unusable = reason_of(id, kOutOfRange);
  }
};

PointReader::PointReader(const std::string& metadata_path, const std::vector<Heading>& headings,
                         const ColumnRules& rules, const std::optional<double>& load, Dataset& data)
    : load_(load ? load : stated_load(data)),
      path_(data.path),
      columns_(data.path, headings, rules),
      clocks_(data.path, headings, columns_, rules) {
  if (columns_.has(ColumnId::P) && load_) {
    load_.reset();
    data.notes.emplace_back(kLoadNotUsed);
  }
  require_units(columns_, headings, load_.has_value(), metadata_path, data);
  require_shear(columns_, headings, data);
  units_ = take_header(columns_, metadata_path, data);
  compliance_ = data.compliance;
}

std::string_view PointReader::read(const CsvRow& row, ReadPoint& point) {
  require_width(path_, row, columns_.count, columns_.needed);
  clocks_.take(row);
  if (const Column* include = columns_.find(ColumnId::include)) {
    const std::string_view text = row[include->index];
    if (text != "0" && text != "1")
      throw InputError(path_, row.place(include->index),
                       "column 'include': '" + printable(text, 60) + "' is neither 0 nor 1");
    if (text == "0") return "include = 0";
  }
  point = {};
  point.point.line = line_of_point(path_, row.line());
  Numbers numbers{path_, columns_, row};
  const std::string_view reason = columns_.holds_pull_off()   ? read_pull_off(numbers, point)
                                  : columns_.holds_loads()    ? read_loads(numbers, point)
                                  : columns_.holds_energies() ? read_energies(numbers, point)
                                                              : read_toughness(numbers, point);
  return numbers.unusable.empty() ? reason : numbers.unusable;
}

// Each returns why the numbers are not a point. If one of them cannot be used, Numbers::unusable has the reason.

std::string_view PointReader::read_loads(Numbers& number, ReadPoint& read) const {
  const ContactLengths* const lengths = columns_.lengths();
  double in_T = kNotStated, in_A = kNotStated;  // errors
  const bool approach = columns_.has(ColumnId::delta);
  const double P = approach ? number(ColumnId::delta)
                   : load_  ? *load_
                            : number(ColumnId::P),
               T = number.with_error(ColumnId::T, ColumnId::sigma_T, in_T);
  double area = 0;
  if (lengths && !lengths->round()) {
    if (const std::string_view why = read_axes(*lengths, number, area, in_A, read); !why.empty()) return why;
    if (columns_.has(ColumnId::A)) in_A = kNotStated;
  }
  if (columns_.has(ColumnId::A)) {
    const double of_axes = area;
    area = number.with_error(ColumnId::A, ColumnId::sigma_A, in_A);
    // beside an area the axes may have any unit, such as pixels
    const bool alike = of_axes > 0 && (columns_.find(lengths->one)->unit.dimension == dimension::none) ==
                                          (columns_.find(ColumnId::A)->unit.dimension == dimension::none);
    if (alike) read.beside_axes = area / of_axes - 1;
  }
  const bool by_radius = lengths && lengths->round() && !columns_.has(ColumnId::A);
  const double radius = by_radius ? number(lengths->one) / std::sqrt(lengths->parts) : 0;
  if (by_radius && radius <= 0) return lengths->one == ColumnId::a ? "a <= 0" : "diameter <= 0";
  if (!by_radius && area <= 0) return "A <= 0";
  Point& point = read.point;
  point.P = P / (approach ? units_.displacement : units_.force) + 0.0;  // -0 becomes 0
  point.T = T / units_.force;
  const double area_unit = units_.length * units_.length;
  point.A = by_radius ? area_from_radius(radius / units_.length) : area / area_unit;
  if (!(std::abs(point.P) <= kMostQuantity) || !(point.shear() <= kMostQuantity) || !in_range(point.A))
    return approach ? "delta, T or A is out of range" : "P, T or A is out of range";
  const double a = radius_from_area(point.A),
               y = approach ? HeldApproach{point.P, compliance_}.edge_load(a).value : edge_load(a, point.P);
  if (y > 0 && !in_range(toughness_ratio(y, point.T, a))) return kOutOfRangeRatio;
  if (approach && columns_.has(ColumnId::P)) {
    double in_P = kNotStated, sigma_P = kNotStated;
    read.load.q = number.with_error(ColumnId::P, ColumnId::sigma_P, in_P) / units_.force;
    if (!(std::abs(read.load.q) <= kMostQuantity)) return "P is out of range";
    number.standard_error(ColumnId::sigma_P, read.load.q, units_.force, in_P, sigma_P);
    if (sigma_P > 0) read.load.sigma_q = sigma_P;
  }
  number.standard_error(ColumnId::sigma_T, point.T, units_.force, in_T, read.errors.T);
  number.standard_error(ColumnId::sigma_A, point.A, area_unit, in_A, read.errors.A);
  read.states_errors = in_T >= 0 || (in_A >= 0 && !columns_.has(ColumnId::sigma_a_par));
  return {};
}

std::string_view PointReader::read_pull_off(Numbers& number, ReadPoint& read) const {
  const bool by_load = columns_.has(ColumnId::T);
  const ColumnId held = by_load ? ColumnId::T : ColumnId::u, sigma = by_load ? ColumnId::sigma_T : ColumnId::sigma_u;
  double in_P = kNotStated, in_shear = kNotStated;
  const double P = number.with_error(ColumnId::P_c, ColumnId::sigma_P, in_P),
               shear = number.with_error(held, sigma, in_shear), unit = by_load ? units_.force : units_.displacement;
  PullOffReading& reading = read.pull_off;
  reading.line = read.point.line;
  reading.held = by_load ? HeldShear::load : HeldShear::displacement;
  reading.P = P / units_.force + 0.0;
  reading.shear = shear / unit;
  if (!(std::abs(reading.P) <= kMostQuantity) || !(std::abs(reading.shear) <= kMostPullOffShear))
    return "P_c, T or u is out of range";
  number.standard_error(ColumnId::sigma_P, reading.P, units_.force, in_P, reading.sigma_P);
  number.standard_error(sigma, reading.shear, unit, in_shear, reading.sigma_shear);
  return {};
}

/// Sets the ratio of the axes of an ellipse and, in SI, its area with its standard error.
std::string_view PointReader::read_axes(const ContactLengths& lengths, Numbers& number, double& area, double& sigma_A,
                                        ReadPoint& read) const {
  PointAxes& axes = read.axes;
  double in_one = kNotStated, in_other = kNotStated;
  const double one = number.with_error(lengths.one, ColumnId::sigma_a_par, in_one),
               other = number.with_error(lengths.other, ColumnId::sigma_a_perp, in_other);
  if (!(one > 0) || !(other > 0)) return "an axis of the ellipse <= 0";
  area = std::numbers::pi * one * other / lengths.parts;
  std::optional<double> turn;
  if (const Column* const angle = lengths.one == ColumnId::major ? columns_.find(ColumnId::angle) : nullptr)
    turn = number(ColumnId::angle) * (angle->unit.dimension == dimension::none ? std::numbers::pi / 180 : 1);
  read.turn = turn.value_or(0);
  const double turned = turn_of_axes(lengths, turn);
  axes.q = std::log(one / other) * turned;
  read.direction = std::polar(std::pow(std::log(one / other), 2), 4 * turn.value_or(0));
  // the columns state errors of semi-axes
  const double half = lengths.parts == 4 ? 2 : 1;
  double sigma_one = kNotStated, sigma_other = kNotStated;
  number.standard_error(ColumnId::sigma_a_par, one / half, 1, in_one / half, sigma_one);
  number.standard_error(ColumnId::sigma_a_perp, other / half, 1, in_other / half, sigma_other);
  if (!(sigma_one > 0) || !(sigma_other > 0)) return {};
  const double share_one = half * sigma_one / one, share_other = half * sigma_other / other;
  axes.sigma_q = std::hypot(share_one, share_other);
  axes.correlation = (share_one - share_other) * (share_one + share_other) / (axes.sigma_q * axes.sigma_q) * turned;
  sigma_A = area * axes.sigma_q;
  return {};
}

std::string_view PointReader::read_toughness(Numbers& number, ReadPoint& read) const {
  const bool by_angle = columns_.has(ColumnId::psi);
  double mixity = number(by_angle ? ColumnId::psi : ColumnId::mode_ratio);
  read.negative_angle = by_angle && mixity < 0;
  if (read.negative_angle) mixity = -mixity;
  if (mixity < 0 || mixity > (by_angle ? kLargestPhaseAngle : 1))
    return by_angle ? "psi outside 0..90 degrees" : "mode_ratio outside 0..1";
  double in_Gc = kNotStated;
  const double Gc =
      number.with_error(columns_.has(ColumnId::Gc) ? ColumnId::Gc : ColumnId::Gc_over_GIc, ColumnId::sigma_Gc, in_Gc);
  if (Gc <= 0) return "Gc <= 0";
  ToughnessPoint& point = read.converted;
  point.mixity = by_angle ? mixity_from_angle(mixity) : mixity_from_mode_ratio(mixity);
  point.ratio = Gc / units_.ratio;
  if (!in_range(point.ratio)) return kOutOfRangeRatio;
  number.standard_error(ColumnId::sigma_Gc, point.ratio, units_.ratio, in_Gc, read.errors.ratio);
  read.states_errors = in_Gc >= 0;
  return {};
}

std::string_view PointReader::read_energies(Numbers& number, ReadPoint& read) const {
  PointEnergies& energies = read.energies;
  double in_GI = kNotStated, in_GII = kNotStated;
  energies.G_I = number.with_error(ColumnId::G_I, ColumnId::sigma_GI, in_GI) / units_.ratio;
  energies.G_II = number.with_error(ColumnId::G_II, ColumnId::sigma_GII, in_GII) / units_.ratio;
  if (!(std::abs(energies.G_I) <= kMostQuantity)) return reason_of(ColumnId::G_I, kOutOfRange);
  if (!(std::abs(energies.G_II) <= kMostQuantity)) return reason_of(ColumnId::G_II, kOutOfRange);
  if (const auto unusable = convert(energies, read.converted); !unusable.empty()) return unusable;
  number.standard_error(ColumnId::sigma_GI, energies.G_I, units_.ratio, in_GI, energies.sigma_GI);
  number.standard_error(ColumnId::sigma_GII, energies.G_II, units_.ratio, in_GII, energies.sigma_GII);
  read.states_errors = in_GI >= 0 || in_GII >= 0;
  read.errors.ratio = error_of_sum(energies);
  return {};
}

}  // namespace mixity
