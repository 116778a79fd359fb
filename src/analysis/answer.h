// The beginning of a report: the result, the predicted jumps, and what the data do not determine.
#pragma once

#include <string>
#include <vector>

#include "analysis/result.h"
#include "fitting/prediction.h"

namespace mixity {

/// A jump of the contact under load control, predicted at the load of a run. In the units of the file.
struct PredictedJump {
  double P;
  bool is_approach;  // P is the approach that is held
  Derived T, A;
  double largest_T;  // measured at this load
};

struct Answer {
  const FitResult* fit = nullptr;  // the best one (by_merit); null if none has a value
  std::string result;              // "λ = 0.002306 ± 0.000011"
  std::string model;               // "model c, Papangelo-Ciavarella 2019: f = ..."
  std::string interval;            // "95 % interval of λ 0.002285 .. 0.002328, of ..."; may be empty
  std::string doubt;               // what is wrong, and a remedy; empty for status ok
  std::vector<std::pair<std::string, double>> budget;  // shares of its variance; empty if there is only one part
  std::vector<PredictedJump> jumps;                    // in order of falling load; only loads with a jump
  std::vector<std::string> cannot_say;                 // limitations of the result: sentences
};

Answer answer_of(const Analysis& result);

/// The jumps as rows of a table, rounded to their errors. The first row has the headings.
std::vector<std::vector<std::string>> jump_table(const Answer& answer, const Dataset& data);

}  // namespace mixity
