#include "mechanics/laws/law.h"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cmath>
#include <mutex>
#include <regex>

#include "mechanics/laws/law_traits.h"

namespace mixity {
namespace {

constexpr const char* kVariables[] = {"psi", "B", "t", "K_I", "K_II"};
constexpr const char* kOwn[] = {"sin_psi", "cos_psi"};  // what sin(psi) and cos(psi) become

/// tan(psi), sin(psi) and cos(psi) as they are known beside psi, whose rounding they would magnify near 90 degrees.
std::string with_known_functions(const std::string& text) {
  static const std::regex tangent(R"(\btan *\( *psi *\))"), sine(R"(\bsin *\( *psi *\))"),
      cosine(R"(\bcos *\( *psi *\))");
  return std::regex_replace(std::regex_replace(std::regex_replace(text, tangent, "t"), sine, "sin_psi"), cosine,
                            "cos_psi");
}

Taylor constant(double value) { return {value, 0, 0}; }

}  // namespace

std::shared_ptr<const ExpressionLaw> ExpressionLaw::make(LawDefinition definition, LawError& error) {
  const auto fail = [&](std::optional<std::size_t> at, std::string message) {
    error = {at, std::move(message)};
    return std::shared_ptr<const ExpressionLaw>{};
  };
  if (!is_variable_name(definition.key))
    return fail({}, "'" + definition.key + "' cannot be the key of a law: a letter, then letters, digits and _");
  if (definition.parameters.empty() || definition.parameters.size() > kMostParameters)
    return fail({}, "a law has 1 to " + std::to_string(kMostParameters) + " parameters, this one " +
                        std::to_string(definition.parameters.size()));
  std::vector<std::string> variables(std::begin(kVariables), std::end(kVariables));
  for (const LawParameter& one : definition.parameters) {
    if (!is_variable_name(one.name) || std::find(std::begin(kOwn), std::end(kOwn), one.name) != std::end(kOwn))
      return fail({}, "'" + one.name + "' cannot be the name of a parameter");
    if (std::find(variables.begin(), variables.end(), one.name) != variables.end())
      return fail({}, "'" + one.name + "' is a variable or stands twice: it cannot be the name of a parameter");
    if (!(std::abs(one.lower) <= 1e100 && std::abs(one.upper) <= 1e100 && one.lower < one.upper))
      return fail({}, "the range of " + one.name + " must be two numbers, the smaller first");
    if (!(one.start >= one.lower && one.start <= one.upper))
      return fail({}, "the start of " + one.name + " lies outside its range");
    variables.push_back(one.name);
  }
  const std::shared_ptr<ExpressionLaw> law(new ExpressionLaw);
  const std::size_t equals = definition.text.find('=');
  std::string text = definition.text;
  if (equals != std::string::npos) {
    for (const auto& [begin, end] : {std::pair(std::size_t{0}, equals), {equals + 1, text.size()}})
      if (const Expression side(std::string_view(text).substr(begin, end - begin), variables); side.error())
        return fail(begin + side.error()->at, side.error()->message);
    text = "(" + text.substr(0, equals) + ")-(" + text.substr(equals + 1) + ")";
  } else if (const Expression whole(text, variables); whole.error()) {
    return fail(whole.error()->at, whole.error()->message);
  }
  static const std::regex intensity(R"(\bK_II?\b)");
  const bool of_intensities = std::regex_search(text, intensity);
  if (equals != std::string::npos && !of_intensities)
    return fail(equals, "an equation is solved for K_I and K_II, and these are not in it");
  if (of_intensities && equals == std::string::npos) text = "(" + text + ")-(K_I^2+K_II^2)";
  law->equation_ = of_intensities;
  law->text_ = with_known_functions(text);
  const auto uses = [&](const char* name) {
    return std::regex_search(law->text_, std::regex(std::string("\\b") + name + "\\b"));
  };
  law->uses_psi_ = uses("psi");
  law->uses_B_ = uses("B");
  law->uses_t_ = uses("t");
  for (const LawParameter& one : definition.parameters)
    if (!uses(one.name.c_str())) return fail({}, "parameter '" + one.name + "' is not in the expression");
  variables.insert(variables.begin() + std::size(kVariables), std::begin(kOwn), std::end(kOwn));
  law->variables_ = std::move(variables);
  law->shown_ = equals != std::string::npos ? definition.text : "f = " + definition.text;
  if (definition.normalised) law->shown_ += ", over its value at psi = 0";
  law->definition_ = std::move(definition);
  static std::atomic<std::size_t> made = 0;
  law->number_ = ++made;
  if (const Expression check(law->text_, law->variables_); check.error()) return fail({}, check.error()->message);
  return law;
}

const Expression& ExpressionLaw::compiled() const {
  thread_local std::vector<std::pair<std::size_t, Expression>> known;
  for (const auto& [number, expression] : known)
    if (number == number_) return expression;
  return known.emplace_back(number_, Expression(text_, variables_)).second;
}

Taylor ExpressionLaw::value(const State& state, std::span<const Taylor> parameters) const {
  const Expression& expression = compiled();
  constexpr std::size_t kBefore = std::size(kVariables) + std::size(kOwn);
  std::array<Taylor, kBefore + kMostParameters> variables{state.psi,
                                                          uses_B_ ? state.sin * state.sin : Taylor(),
                                                          uses_t_ ? state.sin / state.cos : Taylor(),
                                                          {},
                                                          {},
                                                          state.sin,
                                                          state.cos};
  std::copy(parameters.begin(), parameters.end(), variables.begin() + kBefore);
  const std::span<const Taylor> used(variables.data(), kBefore + parameters.size());
  if (!equation_) return expression(used);

  // For q = ln f: K_I = exp(q/2) cos psi, K_II = exp(q/2) sin psi.
  const auto left = [&](const Taylor& q, const Taylor& sine, const Taylor& cosine) {
    const Taylor size = exp(q * Taylor(0.5));
    variables[3] = size * cosine;
    variables[4] = size * sine;
    return expression(used);
  };
  const std::array<Taylor, kBefore + kMostParameters> moving = variables;
  for (Taylor& one : variables) one = constant(one.value);
  const Taylor sine = constant(state.sin.value), cosine = constant(state.cos.value);
  const auto at = [&](double q) { return left({q, 1, 0}, sine, cosine); };
  constexpr double kFar = 600;
  // a gradient asks for one state several times
  thread_local std::array<double, kBefore + kMostParameters + 1> solved{};
  thread_local double root = 0;
  std::array<double, kBefore + kMostParameters + 1> asked{static_cast<double>(number_)};
  for (std::size_t i = 0; i < variables.size(); ++i) asked[i + 1] = variables[i].value;
  const bool again = asked == solved;
  Taylor here = at(again ? root : 0);
  double q = again ? root : 0, low = -kFar, high = kFar;
  if (!again && here.value != 0) {
    double step = 0.25, beyond = 0;
    bool enclosed = false;
    // outwards on both sides, the nearer root first
    for (; step <= kFar && !enclosed; step *= 2)
      for (const double side : {step, -step})
        if (!enclosed && std::signbit(at(side).value) != std::signbit(here.value)) {
          enclosed = true;
          beyond = side;
        }
    if (!enclosed) return {std::numeric_limits<double>::quiet_NaN(), 0, 0};
    low = std::min(0.0, beyond);
    high = std::max(0.0, beyond);
    const bool rises = std::signbit(at(low).value);
    q = 0.5 * beyond;
    for (int i = 0; i < 200; ++i) {
      here = at(q);
      if (here.value == 0) break;
      (std::signbit(here.value) == rises ? low : high) = q;
      double next = q - here.value / here.first;
      if (!(next > low && next < high)) next = 0.5 * (low + high);
      const bool settled = std::abs(next - q) <= 1e-9 * std::max(1.0, std::abs(q)) || next == low || next == high;
      q = next;
      if (settled) break;
    }
    here = at(q);
    if (const double last = here.value / here.first; std::abs(last) < 1e-6 * std::max(1.0, std::abs(q))) q -= last;
  }
  solved = asked;
  root = q;
  // q along the direction: what is left of the equation at each order, over its slope in q
  variables = moving;
  const double first = -left({q, 0, 0}, state.sin, state.cos).first / here.first;
  variables = moving;
  const double second = -left({q, first, 0}, state.sin, state.cos).second / here.first;
  return exp(Taylor{q, first, second});
}

Taylor ExpressionLaw::toughness(const State& state, std::span<const Taylor> parameters) const {
  const Taylor f = value(state, parameters);
  if (!definition_.normalised) return f;
  return f / value({constant(0), constant(0), constant(1)}, parameters);
}

double ExpressionLaw::toughness(double psi, std::span<const double> parameters) const {
  std::array<Taylor, kMostParameters> p;
  std::copy(parameters.begin(), parameters.end(), p.begin());
  const Mixity<double> mixity = mixity_from_angle(psi);
  return toughness({constant(psi), constant(mixity.sin), constant(std::max(mixity.cos, kLeastCosine))},
                   std::span<const Taylor>(p.data(), parameters.size()))
      .value;
}

namespace {
struct Known {
  std::mutex one_at_a_time;
  std::vector<std::shared_ptr<const ExpressionLaw>> laws;
  std::vector<std::shared_ptr<const ExpressionLaw>> forgotten;  // stay: threads know what holds of a law by its address
};
Known& known() {
  static Known all;
  return all;
}

std::string range_of(const LawParameter& one) {
  std::string text;
  for (const double number : {one.lower, one.upper, one.start}) {
    char digits[32];
    text += text.empty() ? "" : text.find("..") == std::string::npos ? ".." : " start ";
    text.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
  }
  return text;
}

/// What a law that is known has otherwise than another one of its key, as what follows that.
std::string difference(const ExpressionLaw& known, const ExpressionLaw& given) {
  const LawDefinition &one = known.definition(), &other = given.definition();
  if (one.text != other.text || one.normalised != other.normalised)
    return known.shown() + (one.normalised == other.normalised ? ""
                            : one.normalised                   ? ", normalised"
                                                               : ", not normalised");
  if (one.parameters.size() != other.parameters.size())
    return known.shown() + ", of " + std::to_string(one.parameters.size()) + " parameters";
  for (std::size_t i = 0; i < one.parameters.size(); ++i) {
    const LawParameter &a = one.parameters[i], &b = other.parameters[i];
    if (a.name != b.name) return known.shown() + ", whose parameter " + std::to_string(i + 1) + " is " + a.name;
    if (a.lower != b.lower || a.upper != b.upper || a.start != b.start)
      return known.shown() + ", whose " + a.name + " is in " + range_of(a) + ", not in " + range_of(b);
  }
  return "";
}
}  // namespace

bool same_law(const LawDefinition& one, const LawDefinition& other) {
  return one.key == other.key && one.text == other.text && one.normalised == other.normalised &&
         std::equal(one.parameters.begin(), one.parameters.end(), other.parameters.begin(), other.parameters.end(),
                    [](const LawParameter& a, const LawParameter& b) {
                      return a.name == b.name && a.lower == b.lower && a.upper == b.upper && a.start == b.start;
                    });
}

std::shared_ptr<const ExpressionLaw> add_law(const std::shared_ptr<const ExpressionLaw>& made, LawError& error) {
  const std::lock_guard lock(known().one_at_a_time);
  for (const auto& other : known().laws) {
    if (other->definition().key != made->definition().key) continue;
    if (same_law(other->definition(), made->definition())) return other;
    error = {{},
             "there is another law '" + made->definition().key + "': " + difference(*other, *made) +
                 "; choose another key for this one"};
    return nullptr;
  }
  known().laws.push_back(made);
  return made;
}

std::shared_ptr<const ExpressionLaw> define_law(const LawDefinition& definition, LawError& error) {
  const std::shared_ptr<const ExpressionLaw> made = ExpressionLaw::make(definition, error);
  return made ? add_law(made, error) : made;
}

std::shared_ptr<const ExpressionLaw> find_law(std::string_view key) {
  const std::lock_guard lock(known().one_at_a_time);
  for (const auto& law : known().laws)
    if (law->definition().key == key) return law;
  return nullptr;
}

std::vector<std::string> law_keys() {
  const std::lock_guard lock(known().one_at_a_time);
  std::vector<std::string> keys;
  for (const auto& law : known().laws) keys.push_back(law->definition().key);
  return keys;
}

void forget_laws() {
  const std::lock_guard lock(known().one_at_a_time);
  known().forgotten.insert(known().forgotten.end(), known().laws.begin(), known().laws.end());
  known().laws.clear();
}

const ExpressionLaw*& current_law() {
  thread_local const ExpressionLaw* law = nullptr;
  return law;
}

}  // namespace mixity
