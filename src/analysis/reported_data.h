// Everything that a report shows of one data set: its fits, and other content of figures.
#pragma once

#include <optional>
#include <string>

#include "analysis/answer.h"
#include "analysis/model_curves.h"
#include "analysis/predicted_peaks.h"
#include "analysis/result.h"
#include "dataset/peak_forces.h"
#include "fitting/sahli.h"

namespace mixity {

/// Runs a request, adding cost profiles and, for several runs, fits of single runs, which figures need. The best fit
/// comes first.
Analysis run_for_report(FitRequest request, const Progress& progress = {});
/// The same for data in memory, as for `run`.
Analysis run_for_report(FitRequest request, const Dataset& data, const Progress& progress = {});

struct ReportedData {
  const Analysis& result;                         // must outlive this object
  std::string stem;                               // of its file names, unique in the report
  FiguredModels figured{};                        // curves of the fits that have values
  std::optional<SahliResult> sahli{};             // null without loads
  std::string sahli_model{};                      // the model whose alpha is drawn; empty: none
  std::optional<PeakForces> peaks{};              // null without a file of peaks
  std::vector<PredictedPeaks> predicted_peaks{};  // if there are measured peaks
  Answer answer{};
};

/// Throws InputError if the file of peak forces cannot be used.
ReportedData reported_data(const Analysis& result, const std::string& stem);

/// One per analysis of a report. Moves reconstructed data to the end, which say nothing of the physics, and before that
/// contacts to the front, as they have jumps to predict. Makes names unique.
std::vector<ReportedData> reported_data(std::vector<Analysis>& results);

}  // namespace mixity
