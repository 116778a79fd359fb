// Regimes over normal load and one parameter of a model, as regions with outlines.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "mechanics/contact_model.h"

namespace mixity {

/// Such as "shrinks to Hertz".
const char* regime_text(Regime regime);

/// The extent of a regime along one line of a map; null where the law defines no unique equilibrium.
struct RegimeExtent {
  std::optional<Regime> regime;
  double from, to;
};

/// A connected region of one regime. Points of the closed outline: (coordinate along a line, coordinate of the line).
struct RegimeRegion {
  std::optional<Regime> regime;
  std::vector<std::pair<double, double>> outline;
};

/// Joins two or more lines at these ascending coordinates. Each line is filled by its extents in order.
std::vector<RegimeRegion> connected_regions(const std::vector<double>& coordinates,
                                            const std::vector<std::vector<RegimeExtent>>& lines);

/// The axes of a map.
struct RegimeMapFrame {
  std::size_t parameter = 0;  // index of the parameter
  double low = 0, high = 1;   // its range; above 0 if logarithmic
  bool logarithmic = false;
  double P_low = 0, P_high = 1;  // above pull-off
};

/// A map, computed line by line at fixed values of the parameter, with more lines where regimes change. Along a line
/// the contact jumps at loads below the critical one (ContactModel::critical_load).
class RegimeMap {
 public:
  /// tau0 > 0, or null for unlimited strength. Throws std::invalid_argument for a wrong number of parameters and for
  /// empty ranges.
  RegimeMap(const ContactModel& model, std::span<const double> parameters, const RegimeMapFrame& frame,
            std::optional<double> tau0 = {});

  /// Adds one line. Returns false if the map is complete.
  bool add_line();

  /// The regions between the lines so far, at least two. Outlines are (load, value of the parameter). `slivers`:
  /// include regions at a single value of the parameter, such as lambda = 0, where the modes are not coupled.
  std::vector<RegimeRegion> regions(bool slivers = true) const;

 private:
  using Line = std::vector<RegimeExtent>;
  Line line(double part) const;
  Line with_strength(std::span<const double> p, const Line& fracture) const;
  bool slides_first(std::span<const double> p, double P) const;
  bool differ(const Line& one, const Line& other) const;
  std::optional<double> missing() const;
  double value_at(double part) const;

  ContactModel model_;
  std::vector<double> parameters_;
  RegimeMapFrame frame_;
  std::optional<double> tau0_;
  std::map<double, Line> lines_{};  // key: position on the parameter's axis, 0..1
};

}  // namespace mixity
