#include "mechanics/contact_model.h"

#include "mechanics/operations.h"
#include "mechanics/regimes.h"

namespace mixity {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

template <class Law>
std::shared_ptr<const Operations> make_operations(std::shared_ptr<const ExpressionLaw> law) {
  const ExpressionLaw* const typed = law.get();
  Operations made{{}, {}, std::move(law), nullptr, nullptr, nullptr, nullptr};
  if constexpr (std::is_same_v<Law, TypedLaw>) {
    made.info = typed->info();
    made.parameters = typed->parameters();
  } else {
    made.info = Law::info;
    made.parameters.assign(Law::parameters.begin(), Law::parameters.end());
  }
  made.areas = area_operations<Law>(typed);
  made.curves = curve_operations<Law>(typed);
  made.toughness = toughness_operations<Law>(typed);
  made.distances = distance_operations<Law>(typed);
  return std::make_shared<const Operations>(std::move(made));
}

bool is_contact(const Operations& model, ParameterSpan p, double P) {
  return model.areas->obstacle(p, P).empty() && !(above_pull_off(P) < 0);
}

}  // namespace

std::optional<ContactModel> ContactModel::find(std::string_view key) {
  for (const ContactModel& model : published())
    if (model.info().key == key) return model;
  const std::shared_ptr<const ExpressionLaw> law = find_law(key);
  return law ? std::optional(ContactModel(law)) : std::nullopt;
}

const std::vector<ContactModel>& ContactModel::published() {
  static const std::vector<ContactModel> all = [] {
    std::vector<ContactModel> models;
    for_each_model([&](auto law) { models.push_back(ContactModel(make_operations<decltype(law)>(nullptr))); });
    return models;
  }();
  return all;
}

ContactModel::ContactModel(std::shared_ptr<const Operations> operations) : operations_(std::move(operations)) {}
ContactModel::ContactModel(std::shared_ptr<const ExpressionLaw> law)
    : operations_(make_operations<TypedLaw>(std::move(law))) {}

const ModelInfo& ContactModel::info() const { return operations_->info; }
std::span<const ParameterInfo> ContactModel::parameters() const { return operations_->parameters; }

std::string_view ContactModel::obstacle(ParameterSpan p, double P) const { return operations_->areas->obstacle(p, P); }

std::string ContactModel::problem(ParameterSpan p, double P) const {
  const std::size_t n = parameters().size();
  if (p.size() != n)
    return "model " + std::string(info().key) + " has " + std::to_string(n) + (n == 1 ? " parameter" : " parameters") +
           ", not " + std::to_string(p.size());
  for (const double load : {0.0, P})
    if (const std::string_view why = obstacle(p, load); !why.empty()) return std::string(why);
  return above_pull_off(P) < 0 ? "no contact exists below the pull-off load -3 pi/2 R G_Ic" : "";
}

void ContactModel::make_continuous(std::span<double> p) const { operations_->distances->make_continuous(p); }

void ContactModel::areas(std::span<const Values> p, Values P, Values T, std::span<double> A,
                         std::span<EquilibriumStatus> status) const {
  if (p.size() == parameters().size()) return operations_->areas->areas(p, P, T, A, status);
  std::fill(A.begin(), A.end(), kNaN);
  std::fill(status.begin(), status.end(), EquilibriumStatus::invalid);
}

void ContactModel::areas_at(ParameterSpan p, double P, std::span<const double> T, std::span<double> A,
                            std::span<EquilibriumStatus> status) const {
  std::vector<Values> all;
  for (const double& one : p) all.push_back({&one, 0});
  areas(all, {&P, 0}, {T.data(), 1}, A, status);
}

void ContactModel::area_slopes(std::span<const Values> p, Values P, Values T, std::span<const double> A,
                               std::span<const std::span<double>> slopes) const {
  for (const std::span<double> of_one : slopes) std::fill(of_one.begin(), of_one.end(), kNaN);
  if (p.size() == parameters().size()) operations_->areas->area_slopes(p, P, T, A, slopes);
}

