// Several files that are one data set: as a rule one for each loading run.
#pragma once

#include <string>
#include <vector>

#include "dataset/dataset.h"

namespace mixity {

/// One of them, and what is said of it elsewhere than beside it.
struct RunFile {
  std::string path;
  std::string name{};    // of its run; empty: the file's
  std::string load{};    // "4.68 mN", of all its points; empty: as the file or its name states
  std::string sphere{};  // "5 mm", the radius of the one it was measured with; empty: that of all files
};

/// The files that a pattern of the shell ("run_*.csv") stands for, in the order of their names, numbers by their size;
/// the text itself if it is none. Throws InputError if a pattern stands for no file.
std::vector<std::string> files_of(const std::string& pattern);

/// Reads files as load_dataset does, and makes one data set of them. Its runs are the files, or within a file what
/// names runs there. What is stated beside one file and not beside another holds for both: constants are those of the
/// experiment. A run on a sphere of its own is shown as on the first run's: contacts of one modulus and toughness are
/// alike, loads as R and areas as R^(4/3) (Maugis' dimensionless quantities), which is exact. Throws InputError for
/// what load_dataset refuses, for files that state different constants, for files that hold no loads, and for offsets
/// beside several spheres.
Dataset load_pooled(const std::vector<RunFile>& files, const Overrides& overrides = {});

}  // namespace mixity
