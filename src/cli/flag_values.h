// Values of flags, by the flag's name. Each function throws UsageError for an unusable value.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/units.h"
#include "cli/commands.h"

namespace mixity::cli {

bool is_set(std::string_view flag);
std::string value_of(std::string_view flag);

/// The error "flag '--goal': PROBLEM".
UsageError refused(std::string_view flag, const std::string& problem);

/// The error "flag '--goal' is 'x'; it must be error or model", from "be error or model".
UsageError must(const std::string& flag, const std::string& be);

/// The error for a list in place of one number, which may be a number with a decimal comma.
UsageError not_one_number(const std::string& flag);

/// A number from low to high, both included.
double number_from(const std::string& flag, double low, double high = 1e150);

/// A whole number from `least` to `most`.
std::size_t count_from(const std::string& flag, std::size_t least, std::size_t most = 1000000000);

/// --load or --loads, whichever was given: where there is no data file they are one flag. `usual` if neither was.
std::string flag_of_loads(const std::string& usual);

/// Comma-separated items, trimmed; none is empty. Where there are semicolons they separate, and numbers may have
/// decimal commas.
std::vector<std::string> list_from(const std::string& flag);

/// A quantity for which `suits` is true; `be` as in must().
Quantity quantity_from(const std::string& flag, const std::string& be,
                       const std::function<bool(const Quantity&)>& suits);

/// One or more comma-separated quantities, of which all have a unit or the last alone, whose unit then is that of all.
/// --load is one number, which may have a decimal comma.
std::vector<Quantity> quantities_from(const std::string& flag);

/// A positive quantity of the dimension of `unit`, divided by `size` [SI]; a bare number if there is no size.
double positive_quantity(const std::string& flag, const std::string& unit, std::optional<double> size);

}  // namespace mixity::cli
