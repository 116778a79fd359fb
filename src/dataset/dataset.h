// A data set ready to fit: points with phase angle and toughness ratio, made from a CSV and its metadata.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "base/input_error.h"
#include "base/inputs.h"
#include "base/text.h"
#include "dataset/constants.h"
#include "dataset/metadata.h"
#include "mechanics/contact.h"
#include "mechanics/held_approach.h"
#include "mechanics/measurement.h"
#include "mechanics/states.h"

namespace mixity {

/// A usable point. P, T, A are dimensionless, and zero if the data set has no loads. P is the approach where that is
/// held (Dataset::holds_approach). T has its sign from the file,
/// except in reversed runs. A negative T is noise about zero.
struct Point {
  using Index = std::uint32_t;  // of files with millions of rows, each byte of a point counts
  Index line = 0;               // in the CSV; counted through all files if there are several (Dataset::line_text)
  Index curve = 0;              // index into Dataset::curves
  double P = 0, T = 0, A = 0;

  Point() = default;
  Point(std::size_t of_line, std::size_t of_curve, double load, double shear_load, double area)
      : line(static_cast<Index>(of_line)), curve(static_cast<Index>(of_curve)), P(load), T(shear_load), A(area) {}

  /// |T|, since equilibrium depends on T^2.
  double shear() const { return std::abs(T); }
};

/// The number of a line as a point holds it. Throws InputError for a line beyond 2^32.
Point::Index line_of_point(const std::string& path, std::size_t line);

/// Marks a standard error that the file does not state. A stated 0 means that the value is exact.
inline constexpr double kNotStated = -1;

/// Replaces a standard error of 0 where a distance needs errors on both axes; relative to the largest value.
inline constexpr double kLeastError = 1e-4;

/// Standard errors in the units of T, A and the toughness ratio; the last is 0 if the file states none.
struct PointErrors {
  double T = kNotStated, A = kNotStated, ratio = 0;
};

/// Energies of the two modes and their standard errors (or kNotStated), in units of G_Ic. A negative energy is noise
/// about zero; their sum is positive.
struct PointEnergies {
  double G_I = 0, G_II = 0, sigma_GI = kNotStated, sigma_GII = kNotStated;
};

/// q = ln(a/b) of the semi-axes along and across the shear, NaN where it is not known; its standard error, NaN if it is
/// not stated; and the correlation of the errors of q and ln A, 0 where those of a and b are equal.
struct PointAxes {
  double q = std::numeric_limits<double>::quiet_NaN(), sigma_q = q, correlation = 0;
};

/// A load, compression positive, at which a contact is pulled off while a tangential load or displacement is held, and
/// the standard errors of both, dimensionless (or kNotStated).
struct PullOffReading {
  Point::Index line = 0;
  HeldShear held = HeldShear::load;
  double P = 0, shear = 0, sigma_P = kNotStated, sigma_shear = kNotStated;

