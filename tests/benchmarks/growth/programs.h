// What whole runs of the program cost, of this build or of others side by side.
#pragma once

#include <string>
#include <vector>

#include "growth/table.h"

namespace mixity::growth {

/// Paths of programs; each gets a row of its own.
using Programs = std::vector<std::string>;

/// A file with so many columns that mean nothing here, read and checked.
void columns(const Folder& folder, const Programs& programs);
/// So many rows of model c, read and fitted.
void fits(const Folder& folder, const Programs& programs, const std::vector<std::size_t>& sizes);
/// So many laws of one's own, fitted to one data set and compared.
void laws(const Folder& folder, const Programs& programs);
/// So many files of two points, pooled and checked.
void files(const Folder& folder, const Programs& programs);
/// A report of so many data sets of 200 points.
void sets(const Folder& folder, const Programs& programs);
/// A log of so many contacts, made loading runs.
void runs(const Folder& folder, const Programs& programs);

}  // namespace mixity::growth
