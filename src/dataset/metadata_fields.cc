// What a data set may state: its constants, and how its file is read. Flags, keys of a TOML and keywords of Python
// follow.
#include <array>

#include "dataset/metadata.h"

namespace mixity {
namespace {

constexpr std::array<MetadataField, 35> kFields{{
    {"radius", "radius of the sphere, such as \"9.42 mm\"", true, &Metadata::radius, dimension::length, "9.42 mm"},
    {"modulus", "plane-strain modulus E*, such as \"2.133 MPa\"", true, &Metadata::modulus, dimension::stress,
     "2.133 MPa"},
    {"youngs_modulus", "Young's modulus of the soft half-space; needs poisson_ratio", true, &Metadata::youngs_modulus,
     dimension::stress, "1.6 MPa"},
    {"poisson_ratio", "Poisson's ratio of the soft half-space, 0..0.5", true, &Metadata::poisson_ratio, dimension::none,
     "0.5"},
    {"toughness", "mode-I toughness G_Ic, such as \"27 mJ/m^2\"", true, &Metadata::toughness,
     dimension::energy_per_area, "27 mJ/m^2"},
    {"toughness_II", "mode-II toughness G_IIc, such as \"1.7 N/mm\"", true, &Metadata::toughness_II,
     dimension::energy_per_area, "1.7 N/mm"},
    {"shear_strength", "shear strength tau0 of the interface, such as \"0.43 MPa\"", true, &Metadata::shear_strength,
     dimension::stress, "0.43 MPa"},
    {"load_offset", "to be added to readings of P, such as \"0 +/- 0.5 mN\"", true, &Metadata::load_offset,
     dimension::force, "0 +/- 0.5 mN"},
    {"shear_offset", "to be added to readings of T, such as \"0 +/- 0.5 mN\"", true, &Metadata::shear_offset,
     dimension::force, "0 +/- 0.5 mN"},
    {"area_offset", "to be added to readings of A, such as \"0 +/- 0.01 mm^2\"", true, &Metadata::area_offset,
     dimension::area, "0 +/- 0.01 mm^2"},
    {"approach_offset", "to be added to readings of delta, such as \"0 +/- 0.2 um\"", true, &Metadata::approach_offset,
     dimension::length, "0 +/- 0.2 um"},
    {"area_scale", "what readings of A are to be multiplied by, such as \"1 +/- 2%\"", true, &Metadata::area_scale,
     dimension::none, "1 +/- 2%"},
    {"force_gain", "what readings of P and T are to be multiplied by, such as \"1 +/- 1%\"", true,
     &Metadata::force_gain, dimension::none, "1 +/- 1%"},
    {"modulus_drift", "how far the modulus may change from the first to the last run: \"0 +/- 0.03\"", true,
     &Metadata::modulus_drift, dimension::none, "0 +/- 0.03"},
    {"toughness_drift", "how far the toughness may change from the first to the last run: \"0 +/- 0.03\"", true,
     &Metadata::toughness_drift, dimension::none, "0 +/- 0.03"},
    {"shape", "share by which the radius of a contact that is no circle may be read too large: \"0 +/- 0.01\"", true,
     &Metadata::shape, dimension::none, "0 +/- 0.01"},
    {"hysteresis", "share by which the toughness without shear may differ: \"0 +/- 0.1\"", true, &Metadata::hysteresis,
     dimension::none, "0 +/- 0.1"},
    {"mode_III",
     "mode III at the edge of the contact: half, the same all round (default), or averaged, as in Johnson (1996) and "
     "Waters & Guduru (2010); with poisson_ratio, else 0.5",
     true},
    {"control",
     "what is held in the normal direction: load (default), or approach, of which a column delta is read in place of P "
     "or beside it",
     true},
    {"normal_stiffness",
     "stiffness of the machine that holds the approach, such as \"1.2 kN/m\"; without it the machine is rigid", true,
     &Metadata::normal_stiffness, dimension::energy_per_area, "1.2 kN/m"},
    {"provenance", "measured, digitised or reconstructed", true},
    {"title", "what reports call the data, in place of the file's name", true},
    {"source", "where the data come from", true},
    {"note", "a note on the data", true},
    {"columns", "which column is which: \"P=Kanal 3 (mN),T=Kanal 4 (N)\", by heading or number", false},
    {.name = "headings",
     .help = "a TOML that adds to the names of columns that are known (data/headings.toml)",
     .of_experiment = false,
     .is_path = true},
    {.name = "definition",
     .help = "a TOML of constants and of how to read files, as check writes it, for all that no other TOML states",
     .of_experiment = false,
     .is_path = true},
    {"decimal", "the decimal sign, where a file can be read in two ways: , or .", false},
    {"sheet", "the sheet of a workbook (.xlsx), by name or number", false},
    {"pixel", "the side of a camera's pixel, for areas in pixels: \"1.7 um\"", false, &Metadata::pixel,
     dimension::length, "1.7 um"},
    {"load", "normal load P of all points, where no column states it", false, &Metadata::load, dimension::force,
     "4.68 mN"},
    {"rate", "rows per second of a log without a column of times: \"400 Hz\", or the time between two: \"2.5 ms\"",
     false, &Metadata::rate, dimension::frequency, "400 Hz"},
    {"fps", "frames per second of a log that numbers frames in place of times, such as 25", false, &Metadata::fps,
     dimension::none, "25"},
    {"table", "which table is read, of a file that has several with different headings, such as 2", false,
     &Metadata::table, dimension::none, "2"},
    {"load_from", "where a file's name states the normal load: \"run_{P}mN\"", false},
}};

}  // namespace

std::span<const MetadataField> metadata_fields() { return kFields; }

}  // namespace mixity
