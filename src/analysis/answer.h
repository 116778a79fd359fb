// What a report leads with: the result, the jumps that follow from it, and what the data cannot say.
#pragma once

#include <string>
#include <vector>

#include "analysis/result.h"
#include "fitting/prediction.h"

namespace mixity {

/// Where the contact of a run's load jumps under load control; in the units of the file.
struct PredictedJump {
  double P;
  Derived T, A;
  double largest_T;  // that was measured at this load
};

struct Answer {
  const FitResult* fit = nullptr;                      // that describes the data best; null if none has a value
  std::string result;                                  // "λ = 0.002306 ± 0.000011"
  std::string model;                                   // "model c, Papangelo-Ciavarella 2019: f = ..."
  std::string interval;                                // "95 % interval 0.002285 .. 0.002328"; empty without one
  std::string doubt;                                   // why it cannot be believed, and what helps; empty if it can
  std::vector<std::pair<std::string, double>> budget;  // parts of its variance; empty where there is one part
  std::vector<PredictedJump> jumps;                    // by falling load; those that exist
  std::vector<std::string> cannot_say;                 // sentences
};

Answer answer_of(const Analysis& result);

/// The jumps as a table, rounded to their errors: headings first.
std::vector<std::vector<std::string>> jump_table(const Answer& answer, const Dataset& data);

}  // namespace mixity
