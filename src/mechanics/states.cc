#include "mechanics/states.h"

namespace mixity {

std::string_view to_string(EquilibriumStatus status) {
  switch (status) {
    case EquilibriumStatus::ok:
      return "ok";
    case EquilibriumStatus::no_equilibrium:
      return "no_equilibrium";
    case EquilibriumStatus::invalid:
      break;
  }
  return "invalid";
}

std::string_view to_string(Control::Kind kind) {
  switch (kind) {
    case Control::Kind::load:
      return "load";
    case Control::Kind::displacement:
      return "displacement";
    case Control::Kind::stiffness:
      break;
  }
  return "stiffness";
}

std::string_view to_string(Jump jump) {
  switch (jump) {
    case Jump::hertz:
      return "hertz";
    case Jump::lower_branch:
      return "lower_branch";
    case Jump::upper_branch:
      return "upper_branch";
    case Jump::off_contact:
      break;
  }
  return "off_contact";
}

}  // namespace mixity
