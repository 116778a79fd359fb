#include "report/instability_text.h"

#include <nlohmann/json.hpp>
#include <sstream>

#include "report/rounding.h"

namespace mixity {

std::string to_text(const InstabilityReport& report) {
  std::ostringstream out;
  out << "[[Instabilities]] model " << report.model;
  for (const auto& [name, value] : report.parameters) out << ", " << name << " = " << shortest(value);
  out << ", P = " << shortest(report.load) << " (dimensionless)\n";
  if (report.folds.empty())
    out << "    none: A falls steadily as T or u grows\n";
  else
    out << "    control        met on      T             u             A             psi [rad]   jumps to       area "
           "lost\n";
  for (const Fold& fold : report.folds) {
    std::string control(to_string(fold.control.kind));
    if (fold.control.kind == Control::Kind::stiffness) control += " " + rounded(fold.control.stiffness, 4);
    out << "    " << padded(control, 15) << padded(fold.place.maximum ? "loading" : "reversal", 12)
        << padded(rounded(fold.T, 8), 14) << padded(rounded(fold.u, 8), 14) << padded(rounded(fold.A, 8), 14)
        << padded(rounded(fold.psi, 7), 12) << padded(std::string(to_string(fold.jumps_to)), 15)
        << rounded(fold.area_lost, 8) << '\n';
  }
  return out.str();
}

std::string to_json(const InstabilityReport& report) {
  nlohmann::ordered_json document = {{"model", report.model}};
  for (const auto& [name, value] : report.parameters) document[name] = value;
  document["load"] = report.load;
  nlohmann::ordered_json folds = nlohmann::ordered_json::array();
  for (const Fold& fold : report.folds) {
    nlohmann::ordered_json entry = {{"control", to_string(fold.control.kind)}};
    if (fold.control.kind == Control::Kind::stiffness) entry["stiffness"] = fold.control.stiffness;
    entry["met_on"] = fold.place.maximum ? "loading" : "reversal";
    entry["T"] = fold.T;
    entry["u"] = fold.u;
    entry["A"] = fold.A;
    entry["psi"] = fold.psi;
    entry["jumps_to"] = to_string(fold.jumps_to);
    entry["area_lost"] = fold.area_lost;
    folds.push_back(entry);
  }
  document["folds"] = folds;
  return document.dump(2) + "\n";
}

}  // namespace mixity
