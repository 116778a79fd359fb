// The options of a fit, each stated once: `mixity fit` has them as flags, a fit definition as keys, Python as keywords,
// the explorer as fields of its page.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/request.h"

namespace mixity {

/// One option, as a user states it by name and text.
struct Setting {
  std::string name, help;  // help: a clause
  bool is_switch;          // its text is true or false
  /// Reads a text into the request. Returns the problem as the end of a sentence that begins with the option's name
  /// ("is 'cubic'; it must be log or linear"), or an empty string.
  std::function<std::string(std::string_view text, FitRequest& request)> read;
  /// The text of the request's value, which `read` reads back. Empty if there is no value.
  std::function<std::string(const FitRequest& request)> write;

  /// The text of the default. Empty if there is none, or if the data decide.
  std::string initial() const { return write(FitRequest{}); }
};

/// In the order in which help lists them and a definition is written.
const std::vector<Setting>& settings();

/// Sets an option and adds its name to `request.stated`. Lists are separated by commas. Returns the problem as
/// Setting::read does. Throws std::invalid_argument for an unknown name.
std::string set_option(FitRequest& request, std::string_view name, std::string_view text);

/// Names and texts of the options in `request.stated`, by name.
std::vector<std::pair<std::string, std::string>> stated_options(const FitRequest& request);

/// An option that contradicts another one, and the problem as Setting::read returns it.
struct Contradiction {
  std::string option, problem;
};
/// To be called when all options are set. Null if they agree.
std::optional<Contradiction> contradiction(const FitRequest& request);

}  // namespace mixity
