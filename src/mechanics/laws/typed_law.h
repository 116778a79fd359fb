// Model types of typed laws, one for each number of parameters. Which law they are is known while with_model
// (registry.h) visits one of them, on the thread that called it: their names and bounds are those of that law then.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "mechanics/laws/law.h"
#include "mechanics/model.h"

namespace mixity {

template <std::size_t N>
struct TypedLaw {
  static inline thread_local ModelInfo info{};
  static inline thread_local std::array<ParameterInfo, N> parameters{};

  using P = std::array<double, N>;
  static Differentiated<double, N> log_toughness(const P& p, const Mixity<double>& mixity) {
    Differentiated<double, N> found{};
    found.value = typed::log_toughness(p, mixity, found.gradient);
    return found;
  }
  static double log_toughness_alone(const P& p, const Mixity<double>& mixity) {
    return typed::log_toughness(p, mixity, {});
  }
  static ShearTerm<double> shear_term(const P& p, double y, double T) { return typed::shear_term(p, y, T); }
  static double small_shear(const P& p) { return typed::small_shear(p); }
  static double shear_limit(const P& p) { return typed::shear_limit(p); }
  static ShearBend shear_bend(const P& p) { return typed::shear_bend(p); }
  static ShearReach shear_reach(const P& p) { return typed::shear_reach(p); }
  static bool tau_grows_with_edge_load(const P& p) { return typed::tau_grows_with_edge_load(p); }
  static bool turns(const P& p) { return typed::turns(p); }
  static std::string_view equilibrium_domain(const P& p) { return typed::equilibrium_domain(p); }
};

/// Makes a law the one that TypedLaw<N> is on this thread, until it is destroyed.
template <std::size_t N>
class CurrentLaw {
 public:
  explicit CurrentLaw(const ExpressionLaw& law)
      : law_(current_law()), info_(TypedLaw<N>::info), parameters_(TypedLaw<N>::parameters) {
    const LawDefinition& definition = law.definition();
    current_law() = &law;
    TypedLaw<N>::info = {definition.key, definition.name.empty() ? definition.key : definition.name, law.shown()};
    for (std::size_t i = 0; i < N; ++i) {
      const LawParameter& one = definition.parameters[i];
      TypedLaw<N>::parameters[i] = {one.name, one.lower, one.upper, one.start};
    }
  }
  CurrentLaw(const CurrentLaw&) = delete;
  CurrentLaw& operator=(const CurrentLaw&) = delete;
  ~CurrentLaw() {
    current_law() = law_;
    TypedLaw<N>::info = info_;
    TypedLaw<N>::parameters = parameters_;
  }

 private:
  const ExpressionLaw* law_;
  ModelInfo info_;
  std::array<ParameterInfo, N> parameters_;
};

/// For work that a visit shares out: made in the visit, entered on each thread.
template <class Model>
struct ModelOfVisit {
  struct Entered {};
  Entered enter() const { return {}; }
};
template <std::size_t N>
struct ModelOfVisit<TypedLaw<N>> {
  const ExpressionLaw* law = current_law();
  CurrentLaw<N> enter() const { return CurrentLaw<N>(*law); }
};

}  // namespace mixity
