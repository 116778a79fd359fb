#include "studies/simulate.h"

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/seed_seq.hpp>
#include <cmath>
#include <stdexcept>

#include "base/number_text.h"
#include "dataset/arrays.h"
#include "dataset/constants.h"
#include "fitting/model_problem.h"
#include "mechanics/contact_model.h"

namespace mixity {
namespace {

constexpr double kMilli = 1e-3, kMicro = 1e-6;  // experiments are in mN and mm^2, approaches in um

Contact contact_of(const Metadata& constants) {
  return {*constants.radius, *constants.plane_strain_modulus(), *constants.toughness};
}

/// The largest T of a stable contact, dimensionless; for a contact that never jumps, the natural scale of T.
double longest_shear(const ContactModel& model, const Plan& plan, double P) {
  for (const Fold& fold : model.folds(plan.parameters, P, {Control::Kind::load}))
    if (fold.place.maximum) return fold.T;
  if (model.is_elliptic())
    if (const double end = model.first_stable_end(plan.parameters, P); std::isfinite(end)) return end;
  if (model.holds_approach()) {
    const double end = model.first_stable_end(plan.parameters, P), a = model.unsheared_radius(P);
    return std::isfinite(end) ? end : 3 * std::sqrt(8 * pi<double>() * a) * a;
  }
  const auto regime = model.regime(plan.parameters, P);
  return regime && std::isfinite(regime->T_end) ? regime->T_end : 3 * circle_radius(P);
}

std::uint32_t low(std::uint64_t word) { return static_cast<std::uint32_t>(word); }
std::uint32_t high(std::uint64_t word) { return static_cast<std::uint32_t>(word >> 32); }

/// Standard normal numbers for one experiment; zeros if it has no errors.
class Chance {
 public:
  Chance(std::uint64_t seed, std::optional<std::uint64_t> index) : any_(index.has_value()) {
    const auto words = {low(seed), high(seed), low(index.value_or(0)), high(index.value_or(0))};
    boost::random::seed_seq sequence(words);
    random_.seed(sequence);
  }
  double operator()() { return any_ ? normal_(random_) : 0; }

