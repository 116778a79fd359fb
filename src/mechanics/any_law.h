// The law of a ContactModel, of any type, and functions that call a template with its concrete type.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <tuple>
#include <variant>

#include "mechanics/contact_model.h"
#include "mechanics/equilibrium.h"
#include "mechanics/registry.h"

namespace mixity {

namespace any_law_detail {
template <class... Law>
std::variant<Law..., std::shared_ptr<const UserLaw>> variant_of(std::tuple<Law...>);
}  // namespace any_law_detail

struct EllipticModel;
struct HeldModel;

/// A published law, or one that was defined at run time. Immutable.
struct AnyLaw {
  decltype(any_law_detail::variant_of(Models{})) value;
  const ModelInfo& info;
  std::span<const ParameterInfo> parameters;
  std::shared_ptr<const EllipticModel> ellipse{};  // of elliptic contacts; info and parameters are then its own
  std::shared_ptr<const HeldModel> held{};         // of contacts whose approach is held
};

using ParameterSpan = std::span<const double>;

/// Returns visit(law), where `law` has the type of a published law or is a UserLawView, valid during the call.
template <class Visit>
auto with_law(const AnyLaw& any, const Visit& visit) {
  const auto use = [&]<class Held>(const Held& held) {
    if constexpr (std::is_same_v<Held, std::shared_ptr<const UserLaw>>) {
      const LawLease lease(*held);
      return visit(UserLawView(lease));
    } else {
      return visit(held);
    }
  };
  return std::visit(use, any.value);
}

/// Returns visit(law, p) with the parameters in the law's own type.
template <class Visit>
auto with_law(const AnyLaw& any, ParameterSpan p, const Visit& visit) {
  return with_law(any, [&]<class Law>(const Law& law) { return visit(law, parameters_from<Law>(p)); });
}

/// Returns visit(law, p) if the contact with these parameters exists under the load P, else `otherwise`.
template <class Result, class Visit>
Result with_contact(const AnyLaw& any, ParameterSpan p, double P, Result otherwise, const Visit& visit) {
  return with_law(any, p, [&](const auto& law, const auto& values) -> Result {
    if (!contact_obstacle(law, values, P).empty() || above_pull_off(P) < 0) return std::move(otherwise);
    return visit(law, values);
  });
}

/// The parameters of point i.
template <class Law>
Parameters<Law> parameters_at(std::span<const Values> values, std::size_t i) {
  std::array<double, parameter_count<Law>> p{};
  const std::size_t n = std::is_same_v<Law, UserLawView> ? values.size() : p.size();
  for (std::size_t k = 0; k < n; ++k) p[k] = values[k][i];
  return parameters_from<Law>({p.data(), n});
}

}  // namespace mixity
