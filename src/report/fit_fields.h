// The fields of a fit, which stand in JSON and in fits.csv.
#pragma once

#include <string>
#include <vector>

#include "analysis/result.h"
#include "report/fields.h"

namespace mixity {

void describe(Fields<FitResult>& field);
void describe(Fields<ShownInterval>& field);

/// What every output shows beside reconstructed data; null for others.
std::optional<std::string_view> notice_on(const Dataset& data);

/// A point that is left out: of `data`, in which a line is counted through all files; null for another file.
struct ExcludedLine {
  std::size_t line;
  std::string_view reason;
  IfAny<std::string> file;
};
std::vector<ExcludedLine> lines_of(const std::vector<Excluded>& excluded, const Dataset* data);
void describe(Fields<ExcludedLine>& field);

/// A row for each data set, model and parameter.
std::string fits_csv(const std::vector<Analysis>& results);

}  // namespace mixity
