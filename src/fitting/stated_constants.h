// What a data set says of the constants of its experiment, in the solver's numbers.
#pragma once

#include <string>
#include <vector>

#include "dataset/dataset.h"
#include "fitting/constants.h"

namespace mixity {

/// A constant of the experiment that is fitted: about `mean`, with that standard error, or 0 where nothing is known.
struct FittedConstant {
  Constant constant;
  double mean, prior;
};

/// The stated values: 0 for what counts from the data set's own (toughness, modulus, radius), offsets and scale of the
/// areas as stated.
Constants stated_constants(const Dataset& data);

/// What a reader sees of a constant in the solver's number x is that times constant_scale, of a factor exp(x) times it:
/// SI for toughness, modulus and radius, a factor for area_scale, the file's unit for offsets.
double constant_scale(const Dataset& data, Constant c);
/// Empty where the data are dimensionless.
std::string constant_unit(const Dataset& data, Constant c);

/// Constants that are stated with a standard error: normal for offsets, log-normal for what is positive. Those that
/// this kind of data does not need are left out.
std::vector<FittedConstant> uncertain_constants(const Dataset& data);

}  // namespace mixity
