// Tangential loads at the first maximum (peak) and the following minimum of a shear test against the normal load, as in
// Waters & Guduru (2010), Fig. 6, and as mean stresses T/A_Hertz in Fig. 11 of the paper.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dataset/dataset.h"

namespace mixity {

/// One row. Stresses refer to the Hertz area at P, which exists only for P > 0; other rows are excluded.
struct PeakForce {
  std::size_t line;
  double P;                             // in the file's unit
  std::optional<double> peak, minimum;  // T/A_Hertz in `stress_unit`
};

struct PeakForces {
  std::string path, name;
  std::vector<InputFile> inputs;  // the file and its TOML
  Metadata metadata;
  std::string force_unit;   // as written; empty if dimensionless
  std::string stress_unit;  // kPa; empty if dimensionless, then stresses are in units of E*/xi
  std::vector<PeakForce> rows;
  std::vector<Excluded> excluded;
};

/// Reads PATH.csv with columns P and T_peak or T_min or both, and PATH.toml beside it. Columns with units need the
/// radius and the modulus. Throws InputError with file, line and column.
PeakForces load_peak_forces(const std::string& path);

}  // namespace mixity
