#include "mechanics/laws/typed_law.h"

#include <array>
#include <cmath>
#include <limits>

#include "mechanics/laws/law_workspace.h"

namespace mixity {

TypedLaw::TypedLaw(LawWorkspace& workspace)
    : info(workspace.law().info()), parameters(workspace.law().parameters()), workspace_(&workspace) {}

ShearTerm<double> TypedLaw::shear_term(const Parameters& p, double y, double T) const {
  if (!(T > 0)) return {0, 0, 0};
  if (T < kSmallShear * y) {
    if (const LawTraits& known = workspace_->traits(p); T < known.small_t * y) {
      const double k = known.small_power, t = T / (known.small_t * y);
      const double value = known.small_value * y * y * (k == 2 ? t * t : std::pow(t, k));
      return {value, (2 - k) * value / y, (2 - k) * (1 - k) * value / (y * y)};
    }
  }
  if (y < kLeastCosine * T) {
    const double limit = workspace_->traits(p).shear_limit;
    if (limit < std::numeric_limits<double>::infinity()) return {limit * y * y, 2 * limit * y, 2 * limit};
  }
  std::array<Taylor, kMostParameters> numbers;
  for (std::size_t i = 0; i < p.size(); ++i) numbers[i] = Taylor(p[i]);
  const double squares = y * y + T * T, r = squares > 1e-280 ? std::sqrt(squares) : std::hypot(y, T);
  const ShearTerm<double> reduced = reduced_shear(*workspace_, {numbers.data(), p.size()}, T / r, y / r,
                                                  workspace_->law().form().equation ? &workspace_->traits(p) : nullptr);
  return {r * r * reduced.value, r * reduced.d1, reduced.d2};
}

TypedLaw::LogToughness TypedLaw::log_toughness(const Parameters& p, const Mixity<double>& mixity) const {
  LogToughness found{0, p};
  found.value = workspace_->log_toughness(mixity, p, found.gradient);
  return found;
}

double TypedLaw::log_toughness_alone(const Parameters& p, const Mixity<double>& mixity) const {
  return workspace_->log_toughness(mixity, p, {});
}

ShearBend TypedLaw::shear_bend(const Parameters& p) const { return workspace_->traits(p).bend; }
ShearReach TypedLaw::shear_reach(const Parameters& p) const { return workspace_->traits(p).reach; }
double TypedLaw::shear_limit(const Parameters& p) const { return workspace_->traits(p).shear_limit; }
double TypedLaw::small_shear(const Parameters& p) const { return workspace_->traits(p).small_shear; }
bool TypedLaw::tau_grows_with_edge_load(const Parameters& p) const { return workspace_->traits(p).tau_grows; }
bool TypedLaw::non_monotone(const Parameters& p) const { return workspace_->traits(p).non_monotone(); }
std::string_view TypedLaw::equilibrium_domain(const Parameters& p) const { return workspace_->traits(p).obstacle(); }

}  // namespace mixity
