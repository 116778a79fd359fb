#include "mechanics/laws/law.h"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cmath>
#include <deque>
#include <limits>
#include <mutex>
#include <regex>

#include "mechanics/laws/criterion.h"
#include "mechanics/laws/law_traits.h"

namespace mixity {
namespace {

constexpr const char* kVariables[] = {"psi", "B", "t", "K_I", "K_II"};
constexpr const char* kNormalised = ", over its value at psi = 0";
constexpr const char* kOwn[] = {"sin_psi", "cos_psi"};  // what sin(psi) and cos(psi) become

constexpr double kSteers = 1e-9;
// Steps of the differences in a parameter of a function: a part of its size, which is a part of a range about 0 at
// least. The quartic leaves the fourth power of the former, rounding 1e-15 over the step.
constexpr double kDifference = 1e-3, kLeastPart = 1e-3;

/// tan(psi), sin(psi) and cos(psi) as they are known beside psi, whose rounding they would magnify near 90 degrees.
std::string with_known_functions(const std::string& text) {
  static const std::regex tangent(R"(\btan *\( *psi *\))"), sine(R"(\bsin *\( *psi *\))"),
      cosine(R"(\bcos *\( *psi *\))");
  return std::regex_replace(std::regex_replace(std::regex_replace(text, tangent, "t"), sine, "sin_psi"), cosine,
                            "cos_psi");
}

}  // namespace

std::shared_ptr<const ExpressionLaw> ExpressionLaw::make(LawDefinition definition, LawError& error) {
  const auto fail = [&](std::optional<std::size_t> at, std::string message) {
    error = {at, std::move(message)};
    return std::shared_ptr<const ExpressionLaw>{};
  };
  if (!is_variable_name(definition.key))
    return fail({}, "'" + definition.key + "' cannot be the key of a law: a letter, then letters, digits and _");
  if (definition.parameters.empty() || definition.parameters.size() > kMostParameters)
    return fail({}, "a law has 1 to " + std::to_string(kMostParameters) +
                        " parameters, each stated with its range; this one has " +
                        std::to_string(definition.parameters.size()));
  std::vector<std::string> variables;  // a function has none
  if (!definition.sampler) variables.assign(std::begin(kVariables), std::end(kVariables));
  for (const LawParameter& one : definition.parameters) {
    if (!is_variable_name(one.name) || std::find(std::begin(kOwn), std::end(kOwn), one.name) != std::end(kOwn))
      return fail({}, "'" + one.name +
                          "' cannot be the name of a parameter: that is a letter, then letters, digits and _, and no "
                          "function or word of expressions");
    if (std::find(variables.begin(), variables.end(), one.name) != variables.end())
      return fail({}, "'" + one.name + "' is a variable or stands twice: it cannot be the name of a parameter");
    if (!(std::abs(one.lower) <= 1e100 && std::abs(one.upper) <= 1e100 && one.lower < one.upper))
      return fail({}, "the range of " + one.name + " must be two numbers within 1e100, the smaller first");
    if (!(one.start >= one.lower && one.start <= one.upper))
      return fail({}, "the start of " + one.name + " lies outside its range");
    variables.push_back(one.name);
  }
  const std::shared_ptr<ExpressionLaw> law(new ExpressionLaw);
  static std::atomic<std::size_t> made = 0;
  law->number_ = made += 2;
  if (definition.sampler) {
    law->shown_ = "f = " + definition.text + (definition.normalised ? kNormalised : "");
    law->definition_ = std::move(definition);
    return law;
  }
  const std::size_t equals = definition.text.find('=');
  const std::string& text = definition.text;
  if (equals != std::string::npos) {
    for (const auto& [begin, end] : {std::pair(std::size_t{0}, equals), {equals + 1, text.size()}})
      if (const Expression side(std::string_view(text).substr(begin, end - begin), variables); side.error())
        return fail(begin + side.error()->at, side.error()->message);
  } else if (const Expression whole(text, variables); whole.error()) {
    return fail(whole.error()->at, whole.error()->message);
  }
  static const std::regex intensity(R"(\bK_II?\b)");
  const bool of_intensities = std::regex_search(text, intensity);
  if (equals != std::string::npos && !of_intensities)
    return fail(equals, "an equation is solved for K_I and K_II, and these are not in it");
  std::string left = definition.text, right = "K_I^2+K_II^2";
  if (equals != std::string::npos) {
    left = definition.text.substr(0, equals);
    right = definition.text.substr(equals + 1);
  }
  law->equation_ = of_intensities;
  law->text_ = with_known_functions(of_intensities ? "(" + left + ")-(" + right + ")" : definition.text);
  if (of_intensities) law->logarithm_ = with_known_functions("log((" + left + ")/(" + right + "))");
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
  if (definition.normalised) law->shown_ += kNormalised;
  law->definition_ = std::move(definition);
  if (const Expression check(law->text_, law->variables_); check.error()) return fail({}, check.error()->message);
  if (law->equation_ && Expression(law->logarithm_, law->variables_).error()) law->logarithm_.clear();
  return law;
}

const Expression& ExpressionLaw::compiled(const std::string& text, std::size_t number) const {
  thread_local std::deque<std::pair<std::size_t, Expression>> known;  // which stay where they are
  for (const auto& [of, expression] : known)
    if (of == number) return expression;
  return known.emplace_back(number, Expression(text, variables_)).second;
}

ExpressionLaw::Variables ExpressionLaw::variables_of(const State& state, std::span<const Taylor> parameters) const {
  Variables variables{state.psi,
                      uses_B_ ? state.sin * state.sin : Taylor(),
                      uses_t_ ? state.sin / state.cos : Taylor(),
                      {},
                      {},
                      state.sin,
                      state.cos};
  std::copy(parameters.begin(), parameters.end(), variables.begin() + kBefore);
  return variables;
}

std::optional<ExpressionLaw::Solved> ExpressionLaw::solve(const State& state,
                                                          std::span<const Taylor> parameters) const {
  Variables variables = variables_of(state, parameters);
  for (Taylor& one : variables) one = Taylor(one.value);
  const double sine = state.sin.value, cosine = state.cos.value;
  const auto equation = [&](const Expression& form) {
    return [&](double q) {
      const double size = std::exp(0.5 * q), I = size * cosine, II = size * sine;
      variables[3] = {I, 0.5 * I, 0.25 * I};
      variables[4] = {II, 0.5 * II, 0.25 * II};
      return form(std::span<const Taylor>(variables.data(), kBefore + parameters.size()));
    };
  };
  if (!logarithm_.empty()) {
    const Expression& form = compiled(logarithm_, number_ + 1);
    if (state.about)
      if (const auto root = contracted_root(equation(form), state.about->value))
        return Solved{root->q, root->slope, &form};
    if (const auto root = contracted_root(equation(form), 0)) return Solved{root->q, root->slope, &form};
  }
  const Expression& form = compiled(text_, number_);
  auto root = contracted_root(equation(form), 0);
  if (!root) root = enclosed_root(equation(form));
  if (!root) return std::nullopt;
  return Solved{root->q, root->slope, &form};
}

const SampledLaw* ExpressionLaw::sampled(std::span<const double> parameters) const {
  struct Known {
    std::size_t number = 0, count = 0;
    std::array<double, kMostParameters> p{};
    std::unique_ptr<const SampledLaw> law;
  };
  if (!definition_.sampler) return nullptr;
  constexpr std::size_t kKept = 32;  // a gradient asks for four beside each parameter
  thread_local std::array<Known, kKept> known;
  thread_local std::size_t last = 0;
  for (std::size_t i = 0; i < kKept; ++i) {
    const Known& one = known[(last + kKept - i) % kKept];
    if (one.number == number_ && one.count == parameters.size() &&
        std::equal(parameters.begin(), parameters.end(), one.p.begin()))
      return one.law.get();
  }
  Known made{number_, parameters.size(), {}, std::make_unique<SampledLaw>(*definition_.sampler, parameters)};
  std::copy(parameters.begin(), parameters.end(), made.p.begin());
  last = (last + 1) % kKept;
  known[last] = std::move(made);
  return known[last].law.get();
}

double ExpressionLaw::sampled_log_value(const State& state, std::span<const Taylor> parameters,
                                        std::span<double> gradient) const {
  // derivatives of the quartic through five points a step apart, at the first, second and third of them
  constexpr double kWeights[3][5] = {{-25, 48, -36, 16, -3}, {-3, -10, 18, -6, 1}, {1, -8, 0, 8, -1}};
  std::array<double, kMostParameters> numbers{};
  for (std::size_t k = 0; k < parameters.size(); ++k) numbers[k] = parameters[k].value;
  const std::span<const double> p(numbers.data(), parameters.size());
  const auto here = [&] { return sampled(p)->log_toughness(state.psi.value, state.cos.value); };
  for (std::size_t k = 0; k < gradient.size(); ++k) {
    const LawParameter& range = definition_.parameters[k];
    const double x = numbers[k], width = range.upper - range.lower;
    // near a bound the distance from it may be all that matters, as that of lambda from 1 in model a
    const double room_left = std::min(x - range.lower, range.upper - x);
    const double least = kLeastPart * (range.lower <= 0 && range.upper >= 0 ? width : std::abs(x));
    const double size = std::max(std::min(std::abs(x), room_left), least);
    const double step = std::min(kDifference * size, 0.125 * width);
    const auto room = [&](double distance) { return distance < step ? 0 : distance < 2 * step ? 1 : 2; };
    const int below = room(x - range.lower), above = room(range.upper - x);
    // from the bound inwards where that is near
    const double turn = below <= above ? 1 : -1;
    const int at = std::min(below, above);
    double sum = 0;
    for (int i = 0; i < 5; ++i) {
      if (kWeights[at][i] == 0) continue;
      numbers[k] = x + turn * (i - at) * step;
      sum += kWeights[at][i] * here();
    }
    numbers[k] = x;
    gradient[k] = turn * sum / (12 * step);
  }
  return here();
}

Taylor ExpressionLaw::value(const State& state, std::span<const Taylor> parameters) const {
  if (definition_.sampler) {
    std::array<double, kMostParameters> p;
    std::transform(parameters.begin(), parameters.end(), p.begin(), [](const Taylor& one) { return one.value; });
    return sampled({p.data(), parameters.size()})->toughness(state.psi, state.cos);
  }
  Variables variables = variables_of(state, parameters);
  const std::span<const Taylor> used(variables.data(), kBefore + parameters.size());
  if (!equation_) return compiled(text_, number_)(used);
  const auto solved = solve(state, parameters);
  if (!solved) return {std::numeric_limits<double>::quiet_NaN(), 0, 0};
  const auto left = [&](const Taylor& q) {
    const Taylor size = exp(q * Taylor(0.5));
    variables[3] = size * state.cos;
    variables[4] = size * state.sin;
    return (*solved->form)(used);
  };
  // q along the direction: what is left of the equation at each order, over its slope in q
  const auto moves = [](const Taylor& x) { return x.first != 0 || x.second != 0; };
  if (std::none_of(variables.begin(), variables.end(), moves)) return std::exp(solved->q);
  const Taylor about = state.about.value_or(Taylor());
  const Taylor rest = left({solved->q, about.first, about.second});
  const double lacks = -rest.first / solved->slope, first = about.first + lacks;
  // the second derivative, which only steers searches, has what the first lacked
  const bool known = std::abs(lacks) <= kSteers * (1 + std::abs(first));
  const double second =
      known ? about.second - rest.second / solved->slope : -left({solved->q, first, 0}).second / solved->slope;
  return exp(Taylor{solved->q, first, second});
}

double ExpressionLaw::log_value(const State& state, std::span<Taylor> parameters, std::span<double> gradient) const {
  if (definition_.sampler) return sampled_log_value(state, parameters, gradient);
  Variables variables = variables_of(state, parameters);
  const std::span<const Taylor> used(variables.data(), kBefore + parameters.size());
  const auto along = [&](std::size_t k, const Expression& expression) {
    variables[kBefore + k].first = 1;
    const Taylor found = expression(used);
    variables[kBefore + k].first = 0;
    return found;
  };
  if (!equation_) {
    const Expression& expression = compiled(text_, number_);
    if (gradient.empty()) return std::log(expression(used).value);
    double f = 0;
    for (std::size_t k = 0; k < gradient.size(); ++k) {
      const Taylor found = along(k, expression);
      f = found.value;
      gradient[k] = found.first / f;
    }
    return std::log(f);
  }
  const auto solved = solve(state, parameters);
  if (!solved) {
    std::fill(gradient.begin(), gradient.end(), 0.0);
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double size = std::exp(0.5 * solved->q);
  variables[3] = size * state.cos.value;
  variables[4] = size * state.sin.value;
  for (std::size_t k = 0; k < gradient.size(); ++k) gradient[k] = -along(k, *solved->form).first / solved->slope;
  return solved->q;
}

Taylor ExpressionLaw::toughness(const State& state, std::span<const Taylor> parameters) const {
  if (!definition_.normalised) return value(state, parameters);
  const Taylor f0 = value({Taylor(0), Taylor(0), Taylor(1)}, parameters);
  State own = state;
  if (own.about) own.about->value += std::log(f0.value);
  return value(own, parameters) / f0;
}

double ExpressionLaw::log_toughness(const Mixity<double>& mixity, std::span<const double> parameters,
                                    std::span<double> gradient) const {
  std::array<Taylor, kMostParameters> numbers;
  std::copy(parameters.begin(), parameters.end(), numbers.begin());
  const std::span<Taylor> p(numbers.data(), parameters.size());
  const double c = std::max(mixity.cos, kLeastCosine), psi = uses_psi_ ? std::atan2(mixity.sin, c) : 0;
  const double log_f = log_value({psi, mixity.sin, c}, p, gradient);
  if (!definition_.normalised) return log_f;
  std::array<double, kMostParameters> at_zero{};
  const double log_f0 = log_value({0, 0, 1}, p, {at_zero.data(), gradient.size()});
  for (std::size_t k = 0; k < gradient.size(); ++k) gradient[k] -= at_zero[k];
  return log_f - log_f0;
}

double ExpressionLaw::toughness(double psi, std::span<const double> parameters) const {
  std::array<Taylor, kMostParameters> p;
  std::copy(parameters.begin(), parameters.end(), p.begin());
  const Mixity<double> mixity = mixity_from_angle(psi);
  return toughness({psi, mixity.sin, std::max(mixity.cos, kLeastCosine)}, {p.data(), parameters.size()}).value;
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
  if (one.sampler != other.sampler) return known.shown() + ", another function";
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
         one.sampler == other.sampler &&
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
