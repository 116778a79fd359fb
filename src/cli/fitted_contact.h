// A contact fitted to data, for commands that predict from it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analysis/result.h"
#include "cli/commands.h"
#include "cli/contact_flags.h"
#include "fitting/prediction.h"

namespace mixity::cli {

/// The fit of the best model, or of --model. Loads are as measured.
class FittedContact {
 public:
  /// Takes one data file or fit definition. Throws UsageError and what run() throws.
  FittedContact(const std::string& command, const Arguments& arguments);

  const Dataset& data() const { return result_.data; }
  const FitResult& fit() const { return result_.fits[best_]; }

  /// --loads, or the loads of the runs in falling order.
  const std::vector<Load>& loads() const { return loads_; }
  /// The loads of a flag; the data's unit applies if they have none. Throws UsageError.
  std::vector<Load> loads_of(const std::string& flag) const;
  FoldsPrediction folds(const Load& P, const std::vector<Control>& controls) const;
  /// Values evenly spaced from 0 to the jump, or to the largest T of the data if there is no jump.
  std::vector<Load> shears_to_the_jump(const Load& P, std::size_t points) const;

  /// Prints a CSV of the areas at each load and its shears, with standard errors.
  void print_areas(const std::function<std::vector<Load>(const Load& P)>& shears) const;

  /// Prints a warning to standard error if the fit is not ok.
  int exit_code() const;

 private:
  Analysis result_;
  std::size_t best_;
  std::vector<Load> loads_;
};

}  // namespace mixity::cli
