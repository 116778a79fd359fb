#include "mechanics/contact_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/any_law.h"
#include "mechanics/elliptic_model.h"
#include "mechanics/equilibrium.h"
#include "mechanics/held_model.h"
#include "mechanics/laws/known_laws.h"
#include "mechanics/packed_toughness.h"

namespace mixity {

std::optional<ContactModel> ContactModel::find(std::string_view key) {
  for (const ContactModel& model : published())
    if (model.info().key == key) return model;
  if (const std::shared_ptr<const UserLaw> law = find_law(key)) return ContactModel(law);
  if (const std::shared_ptr<const AnyLaw> law = elliptic_law(key)) return ContactModel(law);
  return std::nullopt;
}

const std::vector<ContactModel>& ContactModel::published() {
  static const std::vector<ContactModel> all = [] {
    std::vector<ContactModel> models;
    for_each_model([&](auto law) {
      models.push_back(ContactModel(std::make_shared<const AnyLaw>(AnyLaw{law, law.info, law.parameters})));
    });
    return models;
  }();
  return all;
}

ContactModel::ContactModel(std::shared_ptr<const AnyLaw> law) : law_(std::move(law)) {}
ContactModel::ContactModel(std::shared_ptr<const UserLaw> law)
    : law_(std::make_shared<const AnyLaw>(AnyLaw{law, law->info(), law->parameters()})) {}

const ModelInfo& ContactModel::info() const { return law_->info; }
std::span<const ParameterInfo> ContactModel::parameters() const { return law_->parameters; }

bool ContactModel::is_elliptic() const { return law_->ellipse != nullptr; }

bool is_elliptic(std::string_view key) {
  const auto model = ContactModel::find(key);
  return model && model->is_elliptic();
}

ContactModel ContactModel::circle() const { return is_elliptic() ? ContactModel(law_->ellipse->circle) : *this; }

std::optional<EndParameters> ContactModel::ends_of(ParameterSpan p) const {
  return law_->ellipse ? std::optional(elliptic::ends_of(*law_->ellipse, p)) : std::nullopt;
}

std::string_view ContactModel::obstacle(ParameterSpan p, double P) const {
  if (law_->ellipse) return elliptic::obstacle(*law_->ellipse, p, P);
  if (law_->held) return held::obstacle(*law_, p, P);
  return with_law(*law_, p, [&](const auto& law, const auto& values) { return contact_obstacle(law, values, P); });
}

std::string ContactModel::problem(ParameterSpan p, double P) const {
  const std::size_t n = parameters().size();
  if (p.size() != n)
    return "model " + std::string(info().key) + " has " + std::to_string(n) + (n == 1 ? " parameter" : " parameters") +
           ", not " + std::to_string(p.size());
  for (const double load : {0.0, P})
    if (const std::string_view why = obstacle(p, load); !why.empty()) return std::string(why);
  if (in_contact(P)) return "";
  return law_->held ? "no contact exists below the approach of pull-off"
                    : "no contact exists below the pull-off load -3 pi/2 R G_Ic";
}

void ContactModel::make_continuous(std::span<double> p) const {
  if (law_->ellipse) return elliptic::make_continuous(*law_->ellipse, p);
  with_law(*law_, p, [&]([[maybe_unused]] const auto& law, const auto& values) {
    if constexpr (requires { law.continuous(values); }) {
      const auto next = law.continuous(values);
      std::copy(next.begin(), next.end(), p.begin());
    }
  });
}

void ContactModel::toughness_ratios(std::span<const Values> p, Values psi, std::span<double> f) const {
  std::fill(f.begin(), f.end(), std::numeric_limits<double>::quiet_NaN());
  if (p.size() != parameters().size() || law_->ellipse) return;
  with_law(*law_, [&]<class Law>(const Law& law) {
    for (std::size_t i = 0; i < f.size(); ++i) {
      const auto values = parameters_at<Law>(p, i);
      if (!(psi[i] >= 0 && psi[i] <= kLargestPhaseAngle) || !in_bounds(law, values)) continue;
      f[i] = std::exp(log_toughness_alone(law, values, mixity_from_angle(psi[i])));
    }
  });
}

void ContactModel::log_toughness(ParameterSpan p, std::span<const Mixity<double>> at, std::span<double> value,
                                 std::span<double> gradient) const {
  if (law_->ellipse) return std::fill(value.begin(), value.end(), std::numeric_limits<double>::quiet_NaN());
  with_law(*law_, p, [&](const auto& law, const auto& values) {
    for (std::size_t i = 0; i < at.size(); ++i) {
      if (gradient.empty()) {
        value[i] = log_toughness_alone(law, values, at[i]);
        continue;
      }
      const auto log_f = law.log_toughness(values, at[i]);
      value[i] = log_f.value;
      std::copy(log_f.gradient.begin(), log_f.gradient.end(),
                gradient.begin() + static_cast<std::ptrdiff_t>(i * p.size()));
    }
  });
}

bool ContactModel::has_packed_form() const {
  return !law_->ellipse && with_law(*law_, []<class Law>(const Law&) { return HasPackedForm<Law>; });
}

void ContactModel::pack(std::span<const Mixity<double>> at, PackedMixities& packed) const {
  with_law(*law_, [&]<class Law>([[maybe_unused]] const Law& law) {
    if constexpr (HasPackedForm<Law>)
      for (const Mixity<double>& mixity : at) {
        const PackedPoint<double> point = law.packed_point(mixity);
        packed.first.push_back(point.first);
        packed.second.push_back(point.second);
      }
  });
}

void ContactModel::packed_log_toughness(double parameter, const PackedMixities& at, std::size_t begin, std::size_t n,
                                        double* value, double* slope, double* curvature) const {
  with_law(*law_, [&]<class Law>([[maybe_unused]] const Law& law) {
    if constexpr (HasPackedForm<Law>)
      mixity::packed_log_toughness(law, parameter, at.first.data() + begin, at.second.data() + begin, n, value, slope,
                                   curvature);
  });
}

}  // namespace mixity
