#include <algorithm>

#include "mechanics/any_law.h"
#include "mechanics/contact_model.h"
#include "mechanics/pull_off.h"

namespace mixity {

void ContactModel::pull_off(ParameterSpan p, HeldShear held, std::span<const double> shear, std::span<PullOff> out,
                            std::span<double> gradient) const {
  std::fill(out.begin(), out.end(), PullOff{});
  std::fill(gradient.begin(), gradient.end(), std::numeric_limits<double>::quiet_NaN());
  if (law_->ellipse || p.size() != parameters().size() || !obstacle(p).empty()) return;
  with_law(*law_, p, [&](const auto& law, const auto& values) {
    const PullOffSearch search(law, values, held);
    for (std::size_t i = 0; i < shear.size(); ++i) {
      if (!(shear[i] >= 0 && shear[i] <= kMostPullOffShear)) continue;
      out[i] = search.at(shear[i]);
      if (gradient.empty()) continue;
      const auto slopes = search.gradient(out[i]);
      std::copy_n(slopes.begin(), p.size(), gradient.begin() + static_cast<std::ptrdiff_t>(i * p.size()));
    }
  });
}

bool ContactModel::pull_off_distances(ParameterSpan p, const PullOffPoints& points, const PullOffDistances& out) const {
  if (law_->ellipse || p.size() != parameters().size() || !obstacle(p).empty()) return false;
  return with_law(*law_, p, [&](const auto& law, const auto& values) {
    return mixity::pull_off_distances(law, values, points, out);
  });
}

}  // namespace mixity
