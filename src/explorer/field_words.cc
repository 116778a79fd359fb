#include "explorer/field_words.h"

#include <algorithm>
#include <string_view>

#include "analysis/settings.h"

namespace mixity::explorer {
namespace {

/// What the button of an option says before and after the value.
struct Button {
  std::string_view option, before, after;
  bool adds = false, reads = false;
};

constexpr Button kButtons[] = {
    {"free", "Fit ", " too", true},
    {"drift", "Fit a drift of ", " over the runs", true},
    {"by_run", "Fit ", " of each run", true},
    {"leave_out", "Leave out run ", "", true},
    {"exclude", "Leave out line ", "", true},
    {"shape", "Fit an ", "", false, true},
    {"unsheared", "Fit points without shear with a toughness of their ", ""},
    {"loss", "Fit with the loss ", ", which outliers hardly move"},
    {"objective", "Fit with the objective ", ""},
    {"control", "Read delta as the ", " that is held", false, true},
    {"decimal", "Read ", " as the decimal sign", false, true},
    {"table", "Read table ", "", false, true},
    {"load_from", "Take loads from the names of files: ", "", false, true},
};

bool is_setting(std::string_view option) {
  return std::any_of(settings().begin(), settings().end(), [&](const Setting& one) { return one.name == option; });
}

/// Null if no button sets this: the user has to fill in something, or the page has a field for it.
const Button* button_of(const Remedy::Choice& choice) {
  if (choice.placeholder || choice.value.empty()) return nullptr;
  const Button* const found = std::find_if(std::begin(kButtons), std::end(kButtons),
                                           [&](const Button& one) { return one.option == choice.option; });
  return found == std::end(kButtons) ? nullptr : found;
}

std::string label(const Button& button, std::string value) {
  if (button.option == "exclude" && value.find_first_of(",-") != std::string::npos) return "Leave out lines " + value;
  if (!button.reads && button.option != "leave_out") std::replace(value.begin(), value.end(), '_', ' ');
  return std::string(button.before) + value + std::string(button.after);
}

}  // namespace

std::string in_fields(const Remedy& remedy) {
  if (remedy.kind == Remedy::Kind::given || remedy.kind == Remedy::Kind::state) return "";
  const auto& [first, value, placeholder] = remedy.choices[0];
  if (first == "columns") return "write " + value + " under “Take other columns”";
  if (first == "load" || first == "pixel" || first == "sheet") return '"' + value + "\" under “More of the file”";
  std::string options;
  for (const Remedy::Choice& one : remedy.choices) {
    options += options.empty() ? "" : ", ";
    if (const Button* const button = button_of(one))
      options += "“" + label(*button, one.value) + "”";
    else
      options += one.option + (one.value.empty() ? "" : "=\"" + one.value + '"') +
                 (is_setting(one.option) ? " under “More of the fit”" : " in the program");
  }
  return options;
}

Json buttons_of(const Message& message) {
  auto buttons = Json::array();
  for (const Remedy& remedy : message.remedies())
    for (const Remedy::Choice& one : remedy.choices)
      if (const Button* const button = button_of(one))
        buttons.push_back({{"option", one.option},
                           {"value", one.value},
                           {"label", label(*button, one.value)},
                           {"adds", button->adds},
                           {"reads", button->reads}});
  return buttons;
}

}  // namespace mixity::explorer
