// A contact that is fitted to data, for commands that say what follows from it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analysis/result.h"
#include "cli/commands.h"
#include "cli/contact_flags.h"
#include "fitting/prediction.h"

namespace mixity::cli {

/// The model that describes a data set best, or that of --model. Loads are as read.
class FittedContact {
 public:
  /// One data CSV or fit definition. Throws UsageError, and what requests throw.
  FittedContact(const std::string& command, const Arguments& arguments);

  const Dataset& data() const { return result_.data; }
  const FitResult& fit() const { return result_.fits[best_]; }

  /// --loads, or those of the runs, falling.
  const std::vector<Load>& loads() const { return loads_; }
  /// A list of loads in the data's unit; throws UsageError for another one.
  std::vector<Load> loads_of(const std::string& flag, const std::string& text) const;
  FoldsPrediction folds(const Load& P, const std::vector<Control>& controls) const;
  /// So many from 0 to where the contact jumps, or to the data's largest T if it does not.
  std::vector<Load> shears_to_the_jump(const Load& P, std::size_t points) const;

  /// CSV of the areas at each load and these shears of it, with standard errors.
  void print_areas(const std::function<std::vector<Load>(const Load& P)>& shears) const;

  /// Says on the error stream why the fit cannot be believed, if so.
  int exit_code() const;

 private:
  Analysis result_;
  std::size_t best_;
  std::vector<Load> loads_;
};

}  // namespace mixity::cli
