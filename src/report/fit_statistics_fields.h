// The fields of what a fit says about its parameters and its residuals.
#pragma once

#include <string>
#include <vector>

#include "fitting/result.h"
#include "report/fields.h"

namespace mixity {

struct Correlation {
  std::vector<std::string> parameters;  // two
  double value;
};

/// Of each pair of free parameters.
std::vector<Correlation> correlations(const FitResult& fit);

void describe(Fields<Correlation>& field);
void describe(Fields<Influence>& field);
void describe(Fields<ShownEvidence>& field);
void describe(Fields<Budget>& field);
void describe(Fields<Consistency>& field);

}  // namespace mixity
