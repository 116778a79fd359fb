#include "analysis/contact_shape.h"

#include "mechanics/contact_model.h"

namespace mixity {
namespace {

bool states_ellipse(std::string_view name, const std::string& text) { return name == "shape" && means_ellipse(text); }

}  // namespace

bool means_ellipse(const std::string& text) { return text == "ellipse"; }

bool take_ellipse(Overrides& constants) {
  return std::erase_if(constants, [](const auto& one) { return states_ellipse(one.first, one.second); }) > 0;
}

std::string problem_of_constant(std::string_view name, const std::string& text) {
  Metadata scratch;
  return states_ellipse(name, text) ? "" : set_field(scratch, name, text);
}

void take_shape(FitRequest& request) {
  const bool stated = take_ellipse(request.constants);
  for (std::string& key : request.models) {
    const auto model = ContactModel::find(key);
    if (!model) continue;
    const bool pair = model->is_elliptic() && model->parameters()[0].name.ends_with("_II");
    if (stated && !model->is_elliptic()) key += request.equal_couplings ? kEqualEllipse : kEllipse;
    if (pair && request.equal_couplings) key += kEqualEllipse.substr(kEllipse.size());
  }
}

}  // namespace mixity
