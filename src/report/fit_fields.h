// The fields of data sets, fits and their statistics, from which JSON, schemas and fits.csv are generated.
#pragma once

#include <string>
#include <vector>

#include "analysis/result.h"
#include "report/fields.h"

namespace mixity {

void describe(Fields<InputFile>& field);
void describe(Fields<Analysis>& field);
void describe(Fields<FitResult>& field);
void describe(Fields<ShownInterval>& field);
void describe(Fields<Influence>& field);
void describe(Fields<ShownEvidence>& field);
void describe(Fields<Budget>& field);
void describe(Fields<Consistency>& field);
void describe(Fields<RunTest>& field);
void describe(Fields<Explanation>& field);

struct Correlation {
  std::vector<std::string> parameters;  // two
  double value;
};
void describe(Fields<Correlation>& field);
/// One entry per pair of free parameters.
std::vector<Correlation> correlations(const FitResult& fit);

/// The notice on reconstructed data, which every output shows; null for other data.
std::optional<std::string_view> notice_on(const Dataset& data);

/// An excluded point with the line in its file.
struct ExcludedLine {
  std::size_t line;
  std::string_view reason;
  IfAny<std::string> file;  // if the data set has several files
};
void describe(Fields<ExcludedLine>& field);
/// `data`: the data set of the points; null for points from another file.
std::vector<ExcludedLine> lines_of(const std::vector<Excluded>& excluded, const Dataset* data);

}  // namespace mixity
