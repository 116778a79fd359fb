// A law that is defined at run time: f(psi) = G_c/G_Ic as an expression with named, bounded parameters, a fracture
// criterion (an equation whose solution is G_c), or a function of arrays, which is sampled.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mechanics/base/law.h"
#include "mechanics/laws/expression.h"
#include "mechanics/laws/sampled_toughness.h"

namespace mixity {

struct LawParameter {
  std::string name;     // lambda, n, r_II, ...
  double lower, upper;  // closed range, finite
  double start;         // within the range
};

struct LawDefinition {
  std::string key;  // what --models takes: letters, digits and underscores; not the key of a published model
  std::string
      text;  // in psi, B = sin^2 psi, t = tan psi, or K_I and K_II in units of the toughness; with a =, an equation
  std::vector<LawParameter> parameters{};       // 1 to UserLaw::kMostParameters
  std::string name{};                           // shown beside the key; empty: the key
  bool normalised = false;                      // f is the expression divided by its value at psi = 0
  std::shared_ptr<const LawSampler> sampler{};  // computes f; `text` is then only shown. Compared by identity
};

/// Whether two definitions agree in everything but the name.
bool same_law(const LawDefinition& one, const LawDefinition& other);

/// A definition in the form in which it is evaluated.
struct LawForm {
  bool equation = false;    // in K_I and K_II
  std::string text{};       // f, or left minus right of an equation; empty for a function
  std::string logarithm{};  // log(left/right) of an equation if it can be parsed, else empty
  std::vector<std::string> variables{};
  bool uses_psi = true, uses_B = true, uses_t = true;
};

class LawWorkspace;

/// A parsed definition. Immutable and shared by threads. Each thread evaluates it in a workspace (law_workspace.h),
/// which LawLease borrows. The law owns the idle workspaces.
class UserLaw {
 public:
  static constexpr std::size_t kMostParameters = 3;

  /// Null, with the reason in `error`, if the definition cannot be evaluated. The values of f are not checked here but
  /// in law_check.h.
  static std::shared_ptr<const UserLaw> make(LawDefinition definition, LawError& error);
  ~UserLaw();

  const LawDefinition& definition() const { return definition_; }
  const LawForm& form() const { return form_; }
  const std::string& shown() const { return shown_; }  // "f = 1 + p*t^2"
  const ModelInfo& info() const { return info_; }
  const std::vector<ParameterInfo>& parameters() const { return parameters_; }

  /// f at the phase angle psi [rad]; NaN where the law is not defined.
  double toughness(double psi, std::span<const double> parameters) const;

 private:
  friend class LawLease;
  UserLaw(LawDefinition definition, LawForm form);

  LawDefinition definition_;
  std::string shown_;
  LawForm form_;
  ModelInfo info_;
  std::vector<ParameterInfo> parameters_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<LawWorkspace>> idle_;
};

/// Borrows a workspace for one thread. The law must outlive the lease.
class LawLease {
 public:
  explicit LawLease(const UserLaw& law);
  LawLease(const LawLease&) = delete;
  LawLease& operator=(const LawLease&) = delete;
  ~LawLease();

  LawWorkspace& workspace() const { return *workspace_; }

 private:
  const UserLaw& law_;
  std::unique_ptr<LawWorkspace> workspace_;
};

}  // namespace mixity
