// The residual of one measured point under each objective, with its derivatives. All three follow from the equilibrium
// condition F of mechanics/sensitivity.h.
#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "mechanics/batch.h"
#include "mechanics/equilibrium.h"
#include "mechanics/projection.h"
#include "mechanics/sensitivity.h"

namespace mixity {

/// A measured point and its standard errors, dimensionless.
struct MeasuredPoint {
  double P, T, A, sigma_T, sigma_A;
};

/// Model minus data, and its derivatives in the model's parameters, in what was measured, and in the logarithms of the
/// standard errors (which a change of scale changes).
template <class Model>
struct PointResidual {
  double value = 0;
  Parameters<Model> parameters{};
  double P = 0, T = 0, A = 0, log_sigma_T = 0, log_sigma_A = 0;
};

/// ln f of the model minus ln f of the point, at the point's psi: -ln((y^2 + tau^2)/(6 pi (y + P))). Its standard error
/// follows from r.A and r.T: sigma_A and sigma_T act on it through f and psi at once.
template <class Model>
class ToughnessResiduals {
 public:
  ToughnessResiduals(const Parameters<Model>& p, double P, double) : p_(p), P_(P) {}

  std::optional<PointResidual<Model>> operator()(const MeasuredPoint& point) const {
    const double a = radius_from_area(point.A), y = edge_load(a, P_), sum = y + P_;
    if (!(y > 0)) return std::nullopt;
    const EquilibriumGradient<Model> F = equilibrium_gradient<Model>(p_, P_, point.T, y);
    PointResidual<Model> r;
    r.value = -std::log(F.held / (6 * pi<double>() * sum));
    for (std::size_t k = 0; k < p_.size(); ++k) r.parameters[k] = -F.parameters[k] / F.held;
    // F = held - 6 pi sum, and dsum/dA = 2 a/pi
    const double growth = 2 * a / pi<double>();
    r.A = growth / sum - (F.A + 6 * pi<double>() * growth) / F.held;
    r.T = -F.T / F.held;
    r.P = -F.P / F.held;
    return r;
  }

 private:
  Parameters<Model> p_;
  double P_;
};

/// A of the model at the measured T minus the measured A, in units of its standard error. Beyond the last equilibrium
/// the area at the fold stands for the model's, so that the cost stays continuous.
template <class Model>
class AreaResiduals {
 public:
  AreaResiduals(const Parameters<Model>& p, double P, double) : p_(p), P_(P), contact_(p, P) {}

  std::optional<PointResidual<Model>> operator()(const MeasuredPoint& point) {
    if (!contact_.obstacle().empty() || !contact_.in_contact()) return std::nullopt;
    const Equilibrium equilibrium = contact_.at(point.T);
    if (equilibrium.status == EquilibriumStatus::invalid) return std::nullopt;
    PointResidual<Model> r;
    const bool beyond_fold = equilibrium.status == EquilibriumStatus::no_equilibrium;
    const double A = beyond_fold ? last_area() : area_from_radius(radius_from_edge_load(equilibrium.y, P_));
    r.value = (A - point.A) / point.sigma_A;
    if (beyond_fold) {
      set_fold_slopes(r, point.sigma_A);
    } else {
      const EquilibriumGradient<Model> F = equilibrium_gradient<Model>(p_, P_, point.T, equilibrium.y);
      const double scale = -1 / (F.A * point.sigma_A);
      for (std::size_t k = 0; k < p_.size(); ++k) r.parameters[k] = scale * F.parameters[k];
      r.T = scale * F.T;
      r.P = scale * F.P;
    }
    r.A = -1 / point.sigma_A;
    r.log_sigma_A = -r.value;
    return r;
  }

  /// How many ends of branches the points lie beyond, together. Where this changes with the parameters, a point passes
  /// a fold, and its residual bends.
  std::size_t beyond_ends(std::span<const MeasuredPoint> points) const {
    if (!contact_.obstacle().empty() || !contact_.in_contact()) return 0;
    std::size_t count = 0;
    for (const StableBranch& branch : contact_.branches())
      for (const MeasuredPoint& point : points) count += point.T > branch.T_bottom;
    return count;
  }

  /// The values alone, for many points at once: scans need no derivatives. False where the operator returns null.
  bool values(std::span<const MeasuredPoint> points, std::span<double> residuals) {
    if (!contact_.obstacle().empty() || !contact_.in_contact()) return false;
    T_.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) T_[i] = points[i].T;
    predict_areas(contact_, p_, P_, T_, residuals);
    for (std::size_t i = 0; i < points.size(); ++i) {
      double A = residuals[i];
      if (A == 0) {
        if (!(points[i].T >= 0 && points[i].T <= kLargestLoad)) return false;
        A = last_area();
      }
      residuals[i] = (A - points[i].A) / points[i].sigma_A;
    }
    return true;
  }

 private:
  double last_area() {
    if (!last_area_) last_area_ = area_from_radius(radius_from_edge_load(contact_.branches().back().y_bottom, P_));
    return *last_area_;
  }