  /// `common`: of loads that state none.
  double error_of_load(double common) const { return sigma_P < 0 ? common : sigma_P; }
};

/// Why a point has no toughness.
inline constexpr std::string_view kNoPhaseAngle =
    "y <= 0: the area does not exceed that of Hertz at this load, so no phase angle exists";
inline constexpr std::string_view kOutOfRangeRatio = "the toughness ratio is out of range";

/// The note on a load that is stated although the file has a column of loads.
inline constexpr const char* kLoadNotUsed = "the load that is stated is not used: the file has a column of loads";

/// The reason against mode_III = "averaged" with elliptic contacts.
inline constexpr const char* kNoAverage =
    "an average of modes II and III is that of a circle's edge, an ellipse has each where it acts";

/// The reason against offsets: a fixed force or area differs between runs that are scaled to another sphere.
inline constexpr const char* kNoOffsets =
    "its runs are on several spheres: offsets of load, shear and area can be neither stated nor fitted";

struct Excluded {
  std::size_t line;
  std::string_view reason;  // a fixed text, since a file may have millions of excluded rows
};

/// The units of the file: value in file = dimensionless * scale.
struct DisplayUnits {
  std::string force, area, energy;  // as written in the header; empty if dimensionless
  double force_scale = 1, area_scale = 1, energy_scale = 1;
  std::string length{};  // of u
  double length_scale = 1;
  std::string approach{};  // of a held approach, as written in the header
  double approach_scale = 1;
};

/// One of several files that make a data set.
struct SourceFile {
  std::string path;
  std::size_t first_line;  // added to its line numbers
};

/// What a data set is beside its points.
struct DatasetFacts {
  std::string path, name;         // as opened; without folder and extension
  std::vector<SourceFile> files;  // the pooled files in order; empty: only `path`
  std::vector<InputFile> inputs;  // files read: data, their TOML, names of columns; empty for arrays
  Metadata metadata;
  bool has_loads = false;                // (P, T, A) rather than (psi, Gc)
  bool has_energies = false;             // (G_I, G_II) rather than (psi, Gc)
  bool several_spheres = false;          // some runs were scaled to the sphere of `contact`
  bool toughness_known = true;           // false: energies with a unit but no G_Ic; the largest G_I is 1
  std::optional<Contact> contact;        // null if the data are dimensionless or (psi, f)
  std::size_t rows = 0;                  // data rows in the file: points + excluded
  std::vector<PullOffReading> pull_off;  // loads of pull-off, which belong to no run
  double compliance = 0;                 // dimensionless, of the machine that holds an approach; 0: rigid
  std::vector<std::string> curves;       // names of the loading runs: the curve column, or one per load
  std::vector<double> curve_loads;   // dimensionless load of each run, the mean of its readings; empty without loads
  std::vector<bool> shear_reversed;  // per run: whether the sign of T was changed; empty: none
  std::vector<std::string> ignored_columns;
  std::string reading;                         // the file format unless plain: "UTF-16LE, tabs, decimal commas"
  std::vector<std::string> taken;              // "P from 'Normalkraft (mN)'"
  std::map<std::string, std::string> mapping;  // the column of each quantity, as the key columns of its metadata
  bool like_a_log = false;                     // it has a column of times, and many rows are not points
  std::vector<Message> notes;                  // on skipped or changed data: sentences that every fit shows
  DisplayUnits display;
};

struct Dataset : DatasetFacts {
  std::vector<Point> points;              // usable, in file order
  std::vector<ToughnessPoint> converted;  // per point, if the data set has no loads
  std::vector<PointErrors> errors;        // per point, if the file states any
  std::vector<PointEnergies> energies;    // per point, if the data are energies
  std::vector<PointAxes> axes;            // per point, if the file has the axes of elliptic contacts
  std::vector<PointAxes> loads_beside;    // per point, loads measured beside a held approach, in q; empty: none
  std::vector<Excluded> excluded;

  /// What reports call the data: the title that is stated, else the name.
  const std::string& title() const { return metadata.title.empty() ? name : metadata.title; }
  /// Offsets, area_scale and force_gain as the metadata state them; 0 for toughness, modulus and radius, which are
  /// relative to the data set's own, and for changes, of which only errors are stated. All are 0 without loads.
  Constants stated_constants() const;
  /// The SI unit of an offset; 0 where the data are dimensionless.
  double offset_unit(Constant offset) const;
  /// Point i with its readings corrected by these constants.
  Point corrected(std::size_t i, const ConstantsScale& by) const {
    Point point = points[i];
    point.P = by.load(point.P);
    point.T = sign_of_shear(point.curve) * by.shear(shear_as_read(i));
    point.A = by.true_area(point.A);
    return point;
  }
  /// Whether the approach is held, which Point::P and curve_loads then are, in place of the load.
  bool holds_approach() const { return has_loads && metadata.control == NormalControl::approach; }
  /// What is held, for texts, with its unit: value in file = dimensionless * held_scale().
  const char* held_name() const { return holds_approach() ? "delta" : "P"; }
  const char* held_word() const { return holds_approach() ? "approach" : "load"; }
  const std::string& held_unit() const { return holds_approach() ? display.approach : display.force; }
  double held_scale() const { return holds_approach() ? display.approach_scale : display.force_scale; }
  /// The contact at an approach, with the machine's compliance under these constants.
  HeldApproach held_at(double approach, const ConstantsScale& by) const {
    return {approach, compliance * by.compliance};
  }
  /// The model for these data: that of a held load, or of a held approach.
  ContactModel under_control(const ContactModel& model) const {
    return holds_approach() ? model.at_held_approach(compliance) : model;
  }
  /// The same under other constants, which change the machine's dimensionless compliance.
  ContactModel under_control(const ContactModel& model, const ConstantsScale& by) const {
    return holds_approach() ? model.at_held_approach(compliance * by.compliance) : model;
  }
  /// The load at a corrected point.
  double load_at(const Point& point, const ConstantsScale& by) const {
    return holds_approach() ? held_at(point.P, by).load(radius_from_area(point.A)) : point.P;
  }
  /// Toughness and phase angle of point i, corrected by the stated constants; null if its area does not exceed that of
  /// Hertz (kNoPhaseAngle).
  std::optional<ToughnessPoint> toughness(std::size_t i) const {
    return toughness(i, ConstantsScale(stated_constants()));
  }
  /// The same for other constants.
  std::optional<ToughnessPoint> toughness(std::size_t i, const ConstantsScale& by) const {
    if (!has_loads) return converted[i];
    const Point point = corrected(i, by);
    return toughness_of_area(load_at(point, by), point.T, point.A);
  }
  /// -1 for a run that was reversed, else 1.
  double sign_of_shear(std::size_t run) const { return !shear_reversed.empty() && shear_reversed[run] ? -1 : 1; }
  /// T of point i with its sign in the file, to which an offset of the load cell is added.
  double shear_as_read(std::size_t i) const { return sign_of_shear(points[i].curve) * points[i].T; }
  std::string shown_path() const {
    const std::string more = files.size() > 1 ? " and " + std::to_string(files.size() - 1) + " more" : "";
    return printable(path, std::string::npos) + more;
  }
  /// The file of a line that is counted through all files, and the line's number in it.
  const std::string& file_of(std::size_t line) const { return files.empty() ? path : source_of(line).path; }
  std::size_t line_in_file(std::size_t line) const { return files.empty() ? line : line - source_of(line).first_line; }
  /// "line 17", or "run_3.csv line 17".
  std::string line_text(std::size_t line) const {
    const std::string text = "line " + std::to_string(line_in_file(line));
    const std::string& file = file_of(line);
    return files.empty() ? text : printable(file.substr(file.find_last_of('/') + 1), std::string::npos) + " " + text;
  }
  /// How the standard errors of the points are called: "sigma_T and sigma_A".
  const char* names_of_errors() const {
    return points.empty() && !pull_off.empty() ? "sigma_P and sigma_T"
           : has_loads                         ? "sigma_T and sigma_A"
           : has_energies                      ? "sigma_GI and sigma_GII"
                                               : "sigma_Gc";
  }
  PointErrors errors_of(std::size_t i) const { return errors.empty() ? PointErrors{} : errors[i]; }

