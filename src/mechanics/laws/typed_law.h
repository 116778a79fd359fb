// A law that was defined at run time, as mechanics uses laws (model.h): tau^2 = y^2 ((1 + tan^2 psi)/f - 1), and what
// follows from f.
#pragma once

#include <string_view>
#include <vector>

#include "mechanics/laws/law.h"
#include "mechanics/model.h"
#include "mechanics/parameter_values.h"

namespace mixity {

/// Refers to a workspace: to be used on one thread, as long as that workspace is leased.
class TypedLaw {
 public:
  using Parameters = ParameterValues;
  static constexpr std::size_t kMostParameters = ExpressionLaw::kMostParameters;
  struct LogToughness {
    double value;
    Parameters gradient;
  };

  explicit TypedLaw(LawWorkspace& workspace);
  explicit TypedLaw(const LawLease& lease) : TypedLaw(lease.workspace()) {}

  const ModelInfo& info;
  const std::vector<ParameterInfo>& parameters;

  LogToughness log_toughness(const Parameters& p, const Mixity<double>& mixity) const;
  double log_toughness_alone(const Parameters& p, const Mixity<double>& mixity) const;
  ShearTerm<double> shear_term(const Parameters& p, double y, double T) const;
  double small_shear(const Parameters& p) const;
  double shear_limit(const Parameters& p) const;
  ShearBend shear_bend(const Parameters& p) const;
  ShearReach shear_reach(const Parameters& p) const;
  bool tau_grows_with_edge_load(const Parameters& p) const;
  bool non_monotone(const Parameters& p) const;
  std::string_view equilibrium_domain(const Parameters& p) const;

 private:
  LawWorkspace* workspace_;
};

}  // namespace mixity
