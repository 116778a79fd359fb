#include "fitting/stated_constants.h"

#include "fitting/options.h"

namespace mixity {
namespace {

/// Whether toughness ratios refer to a toughness stated in J/m^2.
bool states_toughness(const Dataset& data) {
  return !data.has_loads && !data.has_energies && data.metadata.toughness.has_value();
}

/// The standard error in the solver's numbers.
double stated_error(const Dataset& data, Constant constant) {
  const Metadata& metadata = data.metadata;
  const double error = metadata.standard_error(kConstantNames[constant]);
  switch (constant) {
    case kToughness:
      return metadata.toughness ? error / *metadata.toughness : 0;
    case kModulus:
      return metadata.modulus_error();
    case kRadius:
      return metadata.radius ? error / *metadata.radius : 0;
    case kAreaScale:
      return metadata.area_scale ? error / *metadata.area_scale : 0;
    case kForceGain:
      return metadata.force_gain ? error / *metadata.force_gain : 0;
    case kModulusDrift:
    case kToughnessDrift:
    case kShape:
    case kHysteresis:
      return error;
    default:
      return data.offset_unit(constant) > 0 ? error / data.offset_unit(constant) : 0;
  }
}

}  // namespace

Constants constants_of(const Dataset& data, const FitOptions& options) {
  return options.constants.value_or(data.stated_constants());
}

ConstantUnit unit_of(const Dataset& data, Constant c) {
  const auto& contact = data.contact;
  switch (c) {
    case kToughness:
      if (contact) return {contact->toughness, "J/m^2"};
      return states_toughness(data) ? ConstantUnit{*data.metadata.toughness, "J/m^2"} : ConstantUnit{};
    case kModulus:
      return contact ? ConstantUnit{contact->modulus, "Pa"} : ConstantUnit{};
    case kRadius:
      return contact ? ConstantUnit{contact->radius, "m"} : ConstantUnit{};
    case kAreaScale:
    case kForceGain:
    case kModulusDrift:
    case kToughnessDrift:
    case kShape:
    case kHysteresis:
      return {};
    case kLoadOffset:
    case kShearOffset:
      return {data.display.force_scale, contact ? data.display.force : ""};
    case kApproachOffset:
      return {data.display.approach_scale, contact ? data.display.approach : ""};
    case kAreaOffset:
      break;
  }
  return {data.display.area_scale, contact ? data.display.area : ""};
}

ConstantUnit shown_deviation(const Dataset& data, std::string_view quantity) {
  const auto constant = constant_named(quantity);
  return constant && !is_factor(*constant) ? unit_of(data, *constant) : ConstantUnit{};
}

std::vector<FittedConstant> uncertain_constants(const Dataset& data) {
  std::vector<FittedConstant> list;
  const Constants stated = data.stated_constants();
  for (const Constant constant : kAllConstants) {
    const bool needed = data.has_loads ? constant == kAreaScale || constant == kForceGain || is_change(constant) ||
                                             data.contact.has_value()
                                       : constant == kToughness;
    if (constant == kApproachOffset && !data.holds_approach()) continue;
    if (constant == kLoadOffset && data.holds_approach() && data.loads_beside.empty()) continue;
    const double error = needed ? stated_error(data, constant) : 0;
    if (error > 0) list.push_back({constant, stated[constant], error});
  }
  return list;
}

}  // namespace mixity
