#include "dataset/energies.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/input_error.h"
#include "base/number_text.h"
#include "dataset/exclusion.h"
#include "mechanics/base/law.h"
#include "mechanics/contact.h"

namespace mixity {
namespace {

bool usable(double error) { return error == kNotStated || error == 0 || in_range(error); }

/// False if a result is out of range.
bool divide(double unit, PointEnergies& energies, ToughnessPoint& converted) {
  for (double* error : {&energies.sigma_GI, &energies.sigma_GII})
    if (*error != kNotStated) *error /= unit;
  energies.G_I /= unit;
  energies.G_II /= unit;
  return std::abs(energies.G_I) <= kMostQuantity && std::abs(energies.G_II) <= kMostQuantity &&
         usable(energies.sigma_GI) && usable(energies.sigma_GII) && convert(energies, converted).empty();
}

void take_largest_as_unit(const std::string& metadata_path, Dataset& data) {
  double largest = 0;
  for (const PointEnergies& energies : data.energies) largest = std::max(largest, energies.G_I);
  if (!in_range(largest) || !in_range(largest * data.display.energy_scale))
    throw InputError(data.path, "the constant toughness is missing, and no G_I above 0 can stand for it" +
                                    Remedy::state({"toughness"}, metadata_path));
  data.display.energy_scale *= largest;
  std::vector<std::string_view> reasons(data.points.size());
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    if (!divide(largest, data.energies[i], data.converted[i])) reasons[i] = kOutOfRangeRatio;
    if (!data.errors.empty()) data.errors[i].ratio = error_of_sum(data.energies[i]);
  }
  exclude_points(reasons, data);
  data.notes.push_back("toughness is not stated and has to be fitted (" + Remedy::set("free", "toughness") +
                       "); where it is not, the largest G_I, " + rounded(data.display.energy_scale, 4) + " " +
                       data.display.energy + ", stands for it");
}

}  // namespace

std::string_view convert(const PointEnergies& energies, ToughnessPoint& point) {
  const double sum = energies.G_I + energies.G_II;
  if (!(sum > 0)) return "G_I + G_II <= 0";
  if (!in_range(sum)) return kOutOfRangeRatio;
  point = {mixity_from_energies(energies.G_I, energies.G_II), sum};
  return {};
}

bool series_have_toughness(const Dataset& data) {
  constexpr double kApart = 0.05;  // in G_II/Gc; noise moves a nominal share by less
  std::vector<std::pair<double, double>> shares(data.curves.size(), {1, 0});  // the least and the largest
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    auto& [least, largest] = shares[data.points[i].curve];
    const double share = data.converted[i].mixity.sin * data.converted[i].mixity.sin;
    least = std::min(least, share);
    largest = std::max(largest, share);
  }
  return std::none_of(shares.begin(), shares.end(), [&](const auto& share) {
    const double reach = share.second - share.first;
    return reach >= 0 && reach < kApart;  // < 0: no point
  });
}

void finish_energies(const std::string& metadata_path, Dataset& data) {
  if (!data.toughness_known && !data.points.empty()) take_largest_as_unit(metadata_path, data);
  const auto below = static_cast<std::size_t>(
      std::count_if(data.energies.begin(), data.energies.end(),
                    [](const PointEnergies& energies) { return energies.G_I < 0 || energies.G_II < 0; }));
  if (below > 0)
    data.notes.push_back(std::to_string(below) + " of " + std::to_string(data.points.size()) +
                         (below == 1 ? " points has" : " points have") + " G_I or G_II < 0 (noise about zero): " +
                         (below == 1 ? "it is" : "they are") + " used as pure mode II or I with toughness G_I + G_II");
  std::size_t zeros = 0;
  for (const PointEnergies& energies : data.energies) zeros += (energies.sigma_GI == 0) + (energies.sigma_GII == 0);
  if (zeros > 0)
    data.notes.push_back(std::to_string(zeros) +
                         (zeros == 1 ? " error of G_I or G_II is" : " errors of G_I or G_II are") +
                         " stated as 0: objective curve replaces " + (zeros == 1 ? "it" : "each") + " by " +
                         rounded(100 * kLeastError, 2) + " % of the largest energy");
  if (data.curves.size() > 1 && !series_have_toughness(data))
    data.notes.push_back(
        "the points of some series have a single phase angle, so their own toughness cannot be separated from the law: "
        "all series share one G_Ic");
}

}  // namespace mixity
