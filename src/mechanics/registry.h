// The types of laws: the published ones, each from its header, and UserLawView for those defined at run time. To add a
// published law, write its header and include it here. Laws given as text belong in data/laws.toml.
#pragma once

#include <tuple>
#include <type_traits>
#include <utility>

#include "mechanics/laws/user_law_view.h"
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

/// std::tuple of the published laws' types, in the order of their slots (64 at most).
using Models = decltype(registry_detail::collect(std::make_integer_sequence<int, 64>{}));

/// Calls visit(law) for each published law in turn.
template <class Visit>
void for_each_model(Visit&& visit) {
  std::apply([&](auto... law) { (visit(law), ...); }, Models{});
}

namespace registry_detail {
template <class... Law>
std::tuple<Law..., UserLawView> with_user_laws(std::tuple<Law...>);

template <class Entry, class... Law>
constexpr auto each_of(Entry entry, std::type_identity<std::tuple<Law...>>) {
  return std::make_tuple(entry.template operator()<Law>()...);
}
}  // namespace registry_detail

/// entry<Law>() for each type of law, as a tuple. A source file that defines templates ends with
///
///     [[gnu::used]] const auto instances = each_law([]<class Law> { return &do_it<Law>; });
///
/// Taking the addresses instantiates the templates for other files to link against.
template <class Entry>
constexpr auto each_law(Entry entry) {
  return registry_detail::each_of(entry, std::type_identity<decltype(registry_detail::with_user_laws(Models{}))>{});
}

}  // namespace mixity
