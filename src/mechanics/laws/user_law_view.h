// Adapts a law that is defined at run time to the interface of base/law.h.
#pragma once

#include <string_view>
#include <vector>

#include "mechanics/base/law.h"
#include "mechanics/base/parameter_values.h"
#include "mechanics/laws/law_workspace.h"
#include "mechanics/laws/user_law.h"

namespace mixity {

/// Refers to a workspace. Use it on one thread only, while that workspace is leased.
class UserLawView {
 public:
  using Parameters = ParameterValues;
  static constexpr std::size_t kMostParameters = UserLaw::kMostParameters;
  struct LogToughness {
    double value;
    Parameters gradient;
  };

  explicit UserLawView(const LawLease& lease)
      : info(lease.workspace().law().info()),
        parameters(lease.workspace().law().parameters()),
        workspace_(&lease.workspace()) {}

  const ModelInfo& info;
  const std::vector<ParameterInfo>& parameters;

  LogToughness log_toughness(const Parameters& p, const Mixity<double>& mixity) const {
    LogToughness found{0, p};
    found.value = workspace_->log_toughness(mixity, p, found.gradient);
    return found;
  }
  double log_toughness_alone(const Parameters& p, const Mixity<double>& mixity) const {
    return workspace_->log_toughness(mixity, p, {});
  }
  ShearTerm<double> shear_term(const Parameters& p, double y, double T) const;
  double small_shear(const Parameters& p) const { return traits(p).small_shear; }
  double shear_limit(const Parameters& p) const { return traits(p).shear_limit; }
  ShearBend shear_bend(const Parameters& p) const { return traits(p).bend; }
  ShearReach shear_reach(const Parameters& p) const { return traits(p).reach; }
  bool tau_grows_with_edge_load(const Parameters& p) const { return traits(p).tau_grows; }
  bool non_monotone(const Parameters& p) const { return traits(p).non_monotone(); }
  std::string_view equilibrium_domain(const Parameters& p) const { return traits(p).obstacle(); }

 private:
  const LawTraits& traits(const Parameters& p) const { return workspace_->traits(p); }

  LawWorkspace* workspace_;
};

}  // namespace mixity
