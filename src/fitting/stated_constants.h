// The constants of the experiment as a data set states them, in the solver's numbers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dataset/dataset.h"
#include "fitting/constants.h"

namespace mixity {

struct FitOptions;

/// A constant of the experiment that is fitted.
struct FittedConstant {
  Constant constant;
  double mean, prior;  // prior: standard error about the mean; 0: no prior
};

/// The constants that a fit holds fixed: those of the options, else as stated.
Constants constants_of(const Dataset& data, const FitOptions& options);

/// How a constant is shown: the solver's number x as scale x, or for a factor as scale exp(x). The text is empty where
/// the data are dimensionless.
struct ConstantUnit {
  double scale = 1;  // SI for toughness, modulus and radius; the file's unit for offsets
  std::string text{};
};
ConstantUnit unit_of(const Dataset& data, Constant c);

/// The unit of a deviation of this constant or parameter between runs: relative for a factor, the file's for an offset.
ConstantUnit shown_deviation(const Dataset& data, std::string_view quantity);

/// The scales of the points of a data set for given constants.
class Scales {
 public:
  Scales(const Dataset& data, const Constants& constants)
      : constants_(constants),
        same_(constants),
        places_(has_changes(constants) ? std::optional<PointPlaces>(data) : std::nullopt) {}
  ConstantsScale of(std::size_t point) const {
    return places_ ? ConstantsScale(constants_, places_->at(point)) : same_;
  }

 private:
  Constants constants_;
  ConstantsScale same_;
  std::optional<PointPlaces> places_;  // null if all are alike
};

/// The constants stated with a standard error (normal for offsets, else log-normal) that this kind of data needs.
std::vector<FittedConstant> uncertain_constants(const Dataset& data);

}  // namespace mixity
