// Several files combined into one data set, usually one file for each loading run.
#pragma once

#include <string>
#include <vector>

#include "dataset/dataset.h"

namespace mixity {

/// One of the files, with what is not stated in its TOML.
struct RunFile {
  std::string path;
  std::string name{};    // of its run; empty: that of the file
  std::string load{};    // "4.68 mN", of all its points; empty: as the file or its name states
  std::string sphere{};  // "5 mm", the radius of its sphere; empty: that of all files
};

/// The files that match a shell pattern ("run_*.csv"), sorted by name, numbers in names by value. A text that is not a
/// pattern is returned unchanged. Throws InputError if no file matches.
std::vector<std::string> files_of(const std::string& pattern);

/// Reads files as load_dataset does, and combines them into one data set, whose runs are the files, or the runs within
/// a file. Constants stated beside one file apply to all. A run on another sphere is scaled to the sphere of the first:
/// by Maugis' dimensionless quantities loads scale as R and areas as R^(4/3), which is exact. Throws InputError as
/// load_dataset does, for different constants, for files without loads, and for offsets beside several spheres.
Dataset load_pooled(const std::vector<RunFile>& files, const Overrides& overrides = {});
/// The same from these files, which may have been read before.
Dataset load_pooled(const std::vector<RunFile>& files, const Overrides& overrides, Inputs& inputs);

}  // namespace mixity
