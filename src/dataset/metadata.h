// The metadata of a CSV: the constants of the contact, the provenance of the data, how to read the file.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/input_error.h"
#include "base/inputs.h"
#include "base/units.h"

namespace mixity {

struct ColumnRules;

enum class Provenance { unstated, measured, digitised, reconstructed };
std::string_view to_string(Provenance provenance);

/// How mode III enters the energy release rate at the edge of a circular contact. half: weighted by 1/2, so that the
/// rate is the same all round the edge (Papangelo & Ciavarella 2019). averaged: its average over the edge (Johnson
/// 1996, Waters & Guduru 2010), in which T^2 counts kappa = (2 - nu)/(2 - 2 nu) times as much.
enum class ModeIII { unstated, half, averaged };
/// "half" where it is unstated.
std::string_view to_string(ModeIII convention);

/// What is held while a contact is sheared: its normal load, or the approach of the sphere.
enum class NormalControl { unstated, load, approach };
/// "load" where it is unstated.
std::string_view to_string(NormalControl control);

/// Shown in every output of reconstructed data.
inline constexpr std::string_view kReconstructedNotice =
    "reconstructed data: generated from a model, not measured. Recovering lambda from them tests the "
    "program, not the physics.";
/// What a reader should know about such data, for a line that has named the provenance; empty for measured data.
std::string_view meaning_of(Provenance provenance);

/// Names and texts in the order of the command line: {"radius", "9.42 mm"}.
using Overrides = std::vector<std::pair<std::string, std::string>>;

/// Constants in SI; null if not stated. Offsets are added to readings; areas are multiplied by area_scale.
struct Metadata {
  std::optional<double> radius;                         // m, > 0
  std::optional<double> modulus;                        // plane-strain E*, Pa, > 0
  std::optional<double> youngs_modulus, poisson_ratio;  // Pa, > 0; 0..0.5: an alternative to modulus
  std::optional<double> toughness;                      // G_Ic, J/m^2, > 0
  std::optional<double> toughness_II;                   // G_IIc, J/m^2, > 0
  std::optional<double> shear_strength;                 // tau0, Pa, > 0
  std::optional<double> load_offset, shear_offset;      // N
  std::optional<double> area_offset;                    // m^2
  std::optional<double> approach_offset;                // m
  std::optional<double> normal_stiffness;               // N/m, > 0: of the machine that holds an approach
  std::optional<double> area_scale, force_gain;         // > 0
  std::optional<double> modulus_drift, toughness_drift, shape, hysteresis;  // 0; they only name their errors
  std::optional<double> pixel;                                              // m, the side of a pixel, > 0
  std::optional<double> load;                                               // N, of all points, if no column states it
  std::optional<double> rate, fps;                                          // 1/s, of the rows; of frames
  std::optional<double> table;                                              // its number in the file, from 1
  std::map<std::string, double, std::less<>> standard_errors;               // by the name of a constant, in its unit
  Provenance provenance = Provenance::unstated;
  ModeIII mode_III = ModeIII::unstated;
  NormalControl control = NormalControl::unstated;
  std::string title, source, note;
  // How to read the file.
  std::map<std::string, std::string> columns;  // quantity -> heading
  std::string headings;                        // path of a TOML that adds to the vocabulary
  std::string definition;                      // path of a TOML that states what this one does not
  std::string load_from;                       // "run_{P}mN": where the file's name states the load
  char decimal = 0;                            // '.' or ','; 0: inferred from the numbers
  std::string sheet;                           // of a workbook: name or number; empty: inferred from the headings

