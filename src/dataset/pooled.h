// Combines several files, usually one per loading run, into one data set.
#pragma once

#include <string>
#include <vector>

#include "dataset/dataset.h"

namespace mixity {

/// One of the files, with what its TOML does not state.
struct RunFile {
  std::string path;
  std::string name{};    // of its run; empty: the file's name
  std::string load{};    // "4.68 mN", of all its points; empty: from the file or its name
  std::string sphere{};  // "5 mm", the radius of its sphere; empty: the common one
};

/// The files that match a shell pattern ("run_*.csv"), sorted by name, with numbers in names compared by value. A text
/// without a pattern is returned unchanged. Throws InputError if no file matches.
std::vector<std::string> files_of(const std::string& pattern);

/// Reads files as load_dataset does, and combines them into one data set, whose runs are the files or the runs within a
/// file. Constants stated beside one file apply to all. A run on another sphere is scaled to that of the first: in
/// Maugis' dimensionless quantities loads scale as R and areas as R^(4/3), exactly. Throws InputError as load_dataset
/// does, for contradictory constants, for files without loads, and for offsets with several spheres.
Dataset load_pooled(const std::vector<RunFile>& files, const Overrides& overrides = {});
/// The same through `inputs`, which may have read the files before.
Dataset load_pooled(const std::vector<RunFile>& files, const Overrides& overrides, Inputs& inputs);

}  // namespace mixity
