#include "mechanics/laws/user_law.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "mechanics/laws/law_workspace.h"

namespace mixity {
namespace {

constexpr const char* kVariables[] = {"psi", "B", "t", "K_I", "K_II"};
constexpr const char* kOwn[] = {"sin_psi", "cos_psi"};  // replace sin(psi) and cos(psi)
constexpr const char* kNormalised = ", over its value at psi = 0";

/// The first position, at `from` or later, at which a text contains a name; npos if there is none.
std::size_t find_name(std::string_view text, std::string_view name, std::size_t from = 0) {
  for (std::size_t at = text.find(name, from); at != std::string_view::npos; at = text.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    if ((at == 0 || !is_name_character(text[at - 1])) && (end == text.size() || !is_name_character(text[end])))
      return at;
  }
  return std::string_view::npos;
}

bool uses(std::string_view text, std::string_view name) { return find_name(text, name) != std::string_view::npos; }

/// The text with function(psi) replaced by `value`.
std::string with_value_of(std::string text, std::string_view function, std::string_view value) {
  const auto skip = [&](std::size_t at, std::string_view expected) {  // npos if something else follows
    at = text.find_first_not_of(' ', at);
    return at < text.size() && text.compare(at, expected.size(), expected) == 0 ? at + expected.size()
                                                                                : std::string::npos;
  };
  for (std::size_t at = find_name(text, function); at != std::string::npos; at = find_name(text, function, at + 1)) {
    std::size_t end = at + function.size();
    for (const char* expected : {"(", "psi", ")"})
      if (end != std::string::npos) end = skip(end, expected);
    if (end != std::string::npos) text.replace(at, end - at, value);
  }
  return text;
}

/// Replaces tan(psi), sin(psi) and cos(psi) by variables: computed from psi, they would magnify its rounding near 90
/// degrees.
std::string with_known_functions(std::string text) {
  text = with_value_of(std::move(text), "tan", "t");
  return with_value_of(with_value_of(std::move(text), "sin", kOwn[0]), "cos", kOwn[1]);
}

/// Why the key or the parameters are invalid. Appends the parameters' names to `variables`.
std::optional<LawError> problem_of(const LawDefinition& definition, std::vector<std::string>& variables) {
  constexpr std::size_t kMost = UserLaw::kMostParameters;
  const auto error = [](std::string message) { return LawError{{}, std::move(message)}; };
  if (!is_variable_name(definition.key))
    return error("'" + definition.key + "' cannot be the key of a law: a letter, then letters, digits and _");
  if (definition.parameters.empty() || definition.parameters.size() > kMost)
    return error("a law has 1 to " + std::to_string(kMost) + " parameters, each stated with its range; this one has " +
                 std::to_string(definition.parameters.size()));
  for (const LawParameter& one : definition.parameters) {
    if (!is_variable_name(one.name) || std::find(std::begin(kOwn), std::end(kOwn), one.name) != std::end(kOwn))
      return error("'" + one.name +
                   "' cannot be the name of a parameter: that is a letter, then letters, digits and _, and no "
                   "function or word of expressions");
    if (std::find(variables.begin(), variables.end(), one.name) != variables.end())
      return error("'" + one.name + "' is a variable or stands twice: it cannot be the name of a parameter");
    if (!(std::abs(one.lower) <= 1e100 && std::abs(one.upper) <= 1e100 && one.lower < one.upper))
      return error("the range of " + one.name + " must be two numbers within 1e100, the smaller first");
    if (!(one.start >= one.lower && one.start <= one.upper))
      return error("the start of " + one.name + " lies outside its range");
    variables.push_back(one.name);
  }
  return std::nullopt;
}

/// Reads the text of a definition that has no sampler.
std::optional<LawError> read_text(const LawDefinition& definition, std::vector<std::string> variables, LawForm& form) {
  const std::string& text = definition.text;
  const std::size_t equals = text.find('=');
  const bool is_equation = equals != std::string::npos;
  const std::string left = text.substr(0, equals), right = is_equation ? text.substr(equals + 1) : "K_I^2+K_II^2";
  if (const Expression side(left, variables); side.error()) return side.error();
  if (is_equation)
    if (const Expression side(right, variables); side.error())
      return LawError{equals + 1 + *side.error()->at, side.error()->message};
  form.equation = uses(text, "K_I") || uses(text, "K_II");
  if (is_equation && !form.equation)
    return LawError{equals, "an equation is solved for K_I and K_II, and these are not in it"};
  form.text = with_known_functions(form.equation ? "(" + left + ")-(" + right + ")" : text);
  if (form.equation) form.logarithm = with_known_functions("log((" + left + ")/(" + right + "))");
  form.uses_psi = uses(form.text, "psi");
  form.uses_B = uses(form.text, "B");
  form.uses_t = uses(form.text, "t");
  for (const LawParameter& one : definition.parameters)
    if (!uses(form.text, one.name)) return LawError{{}, "parameter '" + one.name + "' is not in the expression"};
  variables.insert(variables.begin() + std::size(kVariables), std::begin(kOwn), std::end(kOwn));
  form.variables = std::move(variables);
  if (const Expression check(form.text, form.variables); check.error()) return LawError{{}, check.error()->message};
  if (form.equation && Expression(form.logarithm, form.variables).error()) form.logarithm.clear();
  return std::nullopt;
}

}  // namespace

bool same_law(const LawDefinition& one, const LawDefinition& other) {
  return one.key == other.key && one.text == other.text && one.normalised == other.normalised &&
         one.sampler == other.sampler &&
         std::equal(one.parameters.begin(), one.parameters.end(), other.parameters.begin(), other.parameters.end(),
                    [](const LawParameter& a, const LawParameter& b) {
                      return a.name == b.name && a.lower == b.lower && a.upper == b.upper && a.start == b.start;
                    });
}

std::shared_ptr<const UserLaw> UserLaw::make(LawDefinition definition, LawError& error) {
  std::vector<std::string> variables;  // a function has none
  if (!definition.sampler) variables.assign(std::begin(kVariables), std::end(kVariables));
  LawForm form;
  std::optional<LawError> problem = problem_of(definition, variables);
  if (!problem && !definition.sampler) problem = read_text(definition, std::move(variables), form);
  if (!problem) return std::shared_ptr<const UserLaw>(new UserLaw(std::move(definition), std::move(form)));
  error = std::move(*problem);
  return nullptr;
}

UserLaw::UserLaw(LawDefinition definition, LawForm form) : definition_(std::move(definition)), form_(std::move(form)) {
  const bool stated_as_equation = !definition_.sampler && definition_.text.find('=') != std::string::npos;
  shown_ = (stated_as_equation ? "" : "f = ") + definition_.text + (definition_.normalised ? kNormalised : "");
  info_ = {definition_.key, definition_.name.empty() ? definition_.key : definition_.name, shown_};
  for (const LawParameter& one : definition_.parameters)
    parameters_.push_back({one.name, one.lower, one.upper, one.start});
}

UserLaw::~UserLaw() = default;

double UserLaw::toughness(double psi, std::span<const double> parameters) const {
  return std::exp(LawLease(*this).workspace().log_toughness(mixity_from_angle(psi), parameters, {}));
}

LawLease::LawLease(const UserLaw& law) : law_(law) {
  {
    const std::lock_guard lock(law_.mutex_);
    if (!law_.idle_.empty()) {
      workspace_ = std::move(law_.idle_.back());
      law_.idle_.pop_back();
    }
  }
  if (!workspace_) workspace_ = std::make_unique<LawWorkspace>(law_);
}

LawLease::~LawLease() {
  const std::lock_guard lock(law_.mutex_);
  law_.idle_.push_back(std::move(workspace_));
}

}  // namespace mixity
