// The evaluation of a law that is defined at run time (user_law.h).
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>

#include "mechanics/base/parameter_values.h"
#include "mechanics/laws/criterion.h"
#include "mechanics/laws/expression.h"
#include "mechanics/laws/law_traits.h"
#include "mechanics/laws/user_law.h"

namespace mixity {

/// What one thread needs to evaluate a law: compiled expressions, and cached results for recent parameters. A result
/// depends on the arguments alone and is the same in every workspace.
class LawWorkspace {
 public:
  explicit LawWorkspace(const UserLaw& law);

  const UserLaw& law() const { return law_; }

  /// f with its first two derivatives along the direction in which the state changes. NaN where the law is not defined.
  Taylor toughness(const LawState& state, std::span<const double> p);

  /// ln f, and its derivatives in the parameters unless `gradient` is empty, which saves time.
  double log_toughness(const Mixity<double>& mixity, std::span<const double> p, std::span<double> gradient);

  /// The samples of a law that is a function, else null. Valid until the next call of a member.
  const SampledToughness* sampled(std::span<const double> p);

  /// Valid until the next call of a member.
  const LawTraits& traits(std::span<const double> p);

 private:
  static constexpr std::size_t kBefore = 7;    // variables that precede the parameters
  static constexpr std::size_t kSampled = 32;  // cached sets of parameters; a gradient needs four beside each parameter
  using Variables = std::array<Taylor, kBefore + UserLaw::kMostParameters>;
  struct Solved {
    CriterionRoot root;  // in q = ln f
    const Expression* form;
  };
  struct Sampled {
    ParameterValues parameters;
    std::unique_ptr<const SampledToughness> toughness;
  };
  Variables variables_of(const LawState& state, std::span<const double> p) const;
  std::optional<Solved> solve(const LawState& state, std::span<const double> p) const;
  Taylor value(const LawState& state, std::span<const double> p);
  double log_value(const LawState& state, std::span<const double> p, std::span<double> gradient);
  double sampled_log_value(const LawState& state, ParameterValues p, std::span<double> gradient);

  const UserLaw& law_;
  const LawForm& form_;
  std::optional<Expression> text_, logarithm_;
  std::array<Sampled, kSampled> sampled_;
  std::size_t last_sampled_ = 0;
  std::optional<LawTraits> traits_;
};

}  // namespace mixity
