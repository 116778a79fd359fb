// A law that was defined at run time as a type without state, for code that knows laws by their types alone: which law
// it is holds while with_model (registry.h) visits it, on the thread that called it.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "mechanics/laws/typed_law.h"

namespace mixity {

namespace visited {
struct Visit {
  std::shared_ptr<const ExpressionLaw> law{};
  const TypedLaw* typed = nullptr;
};
inline Visit& current() {
  thread_local Visit visit;
  return visit;
}
inline const TypedLaw& law() { return *current().typed; }
}  // namespace visited

template <std::size_t N>
struct VisitedLaw {
  static inline thread_local ModelInfo info{};
  static inline thread_local std::array<ParameterInfo, N> parameters{};

  using P = std::array<double, N>;
  static ParameterValues list(const P& p) { return ParameterValues(std::span<const double>(p)); }
  static Differentiated<double, N> log_toughness(const P& p, const Mixity<double>& mixity) {
    const auto found = visited::law().log_toughness(list(p), mixity);
    Differentiated<double, N> result{found.value, {}};
    std::copy(found.gradient.begin(), found.gradient.end(), result.gradient.begin());
    return result;
  }
  static double log_toughness_alone(const P& p, const Mixity<double>& mixity) {
    return visited::law().log_toughness_alone(list(p), mixity);
  }
  static ShearTerm<double> shear_term(const P& p, double y, double T) {
    return visited::law().shear_term(list(p), y, T);
  }
  static double small_shear(const P& p) { return visited::law().small_shear(list(p)); }
  static double shear_limit(const P& p) { return visited::law().shear_limit(list(p)); }
  static ShearBend shear_bend(const P& p) { return visited::law().shear_bend(list(p)); }
  static ShearReach shear_reach(const P& p) { return visited::law().shear_reach(list(p)); }
  static bool tau_grows_with_edge_load(const P& p) { return visited::law().tau_grows_with_edge_load(list(p)); }
  static bool non_monotone(const P& p) { return visited::law().non_monotone(list(p)); }
  static std::string_view equilibrium_domain(const P& p) { return visited::law().equilibrium_domain(list(p)); }
};

/// Makes a law the one that VisitedLaw<N> is on this thread, until it is destroyed.
template <std::size_t N>
class CurrentLaw {
 public:
  explicit CurrentLaw(const std::shared_ptr<const ExpressionLaw>& law)
      : lease_(law),
        typed_(lease_),
        before_(visited::current()),
        info_(VisitedLaw<N>::info),
        parameters_(VisitedLaw<N>::parameters) {
    visited::current() = {law, &typed_};
    VisitedLaw<N>::info = law->info();
    std::copy_n(law->parameters().begin(), N, VisitedLaw<N>::parameters.begin());
  }
  CurrentLaw(const CurrentLaw&) = delete;
  CurrentLaw& operator=(const CurrentLaw&) = delete;
  ~CurrentLaw() {
    visited::current() = before_;
    VisitedLaw<N>::info = info_;
    VisitedLaw<N>::parameters = parameters_;
  }

 private:
  LawLease lease_;
  TypedLaw typed_;
  visited::Visit before_;
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
struct ModelOfVisit<VisitedLaw<N>> {
  std::shared_ptr<const ExpressionLaw> law = visited::current().law;
  CurrentLaw<N> enter() const { return CurrentLaw<N>(law); }
};

}  // namespace mixity