  /// modulus, or E* from youngs_modulus and poisson_ratio; null if neither is stated.
  std::optional<double> plane_strain_modulus() const;
  /// What mode_III multiplies T^2 by, with nu = 1/2 if none is stated; 1 unless it is averaged.
  double kappa() const;
  /// sqrt(kappa): T times this is the shear in the equations of the models.
  double shear_weight() const;
  /// The stated standard error; 0 (exact) if none is stated.
  double standard_error(std::string_view name) const;
  /// Relative error of plane_strain_modulus(): of modulus, or propagated from youngs_modulus and poisson_ratio.
  double modulus_error() const;
};

/// Constants needed to make the points of a file dimensionless are not stated. The message lists them as options.
class MissingConstants : public InputError {
  using InputError::InputError;
};

/// A constant of an experiment, or an instruction for reading its file: a key of the TOML, a flag and a keyword.
struct MetadataField {
  std::string_view name, help;                        // help: a clause
  bool of_experiment;                                 // false: about reading the file
  std::optional<double> Metadata::*number = nullptr;  // null: the field is a text
  Dimension dimension{};                              // of the number
  std::string_view example{};                         // example of a value, as text
  bool is_path = false;                               // of a file, relative to the folder of a TOML that names it
};
/// All fields in the order of the help.
std::span<const MetadataField> metadata_fields();

/// Whether the field names a file.
bool is_path(std::string_view field);

/// "Pa"; empty for a number without a unit.
std::string_view si_unit(const Dimension& dimension);

/// Sets one field from its text. Returns what is wrong with the text, or an empty string if nothing is.
std::string set_field(Metadata& metadata, std::string_view name, std::string_view text);

/// The kind of value that a field takes in a TOML: "a string with a number and a unit, such as ..."; empty for an
/// unknown field.
std::string kind_of_field(std::string_view name);

/// The metadata file of a CSV: its path with the extension .toml. An extension begins with a letter, so run_0.5 has
/// none.
std::string metadata_path(const std::string& csv_path);

/// A CSV's name without folder and extension, as shown.
std::string data_name(const std::string& csv_path);

/// Reads the TOML at `path`; states nothing if the file does not exist. Throws InputError with line and column for a
/// syntax error, an unknown key or a value without a unit.
Metadata read_metadata(const std::string& path, Inputs& inputs);
inline Metadata read_metadata(const std::string& path) {
  Inputs inputs;
  return read_metadata(path, inputs);
}

/// What is stated for a data file: the TOML beside it, and what that leaves open in the definition that it or one of
/// the overrides names. Overrides are not applied. Throws InputError as read_metadata does, and if there is no
/// definition.
Metadata metadata_of(const std::string& csv_path, const Overrides& overrides, Inputs& inputs);

/// The same for what is stated in another way.
Metadata with_definition(Metadata own, const Overrides& overrides, Inputs& inputs);

/// What options state without a data file: their definition, and the options themselves. Throws InputError as both do.
Metadata stated_by(const Overrides& overrides);

/// The value of a field as a text that set_field accepts; null if it is not stated.
std::optional<std::string> stated_text(const Metadata& metadata, std::string_view name);

/// "half", or "averaged (kappa = 1.5 at nu = 0.5, not stated)".
std::string mode_III_text(const Metadata& metadata);

/// Adds the constants stated beside one file to those of other files of the same experiment. Returns the contradiction,
/// or an empty string. If provenances differ, keeps the less direct one.
std::string add_constants(const Metadata& more, Metadata& constants);
/// The constants in texts that set_field accepts: {"radius", "0.00942 m +/- 1e-05 m"}.
Overrides constants_as_stated(const Metadata& metadata);
/// Applies overrides; modulus and youngs_modulus replace each other. Throws InputError naming the override.
void apply_overrides(const Overrides& overrides, Metadata& metadata);

/// Throws InputError if the constants that give the modulus are contradictory or incomplete. The message names the
/// override if that is one half of a pair, otherwise the file at `path`. poisson_ratio may stand beside modulus and,
/// where mode III is averaged, by itself.
void require_whole_modulus(const Metadata& metadata, const std::string& path, const Overrides& overrides = {});

/// The number of the table to be read; null if none is stated.
std::optional<std::size_t> number_of_table(const Metadata& metadata);

/// The rules for reading the columns of its table. Throws InputError for an invalid file of names (headings).
ColumnRules rules_of(const Metadata& metadata, Inputs& inputs);

}  // namespace mixity
