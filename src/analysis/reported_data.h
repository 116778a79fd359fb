// What a report knows of one data set: its fits, and what else is found out for the figures.
#pragma once

#include <optional>
#include <string>

#include "analysis/predicted_peaks.h"
#include "analysis/result.h"
#include "dataset/peak_forces.h"
#include "fitting/sahli.h"

namespace mixity {

/// Runs a request with what the figures need beyond `fit`: cost profiles, and each run by itself where there are
/// several. The fit that describes the data best comes first.
Analysis run_for_report(FitRequest request, const Progress& progress = {});

struct ReportedData {
  const Analysis& result;            // outlives this
  std::string stem;                  // of its files, distinct within the report
  std::optional<SahliResult> sahli;  // null without loads
  std::string sahli_model;           // what predicts alpha there, the first fit with values; empty: nothing
  std::optional<PeakForces> peaks;   // null without a file of them
  std::vector<PredictedPeaks> predicted_peaks{};  // where there are some
};

/// Throws InputError if the file of peak forces cannot be used.
ReportedData reported_data(const Analysis& result, const std::string& stem);

}  // namespace mixity
