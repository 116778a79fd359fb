#include "report/instability_text.h"

#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

#include "dataset/number_text.h"

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
    out << "    " << std::left << std::setw(15) << control << std::setw(12)
        << (fold.place.maximum ? "loading" : "reversal") << std::setw(14) << rounded(fold.T, 8) << std::setw(14)
        << rounded(fold.u, 8) << std::setw(14) << rounded(fold.A, 8) << std::setw(12) << rounded(fold.psi, 7)
        << std::setw(15) << to_string(fold.jumps_to) << rounded(fold.area_lost, 8) << '\n';
  }
  return out.str();
}

std::string to_json(const InstabilityReport& report) {
  using Json = nlohmann::ordered_json;
  Json document = {{"model", report.model}};
  for (const auto& [name, value] : report.parameters) document[name] = value;
  document["load"] = report.load;
  Json folds = Json::array();
  for (const Fold& fold : report.folds) {
    Json entry = {{"control", to_string(fold.control.kind)}};
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
