#include "report/data_text.h"

#include <algorithm>
#include <iomanip>
#include <map>
#include <sstream>

#include "base/number_text.h"
#include "base/phrases.h"
#include "base/units.h"
#include "dataset/check.h"
#include "fitting/consistency.h"
#include "report/fit_text.h"

namespace mixity {
namespace {

void write_reading(std::ostringstream& out, const Dataset& data) {
  out << data_heading(data) << "\n    "
      << (data.points.empty() && !data.pull_off.empty() ? "pull-off loads (T, P_c), "
          : data.holds_approach()                       ? "raw points (delta, T, A), "
          : data.has_loads                              ? "raw points (P, T, A), "
          : data.has_energies                           ? "energies (G_I, G_II)"
                                                        : "converted points (psi, Gc/GIc)")
      << (data.contact     ? "dimensional"
          : data.has_loads ? "dimensionless"
                           : "")
      << "\n    " << data.rows << " rows, " << usable_rows(data) << " usable, " << data.excluded.size()
      << " excluded\n";
  if (!data.reading.empty()) out << "    read as: " << data.reading << '\n';
  if (!data.taken.empty()) out << joined(data.taken, ", ", "    columns: ") << '\n';
}

void write_curves(std::ostringstream& out, const Dataset& data, bool against_jkr) {
  const auto curves = summarise_curves(data);
  if (curves.empty()) return;
  const DisplayUnits& units = data.display;
  out << "[[Loading runs]]  " << (data.holds_approach() ? bracketed("delta", data.held_unit()) : "P") << ", "
      << bracketed("T", units.force) << ", " << bracketed("A", units.area)
      << (against_jkr ? "; last column: area at the smallest T over JKR's" : "")
      << (data.stated_constants() == Constants{} ? "\n" : "; corrected by the stated offsets and area_scale\n");
  for (const CurveSummary& curve : curves) {
    out << "    " << std::left << std::setw(14) << curve.name << "  " << data.held_name() << " = " << std::setw(10)
        << rounded(curve.P * data.held_scale(), 5) << ' ' << std::setw(4) << curve.points
        << " points  T = " << rounded(curve.T_min * units.force_scale, 4) << " .. " << std::setw(9)
        << rounded(curve.T_max * units.force_scale, 4) << "  A = " << rounded(curve.A_min * units.area_scale, 4)
        << " .. " << std::setw(9) << rounded(curve.A_max * units.area_scale, 4);
    if (against_jkr) out << ' ' << (curve.area_over_jkr ? rounded(*curve.area_over_jkr, 4) : "-");
    out << '\n';
  }
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

std::vector<StatedConstant> stated_constants(const Metadata& metadata) {
  const std::optional<double> modulus = metadata.plane_strain_modulus();
  std::vector<StatedConstant> list;
  const auto add = [&](const char* name, const char* label, const std::optional<double>& value, const char* unit) {
    if (value) list.push_back({name, label, *value, metadata.standard_error(name), unit});
  };
  add("radius", "radius", metadata.radius, "m");
  if (modulus) list.push_back({"modulus", "modulus E*", *modulus, metadata.modulus_error() * *modulus, "Pa"});
  add("toughness", "toughness G_Ic", metadata.toughness, "J/m^2");
  add("toughness_II", "toughness G_IIc", metadata.toughness_II, "J/m^2");
  add("shear_strength", "shear strength", metadata.shear_strength, "Pa");
  add("area_scale", "area_scale", metadata.area_scale, "");
  add("force_gain", "force_gain", metadata.force_gain, "");
  add("load_offset", "load_offset", metadata.load_offset, "N");
  add("shear_offset", "shear_offset", metadata.shear_offset, "N");
  add("area_offset", "area_offset", metadata.area_offset, "m^2");
  add("approach_offset", "approach_offset", metadata.approach_offset, "m");
  add("normal_stiffness", "normal stiffness", metadata.normal_stiffness, "N/m");
  add("modulus_drift", "modulus_drift", metadata.modulus_drift, "");
  add("toughness_drift", "toughness_drift", metadata.toughness_drift, "");
  add("shape", "shape", metadata.shape, "");
  add("hysteresis", "hysteresis", metadata.hysteresis, "");
  return list;
}

std::vector<std::pair<std::string, std::string>> shown_constants(const Dataset& data) {
  const DisplayUnits& units = data.display;
  std::vector<std::pair<std::string, std::string>> list;
  for (const StatedConstant& one : stated_constants(data.metadata)) {
    const std::string_view name = one.name;
    ReadableUnit shown = readable_unit(one.value, one.unit);
    if (name.ends_with("_offset")) {
      if (!data.contact || !data.has_loads) continue;
      shown = name == "approach_offset"
                  ? ReadableUnit{units.approach_scale / data.contact->displacement_unit(), units.approach}
              : name == "area_offset" ? ReadableUnit{units.area_scale / data.contact->area_unit(), units.area}
                                      : ReadableUnit{units.force_scale / data.contact->force_unit(), units.force};
    }
    const double value = one.value * shown.factor, error = one.standard_error * shown.factor;
    list.emplace_back(one.label, (error > 0 ? with_error(value, error) : rounded(value, 6)) + unit_text(shown.unit));
  }
  if (data.holds_approach())
    list.emplace_back("control", data.metadata.normal_stiffness ? "approach" : "approach (rigid machine)");
  if (data.has_loads) list.emplace_back("mode III", mode_III_text(data.metadata));
  return list;
}

std::string data_heading(const Dataset& data) { return "[[Data]]\n    " + data.name + "  (" + data.shown_path() + ")"; }

std::string reconstructed_note(const Dataset& data) {
  return data.metadata.provenance == Provenance::reconstructed ? "    NOTE: " + std::string(kReconstructedNotice) + "\n"
                                                               : std::string();
}

std::string data_notes(const Dataset& data, Wording words) {
  std::string text = reconstructed_note(data);
  for (const Message& note : data.notes) text += "    NOTE: " + note.text(words) + "\n";
  return text;
}

std::size_t usable_rows(const Dataset& data) { return data.points.size() + data.pull_off.size(); }

std::string row_counts(const Dataset& data) {
  return std::to_string(data.rows) + " data rows, " + std::to_string(usable_rows(data)) + " used, " +
         std::to_string(data.excluded.size()) + " excluded" + runs_of_points(data);
}

std::string runs_of_points(const Dataset& data) {
  if (!data.has_loads) return {};
  if (data.pull_off.empty()) return ", in " + counted(data.curves.size(), "loading run");
  return ", " + counted(data.pull_off.size(), "pull-off load") +
         (data.points.empty() ? "" : ", the others in " + counted(data.curves.size(), "loading run"));
}

std::string first_excluded(const Dataset& data, const std::vector<Excluded>& list, std::string_view beginning,
                           const std::string& elsewhere) {
  constexpr std::size_t kShown = 8;
  std::string text;
  for (std::size_t i = 0; i < std::min(kShown, list.size()); ++i)
    text += "    " + std::string(beginning) + data.line_text(list[i].line) + ": " + std::string(list[i].reason) + "\n";
  if (list.size() > kShown) text += "    and " + std::to_string(list.size() - kShown) + " more (" + elsewhere + ")\n";
  return text;
}

std::string excluded_text(const Dataset& data, const std::string& elsewhere) {
  return data.excluded.empty() ? std::string() : "[[Excluded]]\n" + first_excluded(data, data.excluded, "", elsewhere);
}

std::string check_text(const Dataset& data, const std::optional<UnshearedTest>& unsheared, Wording words) {
  std::ostringstream out;
  write_reading(out, data);
  out << "    provenance: " << to_string(data.metadata.provenance) << '\n' << reconstructed_note(data);
  if (!data.metadata.source.empty()) out << "    source: " << data.metadata.source << '\n';
  for (const auto& [name, value] : shown_constants(data))
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
