// What a fit is asked for: a data set, the models and options, and published numbers to compare with.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/inputs.h"
#include "base/message.h"
#include "dataset/exclusion.h"
#include "dataset/pooled.h"
#include "fitting/options.h"

namespace mixity {

/// A published number of one model: a parameter, or "r2" (in the fitted space).
struct Published {
  std::string name;
  double value, tolerance;  // agreement means |found - value| <= tolerance, what the printed digits allow
};

/// What gnuplot makes of a report's figures, beside their SVG.
struct FigureFormats {
  bool pdf = false, png = false;
  bool gnuplot = false;  // the script and the data
};

struct FitRequest {
  std::string path;                                // of its definition; empty if there is none
  std::vector<InputFile> inputs;                   // the definition and files of laws, as they were read
  std::string data_path;                           // CSV, resolved against the definition's folder; the first of `runs`
  std::vector<RunFile> runs;                       // of a data set of several files; else empty
  std::string peaks_path;                          // CSV of peak forces, resolved likewise; empty: none
  std::vector<std::string> log_figures;            // SVG, resolved likewise: figures of the log behind the data
  std::vector<std::string> models{"a", "b", "c"};  // in the order of the report
  FitOptions options;
  std::vector<std::string> free_parameters;  // model parameters named as free; so are all that are not held
  std::vector<Constant> drift;               // modulus, toughness: their drifts are free, too
  Exclusion exclusion;
  Overrides constants;     // override those beside the data; each name once
  bool compare = true;     // compare the models: information criteria, error on loads left out
  bool per_curve = false;  // also fit each loading run by itself
  FigureFormats formats;
  std::vector<std::string> law_notes;                       // warnings about the laws of the definition
  std::map<std::string, std::vector<Published>> published;  // by model key
  std::string source;                                       // of the published numbers
  std::set<std::string, std::less<>> stated;                // names of the options that were set (settings.h)
  Wording words = in_neutral_words;                         // of the messages in what is written of the results
};

}  // namespace mixity
