#include "analysis/contact_shape.h"

#include <algorithm>

#include "mechanics/contact_model.h"

namespace mixity {

bool means_ellipse(const std::string& text) { return text == "ellipse"; }

void take_shape(FitRequest& request) {
  const auto says_so = [](const auto& one) { return one.first == "shape" && means_ellipse(one.second); };
  const bool stated = std::erase_if(request.constants, says_so) > 0;
  for (std::string& key : request.models) {
    const auto model = ContactModel::find(key);
    if (!model) continue;
    const bool pair = model->is_elliptic() && model->parameters()[0].name.ends_with("_II");
    if (stated && !model->is_elliptic()) key += request.equal_couplings ? kEqualEllipse : kEllipse;
    if (pair && request.equal_couplings) key += kEqualEllipse.substr(kEllipse.size());
  }
}

}  // namespace mixity
