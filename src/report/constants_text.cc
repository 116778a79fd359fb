#include "report/constants_text.h"

#include "base/number_text.h"
#include "base/units.h"

namespace mixity {
namespace {

/// In SI, or in a unit that the file has.
std::string with_error(double value, double error, const std::string& unit, bool readable) {
  const ReadableUnit shown = readable ? readable_unit(value, unit) : ReadableUnit{1, unit};
  if (!(error > 0)) return rounded(value * shown.factor, 6) + unit_text(shown.unit);
  const RoundedToError both = rounded_to_error(value * shown.factor, error * shown.factor);
  return both.value + " +/- " + both.error + unit_text(shown.unit);
}

}  // namespace

std::vector<std::pair<std::string, std::string>> stated_constants_text(const Dataset& data) {
  const Metadata& metadata = data.metadata;
  std::vector<std::pair<std::string, std::string>> list;
  const auto add = [&](std::string name, const std::optional<double>& value, double error, const std::string& unit,
                       double in_unit = 0) {
    if (!value) return;
    const double factor = in_unit > 0 ? in_unit : 1;
    list.emplace_back(std::move(name), with_error(*value * factor, error * factor, unit, in_unit == 0));
  };
  const auto modulus = metadata.plane_strain_modulus();
  add("radius", metadata.radius, metadata.standard_error("radius"), "m");
  add("modulus E*", modulus, modulus ? metadata.modulus_error() * *modulus : 0, "Pa");
  add("toughness G_Ic", metadata.toughness, metadata.standard_error("toughness"), "J/m^2");
  add("toughness G_IIc", metadata.toughness_II, metadata.standard_error("toughness_II"), "J/m^2");
  add("shear strength", metadata.shear_strength, metadata.standard_error("shear_strength"), "Pa");
  add("area_scale", metadata.area_scale, metadata.standard_error("area_scale"), "");
  if (!data.contact || !data.has_loads) return list;
  const double force = data.display.force_scale / data.contact->force_unit();  // from SI to the file's units
  const double area = data.display.area_scale / data.contact->area_unit();
  add("load_offset", metadata.load_offset, metadata.standard_error("load_offset"), data.display.force, force);
  add("shear_offset", metadata.shear_offset, metadata.standard_error("shear_offset"), data.display.force, force);
  add("area_offset", metadata.area_offset, metadata.standard_error("area_offset"), data.display.area, area);
  return list;
}

}  // namespace mixity
