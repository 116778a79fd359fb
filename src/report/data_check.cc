#include "report/data_check.h"

#include "fitting/unsheared.h"
#include "report/data_text.h"

namespace mixity {
namespace {

/// Null if the stated errors are unusable, which is reported elsewhere.
std::optional<UnshearedTest> unsheared_if_errors_allow(const Dataset& data) {
  try {
    return test_unsheared(data, {});
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// Adds arbitrary values for missing constants; the reading of a file does not depend on them.
Overrides with_some(const std::vector<std::string>& constants, Overrides stated) {
  for (const std::string& name : constants)
    stated.emplace_back(name, name == "radius" ? "1 mm" : name == "modulus" ? "1 MPa" : "1 J/m^2");
  return stated;
}

}  // namespace

CheckedData check_data(const std::function<Dataset(const Overrides&)>& load, const Overrides& constants,
                       Wording words) {
  try {
    const Dataset data = load(constants);
    return {check_text(data, unsheared_if_errors_allow(data), words), !data.points.empty(), understood(data)};
  } catch (const MissingConstants& error) {
    const std::vector<std::string> missing = error.message().options();
    const Dataset data = load(with_some(missing, constants));
    return {reading_text(data) + "[[To fit it]]\n    " + error.text(words) + '\n', !data.points.empty(),
            understood(data, missing)};
  }
}

}  // namespace mixity
