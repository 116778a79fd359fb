// Several files combined into one data set, usually one file for each loading run.
#pragma once

#include <string>
#include <vector>

#include "dataset/dataset.h"

namespace mixity {

/// One of the files, with what is stated elsewhere than beside it.
struct RunFile {
  std::string path;
  std::string name{};    // of its run; empty: that of the file
  std::string load{};    // "4.68 mN", of all its points; empty: as the file or its name states
  std::string sphere{};  // "5 mm", the radius of the one it was measured with; empty: that of all files
};

/// The files that match a pattern of the shell ("run_*.csv"), in the order of their names, numbers by their size; the
/// text itself if it is no pattern. Throws InputError if no file matches.
std::vector<std::string> files_of(const std::string& pattern);

/// Reads files as load_dataset does, and combines them into one data set, whose runs are the files, or the runs within
/// a file. Constants that are stated beside one file hold for all. A run on a sphere of its own is scaled to the sphere
/// of the first: by Maugis' dimensionless quantities loads go as R and areas as R^(4/3), which is exact. Throws
/// InputError as load_dataset does, for different constants, for files without loads, and for offsets beside several
/// spheres.
Dataset load_pooled(const std::vector<RunFile>& files, const Overrides& overrides = {});

}  // namespace mixity
