#include "report/check_text.h"

#include <iomanip>
#include <map>
#include <sstream>

#include "base/number_text.h"
#include "dataset/check.h"
#include "fitting/consistency.h"
#include "report/budget_text.h"
#include "report/constants_text.h"

namespace mixity {
namespace {

void write_curves(std::ostringstream& out, const Dataset& data, bool against_jkr) {
  const auto curves = summarise_curves(data);
  if (curves.empty()) return;
  const DisplayUnits& units = data.display;
  const auto unit = [](const std::string& text) { return text.empty() ? "" : " [" + text + "]"; };
  out << "[[Loading runs]]  P, T" << unit(units.force) << ", A" << unit(units.area)
      << (against_jkr ? "; last column: area at the smallest T over JKR's\n" : "\n");
  for (const CurveSummary& curve : curves) {
    out << "    " << std::left << std::setw(14) << curve.name << "  P = " << std::setw(10)
        << rounded(curve.P * units.force_scale, 5) << ' ' << std::setw(4) << curve.points
        << " points  T = " << rounded(curve.T_min * units.force_scale, 4) << " .. " << std::setw(9)
        << rounded(curve.T_max * units.force_scale, 4) << "  A = " << rounded(curve.A_min * units.area_scale, 4)
        << " .. " << std::setw(9) << rounded(curve.A_max * units.area_scale, 4);
    if (against_jkr) out << ' ' << (curve.area_over_jkr ? rounded(*curve.area_over_jkr, 4) : "-");
    out << '\n';
  }
}

void write_reading(std::ostringstream& out, const Dataset& data) {
  out << "[[Data]]\n    " << data.name << "  (" << data.shown_path() << ")\n    "
      << (data.has_loads      ? "raw points (P, T, A), "
          : data.has_energies ? "energies (G_I, G_II)"
                              : "converted points (psi, Gc/GIc)")
      << (data.contact     ? "dimensional"
          : data.has_loads ? "dimensionless"
                           : "")
      << "\n    " << data.rows << " rows, " << data.points.size() << " usable, " << data.excluded.size()
      << " excluded\n";
  if (!data.reading.empty()) out << "    read as: " << data.reading << '\n';
  for (std::size_t i = 0; i < data.taken.size(); ++i) out << (i == 0 ? "    columns: " : ", ") << data.taken[i];
  if (!data.taken.empty()) out << '\n';
}

void write_excluded(std::ostringstream& out, const Dataset& data) {
  constexpr std::size_t kShown = 10;  // of each reason
  if (!data.excluded.empty()) out << "[[Excluded]]\n";
  std::map<std::string_view, std::size_t> counts;
  for (const Excluded& excluded : data.excluded)
    if (++counts[excluded.reason] <= kShown)
      out << "    " << data.line_text(excluded.line) << ": " << excluded.reason << '\n';
  for (const auto& [reason, count] : counts)
    if (count > kShown) out << "    and " << count - kShown << " more: " << reason << '\n';
}

}  // namespace

std::string check_text(const Dataset& data, const std::optional<UnshearedTest>& unsheared, Wording words) {
  std::ostringstream out;
  write_reading(out, data);
  out << "    provenance: " << to_string(data.metadata.provenance) << '\n';
  if (data.metadata.provenance == Provenance::reconstructed) out << "    NOTE: " << kReconstructedNotice << '\n';
  if (!data.metadata.source.empty()) out << "    source: " << data.metadata.source << '\n';
  for (const auto& [name, value] : stated_constants_text(data))
    out << "    " << std::left << std::setw(16) << name << value << '\n';
  write_curves(out, data, true);
  write_excluded(out, data);
  auto oddities = find_oddities(data, words);
  if (unsheared && !data.points.empty()) {
    out << "[[Areas without shear]]\n    " << unsheared_sentence(*unsheared) << '\n';
    if (unsheared->p_value < kChance)
      oddities.push_back("the areas without shear do not agree with JKR and the constants as stated");
  }
  out << "[[Odd]]\n";
  if (oddities.empty()) out << "    nothing\n";
  for (const std::string& oddity : oddities) out << "    " << oddity << '\n';
  return out.str();
}

std::string reading_text(const Dataset& data) {
  std::ostringstream out;
  write_reading(out, data);
  write_curves(out, data, false);
  write_excluded(out, data);
  return out.str();
}

}  // namespace mixity
