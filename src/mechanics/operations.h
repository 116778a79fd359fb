// What ContactModel asks of a law: virtual functions on arrays, documented there. Each part is implemented by one class
// template of the law, in the file beside it.
#pragma once

#include <memory>
#include <vector>

#include "mechanics/contact_model.h"
#include "mechanics/registry.h"

namespace mixity {

using ParameterSpan = std::span<const double>;

/// Loads and areas: operations_areas.cc.
class AreaOperations {
 public:
  virtual ~AreaOperations() = default;
  virtual std::string_view obstacle(ParameterSpan p, double P) const = 0;
  virtual void areas(std::span<const Values> p, Values P, Values T, std::span<double> A,
                     std::span<EquilibriumStatus> status) const = 0;
  virtual void area_slopes(std::span<const Values> p, Values P, Values T, std::span<const double> A,
                           std::span<const std::span<double>> slopes) const = 0;
  virtual void tangential_loads(std::span<const Values> p, Values P, Values A, std::span<double> T) const = 0;
  virtual Equilibria equilibria(ParameterSpan p, double P, std::span<const double> T) const = 0;
};

/// Whole curves and what becomes of a contact: operations_curves.cc.
class CurveOperations {
 public:
  virtual ~CurveOperations() = default;
  virtual double first_stable_end(ParameterSpan p, double P) const = 0;
  virtual std::vector<Fold> folds(ParameterSpan p, double P, Control control) const = 0;
  virtual RegimeReport regime(ParameterSpan p, double P, std::optional<double> tau0) const = 0;
  virtual SampledCurve curve(ParameterSpan p, double P, const CurveSampling& sampling) const = 0;
  virtual std::vector<ConstantShearPoint> at_constant_shear(ParameterSpan p, double T,
                                                            std::span<const double> y) const = 0;
  virtual double critical_load(ParameterSpan p) const = 0;
  virtual std::optional<double> shear_sensitivity(ParameterSpan p, double A0) const = 0;
};

/// The law f(psi): operations_toughness.cc.
class ToughnessOperations {
 public:
  virtual ~ToughnessOperations() = default;
  virtual void toughness_ratios(std::span<const Values> p, Values psi, std::span<double> f) const = 0;
  virtual void log_toughness(ParameterSpan p, std::span<const Mixity<double>> at, std::span<double> value,
                             std::span<double> gradient) const = 0;
  virtual bool has_packed_form() const = 0;
  virtual PackedMixities packed(std::span<const Mixity<double>> at) const = 0;
  virtual void packed_log_toughness(double parameter, const double* first, const double* second, std::size_t n,
                                    double* value, double* slope, double* curvature) const = 0;
};

/// Distances of measured points from the law: operations_distances.cc.
class DistanceOperations {
 public:
  virtual ~DistanceOperations() = default;
  virtual void make_continuous(std::span<double> p) const = 0;
  virtual bool toughness_residuals(ParameterSpan p, std::span<const double> P, std::span<const double> T,
                                   std::span<const double> A, const ToughnessResiduals& out) const = 0;
  virtual bool curve_distances(ParameterSpan p, const PlanePoints& points, Search search, bool derivatives,
                               CurveDistances& out) const = 0;
  virtual void energy_distances(ParameterSpan p, const EnergyPoints& points, const EnergyDistances& out) const = 0;
  virtual void rough_energy_distances(ParameterSpan p, const EnergyPoints& points, std::span<double> out) const = 0;
};

/// All of a model. Not to change once made.
struct Operations {
  ModelInfo info;
  std::vector<ParameterInfo> parameters;
  std::shared_ptr<const ExpressionLaw> law;  // null of a published model; info and parameters name its texts
  std::unique_ptr<const AreaOperations> areas;
  std::unique_ptr<const CurveOperations> curves;
  std::unique_ptr<const ToughnessOperations> toughness;
  std::unique_ptr<const DistanceOperations> distances;
};

/// The law of a part, and its use for the time of a call.
template <class Law>
class HeldLaw {
 public:
  explicit HeldLaw(const ExpressionLaw*) {}
  struct Use {
    Law law;
  };
  Use use() const { return {}; }
};
template <>
class HeldLaw<TypedLaw> {
 public:
  explicit HeldLaw(const ExpressionLaw* law) : law_(*law) {}
  struct Use {
    LawLease lease;
    TypedLaw law;
    explicit Use(const ExpressionLaw& of) : lease(of), law(lease) {}
  };
  Use use() const { return Use(law_); }

 private:
  const ExpressionLaw& law_;
};

template <class Law>
std::unique_ptr<const AreaOperations> area_operations(const ExpressionLaw* law);
template <class Law>
std::unique_ptr<const CurveOperations> curve_operations(const ExpressionLaw* law);
template <class Law>
std::unique_ptr<const ToughnessOperations> toughness_operations(const ExpressionLaw* law);
template <class Law>
std::unique_ptr<const DistanceOperations> distance_operations(const ExpressionLaw* law);

/// The parameters of point i.
template <class Law>
Parameters<Law> parameters_at(std::span<const Values> values, std::size_t i) {
  static_assert(parameter_count<Law> <= ParameterValues::kMost);
  std::array<double, parameter_count<Law>> p{};
  const std::size_t n = std::is_same_v<Law, TypedLaw> ? values.size() : p.size();
  for (std::size_t k = 0; k < n; ++k) p[k] = values[k][i];
  return parameters_from<Law>({p.data(), n});
}

}  // namespace mixity
