#include "mechanics/laws/law_workspace.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mixity {

LawWorkspace::LawWorkspace(const UserLaw& law) : law_(law), form_(law.form()) {
  if (!form_.text.empty()) text_.emplace(form_.text, form_.variables);
  if (!form_.logarithm.empty()) logarithm_.emplace(form_.logarithm, form_.variables);
}

const LawTraits& LawWorkspace::traits(std::span<const double> p) {
  if (!traits_ || !std::equal(p.begin(), p.end(), traits_->p.begin(), traits_->p.end())) traits_ = traits_of(*this, p);
  return *traits_;
}

LawWorkspace::Variables LawWorkspace::variables_of(const LawState& state, std::span<const double> p) const {
  Variables variables{state.psi,
                      form_.uses_B ? state.sin * state.sin : Taylor(),
                      form_.uses_t ? state.sin / state.cos : Taylor(),
                      {},
                      {},
                      state.sin,
                      state.cos};
  std::copy(p.begin(), p.end(), variables.begin() + kBefore);
  return variables;
}

std::optional<LawWorkspace::Solved> LawWorkspace::solve(const LawState& state, std::span<const double> p) const {
  Variables variables = variables_of(state, p);
  for (Taylor& one : variables) one = Taylor(one.value);
  const double sine = state.sin.value, cosine = state.cos.value;
  const auto equation = [&](const Expression& form) {
    return [&](double q) {
      const double size = std::exp(0.5 * q), I = size * cosine, II = size * sine;
      variables[3] = {I, 0.5 * I, 0.25 * I};
      variables[4] = {II, 0.5 * II, 0.25 * II};
      return form(std::span<const Taylor>(variables.data(), kBefore + p.size()));
    };
  };
  if (logarithm_) {
    if (state.about)
      if (const auto root = contracted_root(equation(*logarithm_), state.about->value))
        return Solved{*root, &*logarithm_};
    if (const auto root = contracted_root(equation(*logarithm_), 0)) return Solved{*root, &*logarithm_};
  }
  auto root = contracted_root(equation(*text_), 0);
  if (!root) root = enclosed_root(equation(*text_));
  return root ? std::optional(Solved{*root, &*text_}) : std::nullopt;
}

const SampledToughness* LawWorkspace::sampled(std::span<const double> p) {
  const LawDefinition& definition = law_.definition();
  if (!definition.sampler) return nullptr;
  const ParameterValues wanted(p);
  for (std::size_t i = 0; i < kSampled; ++i) {
    const Sampled& one = sampled_[(last_sampled_ + kSampled - i) % kSampled];
    if (one.toughness && one.parameters == wanted) return one.toughness.get();
  }
  auto made = std::make_unique<const SampledToughness>(*definition.sampler, p);
  last_sampled_ = (last_sampled_ + 1) % kSampled;
  sampled_[last_sampled_] = {wanted, std::move(made)};
  return sampled_[last_sampled_].toughness.get();
}

/// Derivatives of the quartic through five values a step apart. The step is a thousandth of the parameter (near 0, of a
/// thousandth of its range), so the error is its fourth power, plus rounding of 1e-15 over the step.
double LawWorkspace::sampled_log_value(const LawState& state, ParameterValues p, std::span<double> gradient) {
  constexpr double kDifference = 1e-3, kLeastPart = 1e-3;
  constexpr double kWeights[3][5] = {// at the first, second and third of the five
                                     {-25, 48, -36, 16, -3},
                                     {-3, -10, 18, -6, 1},
                                     {1, -8, 0, 8, -1}};
  const auto here = [&] { return sampled(p)->log_toughness(state.psi.value, state.cos.value); };
  for (std::size_t k = 0; k < gradient.size(); ++k) {
    const LawParameter& range = law_.definition().parameters[k];
    const double x = p[k], width = range.upper - range.lower;
    // near a bound only the distance from it may matter, such as that of lambda from 1 in model a
    const double room_left = std::min(x - range.lower, range.upper - x);
    const double least = kLeastPart * (range.lower <= 0 && range.upper >= 0 ? width : std::abs(x));
    const double size = std::max(std::min(std::abs(x), room_left), least);
    const double step = std::min(kDifference * size, 0.125 * width);
    const auto room = [&](double distance) { return distance < step ? 0 : distance < 2 * step ? 1 : 2; };
    const int below = room(x - range.lower), above = room(range.upper - x);
    const double direction = below <= above ? 1 : -1;  // from the nearer bound inwards
    const int at = std::min(below, above);
    double sum = 0;
    for (int i = 0; i < 5; ++i) {
      if (kWeights[at][i] == 0) continue;
      p[k] = x + direction * (i - at) * step;
      sum += kWeights[at][i] * here();
    }
    p[k] = x;
    gradient[k] = direction * sum / (12 * step);
  }
  return here();
}

