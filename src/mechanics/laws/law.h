// A mode-mixity law of somebody's own: f(psi) = G_c/G_Ic as an expression with named, bounded parameters, a criterion
// of fracture, an equation that G is the solution of, or a function of arrays that is sampled.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mechanics/laws/expression.h"
#include "mechanics/laws/sampled_law.h"
#include "mechanics/model.h"

namespace mixity {

struct LawParameter {
  std::string name;     // lambda, n, r_II, ...
  double lower, upper;  // closed range, finite
  double start;         // in it
};

struct LawDefinition {
  std::string key;   // what --models takes: letters, digits and underscores, none of the published models'
  std::string text;  // of psi, B = sin^2 psi, t = tan psi, K_I and K_II in units of the toughness; with a = an equation
  std::vector<LawParameter> parameters{};       // 1 to kMostParameters
  std::string name{};                           // shown beside the key; empty: the key
  bool normalised = false;                      // f is the expression over its value at psi = 0
  std::shared_ptr<const LawSampler> sampler{};  // f is this, and `text` only what is shown of it; the same one is equal
};

/// Why a definition is none: where in `text` if it is there, counted from 0.
struct LawError {
  std::optional<std::size_t> at;
  std::string message;
};

/// Not to change once made. Its numbers are the same on every thread.
class ExpressionLaw {
 public:
  static constexpr std::size_t kMostParameters = 3;

  /// Null and why, for what cannot be evaluated. Nothing is said here of whether it makes sense: law_checks.h.
  static std::shared_ptr<const ExpressionLaw> make(LawDefinition definition, LawError& error);

  const LawDefinition& definition() const { return definition_; }
  const std::string& shown() const { return shown_; }  // "f = 1 + p*t^2"
  bool is_equation() const { return equation_; }
  bool uses_psi() const { return uses_psi_; }  // else State::psi need not be set

  /// f with its first two derivatives along the direction in which the state and the parameters change, of a function
  /// that is sampled the state alone. NaN where the law is not defined.
  struct State {
    Taylor psi, sin, cos;
    std::optional<Taylor> about{};  // ln f along the direction, about: an equation is solved from there
  };
  Taylor toughness(const State& state, std::span<const Taylor> parameters) const;

  /// ln f, with its derivatives in the parameters, or without where `gradient` is empty: that costs less.
  double log_toughness(const Mixity<double>& mixity, std::span<const double> parameters,
                       std::span<double> gradient) const;

  /// At the phase angle psi [rad].
  double toughness(double psi, std::span<const double> parameters) const;

  /// Null unless the law is a function. Some that were asked for last are kept on each thread.
  const SampledLaw* sampled(std::span<const double> parameters) const;

 private:
  ExpressionLaw() = default;
  static constexpr std::size_t kBefore = 7;  // variables before the parameters
  using Variables = std::array<Taylor, kBefore + kMostParameters>;
  struct Solved {
    double q, slope;  // ln f, and the equation's slope in it there
    const Expression* form;
  };
  Variables variables_of(const State& state, std::span<const Taylor> parameters) const;
  std::optional<Solved> solve(const State& state, std::span<const Taylor> parameters) const;
  Taylor value(const State& state, std::span<const Taylor> parameters) const;
  double log_value(const State& state, std::span<Taylor> parameters, std::span<double> gradient) const;
  double sampled_log_value(const State& state, std::span<const Taylor> parameters, std::span<double> gradient) const;
  const Expression& compiled(const std::string& text, std::size_t number) const;  // of this thread

  LawDefinition definition_;
  std::string shown_, text_;  // text_: what is evaluated, or of an equation what vanishes
  std::string logarithm_;     // of left over right where that is a number, else empty
  std::vector<std::string> variables_;
  bool equation_ = false, uses_psi_ = true, uses_B_ = true, uses_t_ = true;
  std::size_t number_ = 0;
};

/// What the general route of mechanics asks of a law (model.h), for the one whose key with_model was called with.
namespace typed {
ShearTerm<double> shear_term(std::span<const double> p, double y, double T);
double log_toughness(std::span<const double> p, const Mixity<double>& mixity, std::span<double> gradient);  // or {}
double small_shear(std::span<const double> p);
double shear_limit(std::span<const double> p);
ShearBend shear_bend(std::span<const double> p);
ShearReach shear_reach(std::span<const double> p);
bool tau_grows_with_edge_load(std::span<const double> p);
bool turns(std::span<const double> p);
std::string_view equilibrium_domain(std::span<const double> p);
}  // namespace typed

/// The laws that a process knows. Adds one, or finds the same that is there; an error for another one of that key.
std::shared_ptr<const ExpressionLaw> define_law(const LawDefinition& definition, LawError& error);
std::shared_ptr<const ExpressionLaw> add_law(const std::shared_ptr<const ExpressionLaw>& made, LawError& error);
/// In all but the name, which is only shown.
bool same_law(const LawDefinition& one, const LawDefinition& other);
std::shared_ptr<const ExpressionLaw> find_law(std::string_view key);
std::vector<std::string> law_keys();  // in the order in which they were defined
void forget_laws();                   // their keys are free; what holds one of them keeps it

/// The law that typed:: speaks of on this thread; null where none is.
const ExpressionLaw*& current_law();

}  // namespace mixity