 private:
  bool any_;
  boost::random::mt19937_64 random_;
  boost::random::normal_distribution<double> normal_;
};

/// The model under the control of the plan.
ContactModel model_of(const Plan& plan) {
  const ContactModel model = ContactModel::find(plan.model).value();
  if (plan.constants.control != NormalControl::approach) return model;
  const auto& stiffness = plan.constants.normal_stiffness;
  return model.at_held_approach(stiffness ? contact_of(plan.constants).stiffness_unit() / *stiffness : 0);
}

/// The unit of what is held: N, or m of an approach.
double held_unit(const Plan& plan) {
  const Contact contact = contact_of(plan.constants);
  return plan.constants.control == NormalControl::approach ? contact.displacement_unit() : contact.force_unit();
}

/// Standard errors of values, in their unit (mN or mm^2).
double error_of(const StatedError& stated, double value, double unit) {
  return stated.unit.text == "%" ? std::abs(value) * stated.si() : stated.si() / unit;
}

}  // namespace

std::string problem_of(const Plan& plan) {
  const auto model = ContactModel::find(plan.model);
  if (!model) return "no model is called '" + plan.model + "'";
  if (auto problem = model->problem(plan.parameters); !problem.empty()) return problem;
  const Metadata& constants = plan.constants;
  if (!constants.radius || !constants.plane_strain_modulus() || !constants.toughness)
    return "radius, modulus and toughness must be stated";
  if (!contact_of(constants).usable()) return "radius, modulus and toughness together are out of range";
  if (model->is_elliptic() && constants.mode_III == ModeIII::averaged) return kNoAverage;
  if (plan.loads.empty()) return "a plan needs a load";
  for (const double load : plan.loads)
    if (constants.control == NormalControl::approach) {
      if (model->is_elliptic()) return "a held approach is known for circles alone";
      if (!model_of(plan).in_contact(load / held_unit(plan))) return "an approach lies below pull-off";
    } else if (!(above_pull_off(load / contact_of(constants).force_unit()) > 0)) {
      return "a load lies at or below pull-off";
    }
  if (plan.points < 3) return "a run needs three points";
  if (!(plan.reach > 0 && plan.reach <= 1)) return "reach must lie above 0 and be at most 1";
  const auto fits = [](const StatedError& error, const Dimension& dimension) {
    return error.value > 0 && (error.unit.text == "%" || error.unit.dimension == dimension);
  };
  if (!fits(plan.sigma_T, dimension::force)) return "sigma_T must be a percentage or a force, above 0";
  if (!fits(plan.sigma_A, dimension::area)) return "sigma_A must be a percentage or an area, above 0";
  return "";
}

Dataset simulate(const Plan& plan, std::uint64_t seed, std::optional<std::uint64_t> index) {
  if (const std::string problem = problem_of(plan); !problem.empty()) throw std::invalid_argument(problem);
  const ContactModel model = model_of(plan);
  const Metadata& stated = plan.constants;
  const bool held = stated.control == NormalControl::approach;
  Chance chance(seed, index);
  const Contact nominal = contact_of(stated);
  Constants truth{};
  truth.shear_weight = stated.shear_weight();
  truth.approach_held = held;
  const auto add_error = [&](Constant c, double size) {
    truth[c] += stated.standard_error(kConstantNames[c]) / size * chance();
  };
  if (stated.area_scale) truth[kAreaScale] = std::log(*stated.area_scale);
  if (stated.force_gain) truth[kForceGain] = std::log(*stated.force_gain);
  truth[kLoadOffset] = stated.load_offset.value_or(0) / nominal.force_unit();
  truth[kShearOffset] = stated.shear_offset.value_or(0) / nominal.force_unit();
  truth[kAreaOffset] = stated.area_offset.value_or(0) / nominal.area_unit();
  add_error(kRadius, nominal.radius);
  truth[kModulus] += stated.modulus_error() * chance();
  add_error(kToughness, nominal.toughness);
  add_error(kLoadOffset, nominal.force_unit());
  add_error(kShearOffset, nominal.force_unit());
  add_error(kAreaOffset, nominal.area_unit());
  add_error(kAreaScale, stated.area_scale.value_or(1));
  if (held) {
    truth[kApproachOffset] = stated.approach_offset.value_or(0) / nominal.displacement_unit();
    if (stated.standard_error(kConstantNames[kApproachOffset]) > 0)
      add_error(kApproachOffset, nominal.displacement_unit());
  }
  // Constants without an error take no random number, so that plans of earlier versions give the same experiments.
  for (const Constant c : kAllConstants)
    if ((c == kForceGain || is_change(c)) && stated.standard_error(kConstantNames[c]) > 0)
      add_error(c, c == kForceGain ? stated.force_gain.value_or(1) : 1);

  std::vector<double> P, T, A, sigma_T, sigma_A, along, across, sigma_along, sigma_across;
  std::vector<std::string> runs;
  DistinctNames names;
  const double mm2 = kMilli * kMilli;
  for (std::size_t k = 0; k < plan.loads.size(); ++k) {
    // The apparatus is controlled by its readings.
    const double load = plan.loads[k] / held_unit(plan), longest = plan.reach * longest_shear(model, plan, load);
    const std::string run = names.free_name(held ? "delta=" + rounded(plan.loads[k] / kMicro, 4) + " um"
                                                 : "P=" + rounded(plan.loads[k] / kMilli, 4) + " mN");
    names.take(run);
    const std::size_t last_run = plan.loads.size() - 1;
    const double order = last_run > 0 ? static_cast<double>(k) / static_cast<double>(last_run) - 0.5 : 0;
    const auto scale_at = [&](std::size_t i) {
      const double share = static_cast<double>(i) / static_cast<double>(plan.points - 1);
      return ConstantsScale(truth, {order, share * share, i == 0});
    };
    std::vector<double> shears(plan.points), areas_found(plan.points);
    std::vector<EquilibriumStatus> status(plan.points);
    const double last_shear = longest / truth.shear_weight;
    // T is the planned one, whatever its zero.
    for (std::size_t i = 0; i < plan.points; ++i)
      shears[i] = last_shear * static_cast<double>(i) / static_cast<double>(plan.points - 1) * scale_at(i).shear_force;
    const auto without = std::span(status).first(1), with = std::span(status).subspan(1);
    at_scale(model, scale_at(0))
        .areas_at(plan.parameters, scale_at(0).load(load), std::span(shears).first(1), std::span(areas_found).first(1),
                  without);
    at_scale(model, scale_at(1))
        .areas_at(plan.parameters, scale_at(1).load(load), std::span(shears).subspan(1),
                  std::span(areas_found).subspan(1), with);
    for (std::size_t i = 0; i < plan.points; ++i) {
      if (status[i] != EquilibriumStatus::ok) continue;  // the contact has jumped
      const ConstantsScale scale = scale_at(i);
      const double shear = scale.measured_shear(shears[i]) * nominal.force_unit() / kMilli,
                   area = scale.measured_area(areas_found[i]) * nominal.area_unit() / mm2;
      // errors at the true values, so that noise does not change the weights
      const double dT = error_of(
                       plan.sigma_T,
                       std::max(shear, last_shear * nominal.force_unit() / kMilli / static_cast<double>(plan.points)),
                       kMilli),
                   dA = error_of(plan.sigma_A, area, mm2);
      P.push_back(plan.loads[k] / (held ? kMicro : kMilli));
      T.push_back(shear + dT * chance());
      A.push_back(area + dA * chance());
      sigma_T.push_back(dT);
      sigma_A.push_back(dA);
      if (const auto ends = model.ends_of(plan.parameters)) {
        // independent errors of both axes, which are equal in share, give ln(a/b) the relative error of A
        const EllipseState state = model.ellipses(*ends, scale.load(load), std::span(shears).subspan(i, 1)).at.front();
        const double ratio = std::exp(0.5 * (std::log(state.a / state.b) + dA / area * chance())),
                     mean = std::sqrt(A.back() / pi<double>()), share = dA / area / std::sqrt(2.0);
        along.push_back(mean * ratio);
        across.push_back(mean / ratio);
        sigma_along.push_back(along.back() * share);
        sigma_across.push_back(across.back() * share);
      }
      runs.push_back(run);
    }
  }
  Metadata metadata = stated;
  metadata.provenance = Provenance::reconstructed;
  metadata.source = "simulated: model " + plan.model;
  const std::string name = index ? "experiment " + std::to_string(*index) + " of seed " + std::to_string(seed) : "plan";
  std::vector<ArrayColumn> columns{
      {held ? "delta [um]" : "P [mN]", P}, {"T [mN]", T},      {"A [mm^2]", A}, {"sigma_T [mN]", sigma_T},
      {"sigma_A [mm^2]", sigma_A},         {"curve", {}, runs}};
  if (!along.empty()) {
    columns.push_back({"a_par [mm]", along});
    columns.push_back({"a_perp [mm]", across});
    columns.push_back({"sigma_a_par [mm]", sigma_along});
    columns.push_back({"sigma_a_perp [mm]", sigma_across});
  }
  return make_dataset(name, columns, metadata);
}

}  // namespace mixity
