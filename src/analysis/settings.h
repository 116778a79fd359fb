// The options of a fit, each declared once: flags of `mixity fit`, keys of fit definitions, keywords in Python, and
// fields of the explorer's page.
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

  /// The text of the default. Empty if there is none, or if it depends on the data.
  std::string initial() const { return write(FitRequest{}); }
};

/// In the order of help and of written definitions.
const std::vector<Setting>& settings();

/// Sets an option and adds its name to `request.stated`. Lists are separated by commas. Returns the problem as
/// Setting::read does. Throws std::invalid_argument for an unknown name.
std::string set_option(FitRequest& request, std::string_view name, std::string_view text);

/// Names and texts of the options in `request.stated`, by name.
std::vector<std::pair<std::string, std::string>> stated_options(const FitRequest& request);

/// An option that contradicts another, and the problem in the form of Setting::read.
struct Contradiction {
  std::string option, problem;
};
/// To be called when all options are set. Null if none contradicts another.
std::optional<Contradiction> contradiction(const FitRequest& request);

}  // namespace mixity