Taylor LawWorkspace::value(const LawState& state, std::span<const double> p) {
  constexpr double kSteers = 1e-9;
  if (law_.definition().sampler) return sampled(p)->toughness(state.psi, state.cos);
  Variables variables = variables_of(state, p);
  const std::span<const Taylor> used(variables.data(), kBefore + p.size());
  if (!form_.equation) return (*text_)(used);
  const auto solved = solve(state, p);
  if (!solved) return {std::numeric_limits<double>::quiet_NaN(), 0, 0};
  const auto [root, slope] = solved->root;
  const auto moves = [](const Taylor& x) { return x.first != 0 || x.second != 0; };
  if (std::none_of(variables.begin(), variables.end(), moves)) return std::exp(root);
  const auto left = [&](const Taylor& q) {
    const Taylor size = exp(q * Taylor(0.5));
    variables[3] = size * state.cos;
    variables[4] = size * state.sin;
    return (*solved->form)(used);
  };
  // derivatives of q along the direction: the remainder of the equation at each order, over its slope in q
  const Taylor about = state.about.value_or(Taylor());
  const Taylor rest = left({root, about.first, about.second});
  const double lacks = -rest.first / slope, first = about.first + lacks;
  // the second derivative only steers searches; it may contain an error of the first
  const bool known = std::abs(lacks) <= kSteers * (1 + std::abs(first));
  const double second = known ? about.second - rest.second / slope : -left({root, first, 0}).second / slope;
  return exp(Taylor{root, first, second});
}

double LawWorkspace::log_value(const LawState& state, std::span<const double> p, std::span<double> gradient) {
  if (law_.definition().sampler) return sampled_log_value(state, ParameterValues(p), gradient);
  Variables variables = variables_of(state, p);
  const std::span<const Taylor> used(variables.data(), kBefore + p.size());
  const auto along = [&](std::size_t k, const Expression& expression) {
    variables[kBefore + k].first = 1;
    const Taylor found = expression(used);
    variables[kBefore + k].first = 0;
    return found;
  };
  if (!form_.equation) {
    if (gradient.empty()) return std::log((*text_)(used).value);
    double f = 0;
    for (std::size_t k = 0; k < gradient.size(); ++k) {
      const Taylor found = along(k, *text_);
      f = found.value;
      gradient[k] = found.first / f;
    }
    return std::log(f);
  }
  const auto solved = solve(state, p);
  if (!solved) {
    std::fill(gradient.begin(), gradient.end(), 0.0);
    return std::numeric_limits<double>::quiet_NaN();
  }
  const auto [root, slope] = solved->root;
  const double size = std::exp(0.5 * root);
  variables[3] = size * state.cos.value;
  variables[4] = size * state.sin.value;
  for (std::size_t k = 0; k < gradient.size(); ++k) gradient[k] = -along(k, *solved->form).first / slope;
  return root;
}

Taylor LawWorkspace::toughness(const LawState& state, std::span<const double> p) {
  if (!law_.definition().normalised) return value(state, p);
  const Taylor f0 = value({Taylor(0), Taylor(0), Taylor(1)}, p);
  LawState own = state;
  if (own.about) own.about->value += std::log(f0.value);
  return value(own, p) / f0;
}

double LawWorkspace::log_toughness(const Mixity<double>& mixity, std::span<const double> p,
                                   std::span<double> gradient) {
  const double c = std::max(mixity.cos, kLeastCosine), psi = form_.uses_psi ? std::atan2(mixity.sin, c) : 0;
  const double log_f = log_value({psi, mixity.sin, c}, p, gradient);
  if (!law_.definition().normalised) return log_f;
  std::array<double, UserLaw::kMostParameters> at_zero{};
  const double log_f0 = log_value({0, 0, 1}, p, {at_zero.data(), gradient.size()});
  for (std::size_t k = 0; k < gradient.size(); ++k) gradient[k] -= at_zero[k];
  return log_f - log_f0;
}

}  // namespace mixity