 private:
  const SourceFile& source_of(std::size_t line) const {
    std::size_t k = files.size() - 1;
    while (k > 0 && line <= files[k].first_line) --k;
    return files[k];
  }
};

/// Throws an InputError at the place of a point's value in this column. Reads the file again to find the place; if that
/// fails, the message names only the line.
[[noreturn]] void refuse_value(const Dataset& data, const Point& point, std::string_view column,
                               const std::string& message);

/// Names of which no two are the same. A name costs the same however many there are.
class DistinctNames {
 public:
  void take(const std::string& name) { taken_.insert(name); }
  /// The wanted name, with " (2)", " (3)", ... appended if it is taken.
  std::string free_name(const std::string& wanted);

 private:
  std::unordered_set<std::string> taken_;
  std::unordered_map<std::string, int> numbers_;  // of a wanted name: the last that was found free
};

/// Indices into Dataset::points, by run.
std::vector<std::vector<std::size_t>> points_by_curve(const Dataset& data);

/// Finds the places of points on demand. Needs loads; the data set must outlive this object.
class PointPlaces {
 public:
  explicit PointPlaces(const Dataset& data);
  PointPlace at(std::size_t point) const { return at(point, data_.points[point].T); }
  /// `T`: of the point, free of noise.
  PointPlace at(std::size_t point, double T) const;

 private:
  const Dataset& data_;
  std::vector<double> largest_;  // shear of each run
};

/// A data set of these points alone, in this order. Its runs are those of all points, some perhaps without any.
Dataset part_of(const Dataset& data, const std::vector<std::size_t>& points);

/// The data set with readings corrected by the stated constants, and those constants removed.
Dataset corrected(Dataset data);

/// Reads PATH.csv and PATH.toml beside it. Throws InputError, with file, line and column, for anything that cannot be
/// understood, and MissingConstants for constants that this kind of data needs. Energies do not need G_Ic if one G_I is
/// positive (toughness_known). Rows that are understood but cannot be used are listed in `excluded`.
Dataset load_dataset(const std::string& path, const Overrides& overrides = {});
/// The same through `inputs`, which may have read the files before.
Dataset load_dataset(const std::string& path, const Overrides& overrides, Inputs& inputs);
/// The same with this metadata in place of the TOML, which is not read.
Dataset load_dataset(const std::string& path, const Metadata& metadata, const Overrides& overrides, Inputs& inputs);
/// The same as one of many files, without Dataset::inputs: those of all files together would be as many as their
/// square.
Dataset load_part(const std::string& path, const Metadata& metadata, const Overrides& overrides, Inputs& inputs);

}  // namespace mixity
