// What becomes of a contact over load and one parameter of a model, as a page draws it.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mechanics/contact_model.h"
#include "mechanics/regime_map.h"

namespace mixity::explorer {

using Json = nlohmann::ordered_json;

/// Of {"model", "parameters": [value], "axis": number of the parameter, "low", "high": its ends, "logarithmic",
/// "P_low", "P_high"}, loads dimensionless (R G_Ic). Found line by line at fixed values of the parameter, more closely
/// where something changes, so that a page can do other things in between.
class RegimeMap {
 public:
  /// Throws std::invalid_argument for what is no map.
  explicit RegimeMap(const Json& request);

  /// Goes on for so long, by a line at least. Whether all is known then.
  bool go_on(double milliseconds);

  /// [{"regime": text, "outline": [[P, parameter]]}]
  Json regions() const;

 private:
  using Line = std::vector<RegimeExtent>;
  Line line(double part) const;
  double value_at(double part) const;
  bool differ(const Line& one, const Line& other) const;
  bool next(double& part) const;

  ContactModel model_;
  std::vector<double> parameters_;
  std::size_t axis_;
  double low_, high_, P_low_, P_high_;
  bool logarithmic_;
  std::map<double, Line> lines_{};  // by the part of the axis
};

}  // namespace mixity::explorer
