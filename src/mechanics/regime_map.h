// What becomes of a contact over normal load and one parameter of a model, as regions with outlines.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "mechanics/contact_model.h"

namespace mixity {

/// "3 jumps"
const char* regime_text(Regime regime);

/// A regime along one line of a map; null: the law defines no unique equilibrium there.
struct RegimeExtent {
  std::optional<Regime> regime;
  double from, to;
};

/// A connected region of one regime: its outline, closed, as (place on the lines, place of the line).
struct RegimeRegion {
  std::optional<Regime> regime;
  std::vector<std::pair<double, double>> outline;
};

/// From lines at these coordinates in ascending order, two at least, each filled by its extents in order.
std::vector<RegimeRegion> connected_regions(const std::vector<double>& places,
                                            const std::vector<std::vector<RegimeExtent>>& lines);

/// What a map spans.
struct RegimeMapFrame {
  std::size_t parameter = 0;  // its number
  double low = 0, high = 1;   // its ends; above 0 if logarithmic
  bool logarithmic = false;
  double P_low = 0, P_high = 1;  // above pull-off
};

/// Found line by line at fixed values of the parameter, more closely where something changes. Along a line the contact
/// jumps at loads below the critical one (ContactModel::critical_load).
class RegimeMap {
 public:
  /// tau0 > 0, or null: without a limit to the strength. Throws std::invalid_argument for another number of parameters
  /// and for ends that do not rise.
  RegimeMap(const ContactModel& model, std::span<const double> parameters, const RegimeMapFrame& frame,
            std::optional<double> tau0 = {});

  /// Adds one line. False if none is missing.
  bool add_line();

  /// Of the lines that there are, two or more. Outlines are (load, value of the parameter). `slivers`: with regions that
  /// exist at one value of the parameter alone, as at lambda = 0, where the modes are not coupled.
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
  std::map<double, Line> lines_{};  // by the part of the parameter's axis
};

}  // namespace mixity
