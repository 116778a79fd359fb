#include "mechanics/laws/law_workspace.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/laws/criterion.h"

namespace mixity {
namespace {

constexpr double kSteers = 1e-9;
// Steps of the differences in a parameter of a function: a part of its size, which is a part of a range about 0 at
// least. The quartic leaves the fourth power of the former, rounding 1e-15 over the step.
constexpr double kDifference = 1e-3, kLeastPart = 1e-3;

}  // namespace

LawWorkspace::LawWorkspace(const ExpressionLaw& law) : law_(law), form_(law.form()) {
  if (!form_.text.empty()) text_.emplace(form_.text, form_.variables);
  if (!form_.logarithm.empty()) logarithm_.emplace(form_.logarithm, form_.variables);
}

const LawTraits& LawWorkspace::traits(std::span<const double> parameters) {
  if (!traits_ || !std::equal(parameters.begin(), parameters.end(), traits_->p.begin(), traits_->p.end()))
    traits_ = traits_of(*this, parameters);
  return *traits_;
}

LawWorkspace::Variables LawWorkspace::variables_of(const LawState& state, std::span<const Taylor> parameters) const {
  Variables variables{state.psi,
                      form_.uses_B ? state.sin * state.sin : Taylor(),
                      form_.uses_t ? state.sin / state.cos : Taylor(),
                      {},
                      {},
                      state.sin,
                      state.cos};
  std::copy(parameters.begin(), parameters.end(), variables.begin() + kBefore);
  return variables;
}

std::optional<LawWorkspace::Solved> LawWorkspace::solve(const LawState& state,
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
  if (logarithm_) {
    const Expression& form = *logarithm_;
    if (state.about)
      if (const auto root = contracted_root(equation(form), state.about->value))
        return Solved{root->q, root->slope, &form};
    if (const auto root = contracted_root(equation(form), 0)) return Solved{root->q, root->slope, &form};
  }
  const Expression& form = *text_;
  auto root = contracted_root(equation(form), 0);
  if (!root) root = enclosed_root(equation(form));
  if (!root) return std::nullopt;
  return Solved{root->q, root->slope, &form};
}

const SampledLaw* LawWorkspace::sampled(std::span<const double> parameters) {
  const LawDefinition& definition = law_.definition();
  if (!definition.sampler) return nullptr;
  const ParameterValues wanted(parameters);
  for (std::size_t i = 0; i < kSampled; ++i) {
    const Sampled& one = sampled_[(last_sampled_ + kSampled - i) % kSampled];
    if (one.law && one.parameters == wanted) return one.law.get();
  }
  auto made = std::make_unique<const SampledLaw>(*definition.sampler, parameters);
  last_sampled_ = (last_sampled_ + 1) % kSampled;
  sampled_[last_sampled_] = {wanted, std::move(made)};
  return sampled_[last_sampled_].law.get();
}

double LawWorkspace::sampled_log_value(const LawState& state, std::span<const Taylor> parameters,
                                       std::span<double> gradient) {
  // derivatives of the quartic through five points a step apart, at the first, second and third of them
  constexpr double kWeights[3][5] = {{-25, 48, -36, 16, -3}, {-3, -10, 18, -6, 1}, {1, -8, 0, 8, -1}};
  std::array<double, ExpressionLaw::kMostParameters> numbers{};
  for (std::size_t k = 0; k < parameters.size(); ++k) numbers[k] = parameters[k].value;
  const std::span<const double> p(numbers.data(), parameters.size());
  const auto here = [&] { return sampled(p)->log_toughness(state.psi.value, state.cos.value); };
  for (std::size_t k = 0; k < gradient.size(); ++k) {
    const LawParameter& range = law_.definition().parameters[k];
    const double x = numbers[k], width = range.upper - range.lower;
    // near a bound the distance from it may be all that matters, as that of lambda from 1 in model a
    const double room_left = std::min(x - range.lower, range.upper - x);
    const double least = kLeastPart * (range.lower <= 0 && range.upper >= 0 ? width : std::abs(x));
    const double size = std::max(std::min(std::abs(x), room_left), least);
    const double step = std::min(kDifference * size, 0.125 * width);
    const auto room = [&](double distance) { return distance < step ? 0 : distance < 2 * step ? 1 : 2; };
    const int below = room(x - range.lower), above = room(range.upper - x);
    // from the bound inwards where that is near
    const double direction = below <= above ? 1 : -1;
    const int at = std::min(below, above);
    double sum = 0;
    for (int i = 0; i < 5; ++i) {
      if (kWeights[at][i] == 0) continue;
      numbers[k] = x + direction * (i - at) * step;
      sum += kWeights[at][i] * here();
    }
    numbers[k] = x;
    gradient[k] = direction * sum / (12 * step);
  }
  return here();
}

Taylor LawWorkspace::value(const LawState& state, std::span<const Taylor> parameters) {
  if (law_.definition().sampler) {
    std::array<double, ExpressionLaw::kMostParameters> p;
    std::transform(parameters.begin(), parameters.end(), p.begin(), [](const Taylor& one) { return one.value; });
    return sampled({p.data(), parameters.size()})->toughness(state.psi, state.cos);
  }
  Variables variables = variables_of(state, parameters);
  const std::span<const Taylor> used(variables.data(), kBefore + parameters.size());
  if (!form_.equation) return (*text_)(used);
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

double LawWorkspace::log_value(const LawState& state, std::span<Taylor> parameters, std::span<double> gradient) {
  if (law_.definition().sampler) return sampled_log_value(state, parameters, gradient);
  Variables variables = variables_of(state, parameters);
  const std::span<const Taylor> used(variables.data(), kBefore + parameters.size());
  const auto along = [&](std::size_t k, const Expression& expression) {
    variables[kBefore + k].first = 1;
    const Taylor found = expression(used);
    variables[kBefore + k].first = 0;
    return found;
  };
  if (!form_.equation) {
    const Expression& expression = *text_;
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

Taylor LawWorkspace::toughness(const LawState& state, std::span<const Taylor> parameters) {
  if (!law_.definition().normalised) return value(state, parameters);
  const Taylor f0 = value({Taylor(0), Taylor(0), Taylor(1)}, parameters);
  LawState own = state;
  if (own.about) own.about->value += std::log(f0.value);
  return value(own, parameters) / f0;
}

double LawWorkspace::log_toughness(const Mixity<double>& mixity, std::span<const double> parameters,
                                   std::span<double> gradient) {
  std::array<Taylor, ExpressionLaw::kMostParameters> numbers;
  std::copy(parameters.begin(), parameters.end(), numbers.begin());
  const std::span<Taylor> p(numbers.data(), parameters.size());
  const double c = std::max(mixity.cos, kLeastCosine), psi = form_.uses_psi ? std::atan2(mixity.sin, c) : 0;
  const double log_f = log_value({psi, mixity.sin, c}, p, gradient);
  if (!law_.definition().normalised) return log_f;
  std::array<double, ExpressionLaw::kMostParameters> at_zero{};
  const double log_f0 = log_value({0, 0, 1}, p, {at_zero.data(), gradient.size()});
  for (std::size_t k = 0; k < gradient.size(); ++k) gradient[k] -= at_zero[k];
  return log_f - log_f0;
}

double LawWorkspace::toughness(double psi, std::span<const double> parameters) {
  std::array<Taylor, ExpressionLaw::kMostParameters> p;
  std::copy(parameters.begin(), parameters.end(), p.begin());
  const Mixity<double> mixity = mixity_from_angle(psi);
  return toughness({psi, mixity.sin, std::max(mixity.cos, kLeastCosine)}, {p.data(), parameters.size()}).value;
}

}  // namespace mixity
