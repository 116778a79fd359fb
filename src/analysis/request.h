// The request for a fit: a data set, models and options, and published numbers to compare with.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/inputs.h"
#include "base/message.h"
#include "dataset/exclusion.h"
#include "dataset/pooled.h"
#include "fitting/options.h"

namespace mixity {

/// A published number of one model: a parameter; a constant that is fitted, as it is named in the result ("toughness",
/// "toughness(2)" of a series) and in its unit there; "r2" (in the fitted space); or "chi2", where errors are known.
struct Published {
  std::string name;
  double value, tolerance;  // agreement: |found - value| <= tolerance, from the printed digits
};

/// The formats that gnuplot adds to the SVG of a report's figures.
struct FigureFormats {
  bool pdf = false, png = false;
  bool gnuplot = false;  // the script and the data
};

struct FitRequest {
  std::string path;                                // of the definition; empty: none
  std::vector<InputFile> inputs;                   // the definition and the files of laws, as read
  std::string data_path;                           // CSV, resolved against the definition's folder; the first of `runs`
  std::vector<RunFile> runs;                       // files of a pooled data set; else empty
  std::string peaks_path;                          // CSV of peak forces, resolved likewise; empty: none
  std::vector<std::string> log_figures;            // SVG, resolved likewise: figures of the log of the data
  std::vector<std::string> models{"a", "b", "c"};  // in the order of the report
  FitOptions options;
  std::vector<std::string> free_parameters;  // model parameters stated as free; any that is not held is free, too
  std::optional<HeldParameter> tied{};       // of elliptic contacts: a parameter of one mode at a value
  bool equal_couplings = false;              // of elliptic contacts: one set of parameters for modes II and III
  std::vector<Constant> drift;               // modulus, toughness: constants whose drifts are also free
  Exclusion exclusion;
  Overrides constants;     // override those beside the data; each name once
  bool compare = true;     // compare the models by information criteria and by the error on left-out loads
  bool per_curve = false;  // also fit each loading run by itself
  FigureFormats formats;
  std::vector<std::string> law_notes;                       // warnings about the laws of the definition
  std::map<std::string, std::vector<Published>> published;  // by model key
  std::string source;                                       // of the published numbers
  std::set<std::string, std::less<>> stated;                // names of the options that were set (settings.h)
  Wording words = in_neutral_words;                         // for messages in the outputs
};

}  // namespace mixity
