// A mode-mixity law defined at run time: f(psi) = G_c/G_Ic as an expression with named, bounded parameters, a fracture
// criterion (an equation whose solution is G), or a function of arrays, which is sampled.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mechanics/laws/sampled_law.h"
#include "mechanics/model.h"
#include "mechanics/parameter_values.h"

namespace mixity {

struct LawParameter {
  std::string name;     // lambda, n, r_II, ...
  double lower, upper;  // closed range, finite
  double start;         // in it
};

struct LawDefinition {
  std::string key;   // what --models takes: letters, digits and underscores, none of the published models'
  std::string text;  // of psi, B = sin^2 psi, t = tan psi, K_I and K_II in units of the toughness; with a = an equation
  std::vector<LawParameter> parameters{};       // 1 to ExpressionLaw::kMostParameters
  std::string name{};                           // shown beside the key; empty: the key
  bool normalised = false;                      // f is the expression over its value at psi = 0
  std::shared_ptr<const LawSampler> sampler{};  // f is this, and `text` is only shown; equal if it is the same object
};

/// Whether two definitions agree in all but the name, which is only shown.
bool same_law(const LawDefinition& one, const LawDefinition& other);

/// Why a definition is invalid, and where in `text` if the error is there, counted from 0.
struct LawError {
  std::optional<std::size_t> at;
  std::string message;
};

/// A definition as it is evaluated.
struct LawForm {
  bool equation = false;    // in K_I and K_II
  std::string text{};       // f, or of an equation what vanishes; empty if the law is a function
  std::string logarithm{};  // of an equation: log(left/right) where that is defined, else empty
  std::vector<std::string> variables{};
  bool uses_psi = true, uses_B = true, uses_t = true;
};

class LawWorkspace;

/// Immutable, shared by every thread that uses it. Evaluation takes place in workspaces (law_workspace.h), each of
/// which one thread holds at a time (LawLease). The law keeps those that are idle; they go with it.
class ExpressionLaw {
 public:
  static constexpr std::size_t kMostParameters = 3;

  /// Null, and the reason in `error`, for what cannot be evaluated. Does not check that f makes sense: law_check.h.
  static std::shared_ptr<const ExpressionLaw> make(LawDefinition definition, LawError& error);
  ~ExpressionLaw();

  const LawDefinition& definition() const { return definition_; }
  const LawForm& form() const { return form_; }
  const std::string& shown() const { return shown_; }  // "f = 1 + p*t^2"
  const ModelInfo& info() const { return info_; }
  const std::vector<ParameterInfo>& parameters() const { return parameters_; }

  /// f at the phase angle psi [rad]; NaN where the law is not defined.
  double toughness(double psi, std::span<const double> parameters) const;

 private:
  friend class LawLease;
  ExpressionLaw(LawDefinition definition, LawForm form);

  LawDefinition definition_;
  std::string shown_;
  LawForm form_;
  ModelInfo info_;
  std::vector<ParameterInfo> parameters_;
  mutable std::mutex one_at_a_time_;
  mutable std::vector<std::unique_ptr<LawWorkspace>> idle_;
};

/// The use of a law on one thread: holds a workspace of it, and the law itself unless that is given by reference.
class LawLease {
 public:
  explicit LawLease(std::shared_ptr<const ExpressionLaw> law);
  explicit LawLease(const ExpressionLaw& law);
  LawLease(const LawLease&) = delete;
  LawLease& operator=(const LawLease&) = delete;
  ~LawLease();

  LawWorkspace& workspace() const { return *workspace_; }

 private:
  std::shared_ptr<const ExpressionLaw> law_;
  std::unique_ptr<LawWorkspace> workspace_;
};

}  // namespace mixity
