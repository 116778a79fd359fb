// Every mode-mixity model the program knows: the published ones, each with its header, and the laws that are typed
// (laws/law.h). To add one, write its header and include it here, or its line in data/laws.toml.
#pragma once

#include <tuple>
#include <type_traits>
#include <utility>

#include "mechanics/laws/typed_law.h"
#include "mechanics/models/benzeggagh_kenane.h"     // bk
#include "mechanics/models/johnson.h"               // a
#include "mechanics/models/papangelo_ciavarella.h"  // c
#include "mechanics/models/waters_guduru.h"         // b

namespace mixity {

namespace registry_detail {
template <int Slot>
auto filled() {
  if constexpr (requires { typename ModelSlot<Slot>::type; })
    return std::tuple<typename ModelSlot<Slot>::type>{};
  else
    return std::tuple<>{};
}
template <int... Slots>
auto collect(std::integer_sequence<int, Slots...>) {
  return std::tuple_cat(filled<Slots>()...);
}
}  // namespace registry_detail

/// std::tuple of the published models' types, in the order of their slots (64 at most).
using Models = decltype(registry_detail::collect(std::make_integer_sequence<int, 64>{}));

/// Calls visit(model) for each published model in turn.
template <class Visit>
void for_each_model(Visit&& visit) {
  std::apply([&](auto... model) { (visit(model), ...); }, Models{});
}

namespace registry_detail {
template <std::size_t N, class Visit>
bool visit_typed(const ExpressionLaw& law, Visit& visit) {
  if (law.definition().parameters.size() != N) return false;
  const CurrentLaw<N> current(law);
  visit(TypedLaw<N>{});
  return true;
}
}  // namespace registry_detail

/// Calls visit(model) for the model with this key and returns true; returns false if there is none. What a visit of a
/// typed law makes, and its types, are not to be used after it or on another thread.
template <class Visit>
bool with_model(std::string_view key, Visit&& visit) {
  if (std::apply(
          [&](auto... model) { return ((decltype(model)::info.key == key ? (visit(model), true) : false) || ...); },
          Models{}))
    return true;
  const std::shared_ptr<const ExpressionLaw> law = find_law(key);
  return law && (registry_detail::visit_typed<1>(*law, visit) || registry_detail::visit_typed<2>(*law, visit) ||
                 registry_detail::visit_typed<3>(*law, visit));
}

/// entry(model) for each model in turn, as a tuple. A source file that defines templates ends with
///
///     [[gnu::used]] const auto instances = each_model([](auto model) { return &do_it<decltype(model)>; });
///
/// where taking their addresses makes the instances, one for each model of the registry, that other files link with.
template <class Entry>
constexpr auto each_model(Entry entry) {
  return std::apply([&](auto... model) { return std::make_tuple(entry(model)...); },
                    std::tuple_cat(Models{}, std::tuple<TypedLaw<1>, TypedLaw<2>, TypedLaw<3>>{}));
}

template <class Model>
constexpr std::size_t parameter_count = std::tuple_size_v<std::remove_cvref_t<decltype(Model::parameters)>>;

template <class Model, class S = double>
using Parameters = std::array<S, parameter_count<Model>>;

}  // namespace mixity