  /// dA/dparameter and dA/dP of the last equilibrium itself, once for the load. At a fold R = R_y = 0, so that
  /// R_T dT = -dR and R_yy dy = -(dR_y + R_yT dT) at fixed y and T; R's derivatives in T follow from its homogeneity.
  void set_fold_slopes(PointResidual<Model>& r, double sigma_A) {
    if (!fold_slopes_) {
      fold_slopes_.emplace();
      const StableBranch& last = contact_.branches().back();
      const double y = last.y_bottom, T = last.T_bottom;
      // A = pi (3/4 (y + P))^(2/3)
      const double growth = 2.0 / 3 * last_area() / (y + P_);
      double y_P = 0;  // Hertz's area does not depend on the parameters
      if (last.ends_in_fold) {
        const ShearTerm<double> term = Model::shear_term(p_, y, T);
        const double R_T = (2 * term.value - y * term.d1) / T, R_yT = (term.d1 - y * term.d2) / T, R_yy = 2 + term.d2;
        const auto y_slope = [&](double R, double R_y) { return -(R_y - R_yT * R / R_T) / R_yy; };
        for (std::size_t k = 0; k < p_.size(); ++k) {
          Parameters<Model> low = p_, high = p_;
          const double h = 1e-5 * std::max(std::abs(p_[k]), 1e-3);
          low[k] = std::max(p_[k] - h, Model::parameters[k].lower);
          high[k] = std::min(p_[k] + h, Model::parameters[k].upper);
          const ShearTerm<double> below = Model::shear_term(low, y, T), above = Model::shear_term(high, y, T);
          const double width = high[k] - low[k];
          fold_slopes_->parameters[k] =
              growth * y_slope((above.value - below.value) / width, (above.d1 - below.d1) / width);
        }
        y_P = y_slope(-6 * pi<double>(), 0);
      }
      fold_slopes_->P = growth * (y_P + 1);
    }
    for (std::size_t k = 0; k < p_.size(); ++k) r.parameters[k] = fold_slopes_->parameters[k] / sigma_A;
    r.P = fold_slopes_->P / sigma_A;
  }

  Parameters<Model> p_;
  double P_;
  LoadedContact<Model> contact_;
  std::optional<double> last_area_;  // of the last equilibrium
  std::optional<PointResidual<Model>> fold_slopes_;
  std::vector<double> T_;
};

/// Signed distance of the point from the equilibrium curve in the plane of T and A, each in units of its standard
/// error, positive where the model's area is the larger. The nearest point is found anew for each residual, which
/// eliminates it: by the envelope theorem the derivatives are those of F/|grad F| at that point.
template <class Model>
class CurveResiduals {
 public:
  CurveResiduals(const Parameters<Model>& p, double P, double T_most) : p_(p), P_(P), vertical_(p, P, T_most) {
    const LoadedContact<Model> contact(p, P);
    if (!contact.obstacle().empty() || !contact.in_contact()) return;
    const EquilibriumCurve<Model> curve(p, P);
    level_ = curve.uncoupled();
    projection_.emplace(curve, 2 * T_most);
    ends_at_hertz_ = !level_ && curve.pieces().front().end == CurveEnd::hertz;
    // Only a curve that runs to infinity ends before its points for want of digits.
    if (!level_ && curve.pieces().front().end != CurveEnd::asymptote)
      resolved_to_ = std::numeric_limits<double>::infinity();
  }

  std::optional<PointResidual<Model>> operator()(const MeasuredPoint& point) {
    if (!projection_) return std::nullopt;
    // T is exact, or the curve is level as far as doubles can tell (lambda towards 0): what the distance tends to
    if (!(point.sigma_T > 0) || level_ || point.T > std::max(projection_->last_T(), resolved_to_))
      return vertical_(point);
    const CurvePoint q = projection_->nearest(point.T, point.A, point.sigma_T, point.sigma_A);
    const double x = (q.T - point.T) / point.sigma_T, y = (q.A - point.A) / point.sigma_A, distance = std::hypot(x, y);
    const EquilibriumGradient<Model> F = equilibrium_gradient<Model>(p_, P_, q.T, q.y);
    double n_T = F.T * point.sigma_T, n_A = F.A * point.sigma_A;
    const double size = std::hypot(n_T, n_A);
    if (!(size > 0)) return std::nullopt;  // the vanishing contact at P = 0
    n_T /= size;
    n_A /= size;
    PointResidual<Model> r;
    const double along = x * n_T + y * n_A;
    if (ends_at_hertz_ && projection_->is_end(q) && q.y <= 1e-9 * P_ && distance > 0)
      return from_hertz_end(point, F, x, y, std::copysign(distance, along));
    // Along the normal a rounding of the place on the curve does not show; at an end the offset need not be normal.
    r.value = projection_->is_end(q) ? std::copysign(distance, along) : along;
    for (std::size_t k = 0; k < p_.size(); ++k) r.parameters[k] = -F.parameters[k] / size;
    r.P = -F.P / size;
    r.T = -n_T / point.sigma_T;
    r.A = -n_A / point.sigma_A;
    r.log_sigma_T = -x * n_T;
    r.log_sigma_A = -y * n_A;
    return r;
  }

 private:
  /// The nearest place is Hertz's end, (x, y) standard errors away: its area depends on the load alone, and its T keeps
  /// F = 0 there.
  PointResidual<Model> from_hertz_end(const MeasuredPoint& point, const EquilibriumGradient<Model>& F, double x,
                                      double y, double signed_distance) const {
    const double e_T = x / signed_distance / point.sigma_T, e_A = y / signed_distance / point.sigma_A;
    const double A_P = 0.5 * pi<double>() / hertz_radius(P_);  // 4 a^2 da = dP
    PointResidual<Model> r;
    r.value = signed_distance;
    for (std::size_t k = 0; k < p_.size(); ++k) r.parameters[k] = -e_T * F.parameters[k] / F.T;
    r.P = -e_T * (F.A * A_P + F.P) / F.T + e_A * A_P;
    r.T = -e_T;
    r.A = -e_A;
    r.log_sigma_T = -x * x / signed_distance;
    r.log_sigma_A = -y * y / signed_distance;
    return r;
  }

  Parameters<Model> p_;
  double P_;
  AreaResiduals<Model> vertical_;
  bool ends_at_hertz_ = false;
  bool level_ = false;
  double resolved_to_ = 0;
  std::optional<Projection<Model>> projection_;
};

}  // namespace mixity
