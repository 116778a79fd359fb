// The evaluation of a law that was defined at run time (law.h).
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "mechanics/laws/expression.h"
#include "mechanics/laws/law.h"
#include "mechanics/laws/law_traits.h"

namespace mixity {

/// What one thread needs to evaluate a law: its compiled expressions, and what was found last. Results are functions of
/// the arguments alone, the same in every workspace.
class LawWorkspace {
 public:
  explicit LawWorkspace(const ExpressionLaw& law);

  const ExpressionLaw& law() const { return law_; }

  /// f with its first two derivatives along the direction in which the state and the parameters change; under a law
  /// that is a function the parameters must not change. NaN where the law is not defined.
  Taylor toughness(const LawState& state, std::span<const Taylor> parameters);

  /// ln f, with its derivatives in the parameters unless `gradient` is empty, which costs less.
  double log_toughness(const Mixity<double>& mixity, std::span<const double> parameters, std::span<double> gradient);

  /// f at the phase angle psi [rad].
  double toughness(double psi, std::span<const double> parameters);

  /// Null unless the law is a function. Valid until the next call of a member.
  const SampledLaw* sampled(std::span<const double> parameters);

  /// Valid until the next call.
  const LawTraits& traits(std::span<const double> parameters);

 private:
  static constexpr std::size_t kBefore = 7;    // variables before the parameters
  static constexpr std::size_t kSampled = 32;  // sets of parameters; a gradient asks for four beside each parameter
  using Variables = std::array<Taylor, kBefore + ExpressionLaw::kMostParameters>;
  struct Solved {
    double q, slope;  // ln f, and the slope of the equation in it
    const Expression* form;
  };
  struct Sampled {
    ParameterValues parameters;
    std::unique_ptr<const SampledLaw> law;
  };
  Variables variables_of(const LawState& state, std::span<const Taylor> parameters) const;
  std::optional<Solved> solve(const LawState& state, std::span<const Taylor> parameters) const;
  Taylor value(const LawState& state, std::span<const Taylor> parameters);
  double log_value(const LawState& state, std::span<Taylor> parameters, std::span<double> gradient);
  double sampled_log_value(const LawState& state, std::span<const Taylor> parameters, std::span<double> gradient);

  const ExpressionLaw& law_;
  const LawForm& form_;
  std::optional<Expression> text_, logarithm_;
  std::array<Sampled, kSampled> sampled_;
  std::size_t last_sampled_ = 0;
  std::optional<LawTraits> traits_;
};

}  // namespace mixity
