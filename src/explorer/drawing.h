// The models at chosen constants and loads, for a page with sliders. All numbers are in the page's units: loads mN,
// areas mm^2, radii mm, displacements um.
#pragma once

#include <functional>
#include <string>

#include "mechanics/contact_model.h"
#include "report/json.h"

namespace mixity::explorer {

/// A JSON list of get(item), or of the member `get`, for each item.
Json list_of(const auto& items, const auto& get) {
  Json list = Json::array();
  for (const auto& one : items) list.push_back(std::invoke(get, one));
  return list;
}

/// The model with this key. Throws std::invalid_argument if there is none.
ContactModel model_of(const std::string& key);

/// {"radius": m, "modulus": Pa, "toughness": J/m^2, "P": .., "T": .., "T_most": .., "P_most": .., "models":
/// [{"model": "c", "parameters": [0.0023]}]}: of each model {"toughness": [[psi, f]], "curve": {"T", "A", "u",
/// "stable"}, "folds": [{"control", "T", "A", "u", "jumps_to", "area_after"}], "radii": {"stable": [[P, a]],
/// "unstable"}, "state": {"A", "psi", "f"} or null off equilibrium, "regime": text}; only the toughness and "problem"
/// where there is no contact. With "held": true also "held": {"approach": um, "curve": [[T, A, P]], "state": [[T, A,
/// P]] at T, "end": {"at": [T, A, P], "fold"}, if there is one}, where the approach that P causes without shear is held
/// in place of P. Throws std::invalid_argument for constants that are not positive numbers.
Json drawn_models(const Json& request);

}  // namespace mixity::explorer