void ContactModel::toughness_ratios(std::span<const Values> p, Values psi, std::span<double> f) const {
  std::fill(f.begin(), f.end(), kNaN);
  if (p.size() == parameters().size()) operations_->toughness->toughness_ratios(p, psi, f);
}

void ContactModel::tangential_loads(std::span<const Values> p, Values P, Values A, std::span<double> T) const {
  std::fill(T.begin(), T.end(), kNaN);
  if (p.size() == parameters().size()) operations_->areas->tangential_loads(p, P, A, T);
}

Equilibria ContactModel::equilibria(ParameterSpan p, double P, std::span<const double> T) const {
  return operations_->areas->equilibria(p, P, T);
}

double ContactModel::first_stable_end(ParameterSpan p, double P) const {
  return is_contact(*operations_, p, P) ? operations_->curves->first_stable_end(p, P) : 0;
}

std::vector<Fold> ContactModel::folds(ParameterSpan p, double P, Control control) const {
  if (!is_contact(*operations_, p, P)) return {};
  return operations_->curves->folds(p, P, control);
}

std::optional<RegimeReport> ContactModel::regime(ParameterSpan p, double P, std::optional<double> tau0) const {
  if (!is_contact(*operations_, p, P)) return std::nullopt;
  return operations_->curves->regime(p, P, tau0);
}

SampledCurve ContactModel::curve(ParameterSpan p, double P, const CurveSampling& sampling) const {
  if (!is_contact(*operations_, p, P)) return {{}, false};
  return operations_->curves->curve(p, P, sampling);
}

std::vector<ConstantShearPoint> ContactModel::at_constant_shear(ParameterSpan p, double T,
                                                                std::span<const double> y) const {
  return operations_->curves->at_constant_shear(p, T, y);
}

std::optional<double> ContactModel::critical_load(ParameterSpan p) const {
  return obstacle(p).empty() ? std::optional(operations_->curves->critical_load(p)) : std::nullopt;
}

std::optional<std::span<const RegimeBoundary>> ContactModel::regime_boundaries() const {
  return mixity::regime_boundaries(info().key);
}

std::optional<double> ContactModel::shear_sensitivity(ParameterSpan p, double A0) const {
  return operations_->curves->shear_sensitivity(p, A0);
}

void ContactModel::log_toughness(ParameterSpan p, std::span<const Mixity<double>> at, std::span<double> value,
                                 std::span<double> gradient) const {
  operations_->toughness->log_toughness(p, at, value, gradient);
}

bool ContactModel::has_packed_form() const { return operations_->toughness->has_packed_form(); }

PackedMixities ContactModel::packed(std::span<const Mixity<double>> at) const {
  return operations_->toughness->packed(at);
}

void ContactModel::packed_log_toughness(double parameter, const PackedMixities& at, std::size_t begin, std::size_t n,
                                        double* value, double* slope, double* curvature) const {
  operations_->toughness->packed_log_toughness(parameter, at.first.data() + begin, at.second.data() + begin, n, value,
                                               slope, curvature);
}

bool ContactModel::toughness_residuals(ParameterSpan p, std::span<const double> P, std::span<const double> T,
                                       std::span<const double> A, const ToughnessResiduals& out) const {
  return operations_->distances->toughness_residuals(p, P, T, A, out);
}

bool ContactModel::curve_distances(ParameterSpan p, const PlanePoints& points, Search search, bool derivatives,
                                   CurveDistances& out) const {
  return operations_->distances->curve_distances(p, points, search, derivatives, out);
}

void ContactModel::energy_distances(ParameterSpan p, const EnergyPoints& points, const EnergyDistances& out) const {
  operations_->distances->energy_distances(p, points, out);
}

void ContactModel::rough_energy_distances(ParameterSpan p, const EnergyPoints& points, std::span<double> out) const {
  operations_->distances->rough_energy_distances(p, points, out);
}

}  // namespace mixity
