#include <algorithm>
#include <cmath>
#include <limits>

#include "base/input_error.h"
#include "fitting/curve_objective.h"
#include "fitting/energy_objective.h"
#include "fitting/fitted_errors.h"
#include "fitting/prepare.h"
#include "fitting/pull_off_rows.h"
#include "fitting/toughness_objective.h"
#include "fitting/whitening.h"
#include "solver/descent.h"

namespace mixity {
namespace {

/// Whether positions of points matter, or runs have their own constants.
bool places_matter(const PreparedFit& prepared) {
  return (prepared.errors && prepared.errors->runs.any()) || has_changes(prepared.constants) ||
         std::any_of(prepared.fitted.begin(), prepared.fitted.end(),
                     [](const FittedConstant& one) { return is_change(one.constant); });
}

/// Per run: the deviations of its constants from the common ones.
std::vector<PointPlace> constants_of_runs(const Dataset& data, const RunDifferences& runs) {
  std::vector<PointPlace> own(data.curves.size());
  for (std::size_t q = 0; q < runs.names.size(); ++q)
    if (const auto constant = constant_named(runs.names[q]))
      for (std::size_t run = 0; run < own.size(); ++run) own[run].shift(*constant, runs.deviations[q][run]);
  return own;
}

/// The axes of the points. Where their errors are not stated, ln(a/b) has `axes_factor` times the relative error of A:
/// of independent errors of a and b that are equal in share, the same as ln A.
std::vector<MeasuredAxes> measured_axes(const Dataset& data, const PreparedFit& prepared) {
  std::vector<MeasuredAxes> list;
  list.reserve(prepared.used.size());
  for (const std::size_t i : prepared.used) {
    const PointAxes& axes = data.axes[i];
    const double of_A = prepared.errors ? prepared.errors->A[i] / data.points[i].A : 1,
                 factor = prepared.errors ? prepared.errors->axes_factor : 1;
    const bool stated = axes.sigma_q > 0;
    const double sigma_q = stated ? axes.sigma_q : factor * of_A, correlation = stated ? axes.correlation : 0;
    list.push_back({axes.q, sigma_q * std::sqrt(1 - correlation * correlation), correlation * sigma_q / of_A});
  }
  return list;
}

/// The loads that were measured beside a held approach. Where their errors are not stated, they are `axes_factor` times
/// the relative error of A of the largest load.
std::vector<MeasuredAxes> loads_beside(const Dataset& data, const PreparedFit& prepared) {
  std::vector<MeasuredAxes> list;
  double largest = 0;
  for (const std::size_t i : prepared.used)
    if (std::isfinite(data.loads_beside[i].q)) largest = std::max(largest, std::abs(data.loads_beside[i].q));
  for (const std::size_t i : prepared.used) {
    const PointAxes& load = data.loads_beside[i];
    const double share = prepared.errors ? prepared.errors->axes_factor * prepared.errors->A[i] / data.points[i].A : 1;
    list.push_back({load.q, load.sigma_q > 0 ? load.sigma_q : share * largest, 0});
  }
  return list;
}

/// Whether these indices are consecutive points of the data set.
bool are_consecutive(std::span<const std::uint32_t> indices, const PointIndices& used) {
  bool consecutive = used.are_first() && !indices.empty();
  for (std::size_t k = 0; k < indices.size(); ++k) consecutive &= indices[k] == indices[0] + k;
  return consecutive;
}

/// The points' loads and areas; standard errors are 1 if not needed, so that residuals keep their unit. The data set
/// must outlive the result.
MeasuredPoints measured_points(const Dataset& data, const PreparedFit& prepared) {
  struct Source final : PointSource {
    Source(const Dataset& of, std::shared_ptr<const StandardErrors> with, PointIndices which)
        : data(of), errors(std::move(with)), used(std::move(which)) {}
    const Dataset& data;
    std::shared_ptr<const StandardErrors> errors;
    PointIndices used;
    std::optional<PointPlaces> places{};
    std::vector<PointPlace> runs{};
    bool has_near() const { return errors && !errors->place_T.empty(); }
    bool has_places() const override { return places.has_value(); }
    void fill(std::span<const std::uint32_t> indices, const PointArrays& to) const override {
      const bool reversed = !data.shear_reversed.empty(), places_known = has_near();
      const std::size_t n = indices.size();
      const bool consecutive = are_consecutive(indices, used);
      const std::size_t first = consecutive ? indices[0] : 0;
      const auto each = [&](const auto& use) {  // use(k, point)
        if (consecutive)
          for (std::size_t k = 0; k < n; ++k) use(k, first + k);
        else
          for (std::size_t k = 0; k < n; ++k) use(k, used[indices[k]]);
      };
      each([&](std::size_t k, std::size_t i) {
        const Point& point = data.points[i];
        to.P[k] = point.P;
        to.T[k] = reversed ? data.sign_of_shear(point.curve) * point.T : point.T;
        to.A[k] = point.A;
      });
      const auto copy = [&](const std::vector<double>& list, std::span<double> array) {
        if (consecutive)
          std::copy_n(list.data() + first, n, array.data());
        else
          for (std::size_t k = 0; k < n; ++k) array[k] = list[used[indices[k]]];
      };
      const auto set = [&](double value, std::span<double> array) { std::fill_n(array.begin(), n, value); };
      errors ? copy(errors->T, to.sigma_T) : set(1, to.sigma_T);
      errors ? copy(errors->A, to.sigma_A) : set(1, to.sigma_A);
      places_known ? copy(errors->place_T, to.near_T) : set(0, to.near_T);
      places_known ? copy(errors->place_A, to.near_A) : set(0, to.near_A);
    }
    MeasuredPoint at(std::size_t k) const override {
      const std::size_t i = used[k];
      const Point& p = data.points[i];
      MeasuredPoint point{p.P, data.shear_as_read(i), p.A, errors ? errors->T[i] : 1, errors ? errors->A[i] : 1};
      point.run = p.curve;
      if (has_near()) {
        point.near_T = errors->place_T[i];
        point.near_A = errors->place_A[i];
      }
      if (!places) return point;
      point.place = runs.empty() ? PointPlace{} : runs[p.curve];
      const bool fitted = errors && !errors->place_T.empty();
      const PointPlace place = fitted ? places->at(i, errors->place_T[i]) : places->at(i);
      point.place.order = place.order;
      point.place.stretch = place.stretch;
      point.place.unsheared = place.unsheared;
      return point;
    }
  };
  const auto shared = std::make_shared<Source>(data, prepared.errors, prepared.used);
  Source& source = *shared;
  if (places_matter(prepared)) source.places.emplace(data);
  if (prepared.errors && prepared.errors->runs.any()) source.runs = constants_of_runs(data, prepared.errors->runs);
  const std::size_t n = prepared.used.size();
  std::shared_ptr<const std::vector<MeasuredAxes>> axes;
  if (prepared.model.is_elliptic() && !data.axes.empty())
    axes = std::make_shared<const std::vector<MeasuredAxes>>(measured_axes(data, prepared));
  if (prepared.model.holds_approach() && !data.loads_beside.empty())
    axes = std::make_shared<const std::vector<MeasuredAxes>>(loads_beside(data, prepared));
  MeasuredPoints points(n, shared);
  if (n < kManyPoints && source.has_places()) {
    std::vector<MeasuredPoint> list;
    list.reserve(n);
    for (std::size_t k = 0; k < n; ++k) list.push_back(source.at(k));
    points = std::move(list);
  }
  points.axes = std::move(axes);
  if (prepared.objective == Objective::curve && !data.pull_off.empty()) {
    auto list = std::make_shared<std::vector<MeasuredPullOff>>();
    const double common = prepared.errors ? prepared.errors->pull_off : assumed_pull_off_error(data),
                 least = kLeastError * size_of_pull_off(data);
    for (const PullOffReading& one : data.pull_off) list->push_back(measured_pull_off(one, common, least));
    points.pull_off = std::move(list);
  }
  return points;
}

/// Per run: deviations of the model's parameters from the common ones; empty if none differ.
std::vector<ParameterValues> shifts_of_runs(const Dataset& data, const PreparedFit& prepared,
                                            const RunDifferences& runs) {
  std::vector<ParameterValues> shifts;
  const auto infos = prepared.model.parameters();
  for (std::size_t q = 0; q < runs.names.size(); ++q)
    for (std::size_t k = 0; k < infos.size(); ++k) {
      if (infos[k].name != runs.names[q]) continue;
      shifts.resize(data.curves.size(), ParameterValues::zeros(infos.size()));
      for (std::size_t run = 0; run < shifts.size(); ++run) shifts[run][k] = runs.deviations[q][run];
    }
  return shifts;
}

/// Points corrected by the constants that are not fitted, with ratios to the data set's own toughness.
std::vector<ToughnessPoint> toughness_points(const Dataset& data, const PreparedFit& prepared) {
  const Scales scales(data, prepared.constants);
  const double own = data.has_loads ? std::exp(prepared.constants[kToughness]) : 1;
  std::vector<ToughnessPoint> points;
  points.reserve(prepared.used.size());
  for (const std::size_t i : prepared.used) {
    points.push_back(*data.toughness(i, scales.of(i)));
    points.back().ratio *= own;
  }
  return points;
}

FreeChoice choice_of_model(const PreparedFit& prepared) {
  FreeChoice choice(prepared.model, {prepared.base, prepared.constants}, prepared.held);
  if (prepared.poisson_error > 0)
    choice.state(kPoissonRatio, prepared.base[prepared.base.size() - 1], prepared.poisson_error);
  return choice;
}

/// The model's free parameters and the fitted constants, with ranges: factors of a thousand, offsets of load and shear
/// up to ten times the largest, of areas up to nine tenths of the smallest.
FreeChoice free_choice(const Dataset& data, const PreparedFit& prepared) {
  FreeChoice choice = choice_of_model(prepared);
  const LargestPullOff of_pull_off = largest_pull_off(data);
  double largest_load = std::max(1.0, of_pull_off.load), largest_shear = std::max(1.0, of_pull_off.shear),
         smallest_area = prepared.used.empty() ? 1 : std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < (prepared.fitted.empty() ? 0 : prepared.used.size()); ++k) {
    const std::size_t i = prepared.used[k];
    largest_load = std::max(largest_load, std::abs(data.points[i].P));
    largest_shear = std::max(largest_shear, data.points[i].shear());
    smallest_area = std::min(smallest_area, data.points[i].A);
  }
  double largest_force = largest_load;
  if (data.holds_approach())
    for (const PointAxes& load : data.loads_beside) largest_force = std::fmax(largest_force, std::abs(load.q));
  const double factor = std::log(1000.0);
  for (const auto& [constant, mean, prior] : prepared.fitted) {
    const double reach = is_factor(constant)       ? factor
                         : is_change(constant)     ? 1
                         : constant == kAreaOffset ? 0.9 * smallest_area
                         : constant == kLoadOffset ? 10 * largest_force
                                                   : 10 * (constant == kShearOffset ? largest_shear : largest_load);
    const double start = prepared.start.empty() ? mean : prepared.start[choice.constants().size()];
    const auto [scale, unit] = unit_of(data, constant);
    choice.add(constant, {std::string(kConstantNames[constant]), mean - reach, mean + reach, start, scale,
                          is_factor(constant), unit, prior});
  }
  return choice;
}

/// Standard errors of ln f (or f, divided by f) minus the model's, from those of T and A.
std::vector<double> errors_of_loads(const Dataset& data, Scale scale, const PreparedFit& prepared,
                                    std::span<const double> p) {
  const PointIndices& used = prepared.used;
  const std::size_t n = used.size();
  std::vector<double> P, T, A, value(n), by_P(n), by_T(n), by_A(n), by_parameter(n * p.size()), found;
  const Scales scales(data, prepared.constants);
  for (const std::size_t i : used) {
    const Point point = data.corrected(i, scales.of(i));
    P.push_back(point.P);
    T.push_back(point.shear());
    A.push_back(point.A);
  }
  prepared.model.toughness_residuals(p, P, T, A, {value, by_P, by_T, by_A, by_parameter});
  for (std::size_t i = 0; i < n; ++i) {
    if (scale == Scale::linear) {
      // d(f_model - f) = f_model d(ln f_model - ln f) + (f_model - f) d(ln f), here over f
      const double a = radius_from_area(A[i]), y = edge_load(a, P[i]), y_A = 2 * a / pi<double>();
      const double square = y * y + T[i] * T[i], growth = std::expm1(value[i]);
      by_T[i] = (1 + growth) * by_T[i] + growth * 2 * T[i] / square;
      by_A[i] = (1 + growth) * by_A[i] + growth * y_A * (2 * y / square - 1 / (y + P[i]));
    }
    const ConstantsScale constants = scales.of(used[i]);
    found.push_back(std::hypot(by_T[i] * constants.shear_force * prepared.errors->T[used[i]],
                               by_A[i] * constants.area * prepared.errors->A[used[i]]));
  }
  return found;
}

}  // namespace

std::unique_ptr<ModelProblem> make_problem(const Dataset& data, const FitOptions& options, const PreparedFit& prepared,
                                           std::vector<double> weights) {
  const bool weighted = prepared.objective == Objective::curve || !weights.empty();
  std::unique_ptr<ModelProblem> problem;
  if (prepared.objective == Objective::curve && data.has_energies) {
    const std::vector<EnergyPoint> points = energy_points(data, prepared.used);
    std::vector<FreeParameter> toughness;
    if (!prepared.fitted.empty()) toughness = series_toughness(data, points, prepared.used, prepared.fitted[0].prior);
    problem = std::make_unique<EnergyObjective>(points, choice_of_model(prepared), toughness);
  } else if (prepared.objective == Objective::curve) {
    const StandardErrors none, &errors = prepared.errors ? *prepared.errors : none;
    // Of millions of points the list in the errors serves as it is.
    const bool share = prepared.used.size() >= kManyPoints && prepared.used.are_all(errors.expected.size()) &&
                       options.by_run.empty() && !errors.runs.any() && !errors.correlations.any();
    auto objective = std::make_unique<CurveObjective>(
        measured_points(data, prepared), free_choice(data, prepared),
        share ? std::vector<double>() : taken_off(data, prepared.used, errors),
        whitening_of(data, prepared.used, errors), shifts_of_runs(data, prepared, errors.runs));
    if (share) objective->share_expected({prepared.errors, &errors.expected});
    problem = std::move(objective);
  } else if (!prepared.fitted.empty() && data.has_loads) {
    problem = std::make_unique<ToughnessOfLoads>(measured_points(data, prepared), free_choice(data, prepared),
                                                 std::move(weights));
  } else {
    problem = std::make_unique<ToughnessObjective>(toughness_points(data, prepared), scale_of(options),
                                                   free_choice(data, prepared), std::move(weights));
  }
  // a file of psi and Gc can only be weighted by its sigma_Gc
  const bool energies_without = data.has_energies && data.errors.empty();
  const bool absolute =
      !prepared.errors || (prepared.used.empty() && !data.pull_off.empty() ? without_pull_off_error(data) == 0
                                                                           : prepared.errors->absolute());
  problem->set_known_errors(weighted && !energies_without && absolute && !options.free_sigma_factor);
  return problem;
}

std::vector<double> toughness_weights(const Dataset& data, const FitOptions& options, const PreparedFit& prepared,
                                      std::span<const double> p) {
  const Scale scale = scale_of(options);
  if (!data.has_loads && data.errors.empty())
    throw InputError(data.path, "needs a column " +
                                    std::string(data.has_energies ? "sigma_GI or sigma_GII" : "sigma_Gc") +
                                    " to weigh its points by");
  std::vector<double> of_loads, weights;
  if (data.has_loads) of_loads = errors_of_loads(data, scale, prepared, p);
  const std::vector<ToughnessPoint> points = toughness_points(data, prepared);
  for (const std::size_t i : prepared.used) {
    const double ratio = points[weights.size()].ratio;
    const double error = data.has_loads ? of_loads[weights.size()] : data.errors_of(i).ratio / ratio;
    if (!(error > 0))
      refuse_value(data, data.points[i], data.has_energies ? "sigma_GI" : "sigma_Gc",
                   data.has_energies ? "this point has no standard error (sigma_GI and sigma_GII are 0 or empty)"
                                     : "this point has no standard error (sigma_Gc is 0 or empty)");
    weights.push_back(1 / (scale == Scale::log ? error : error * ratio));
  }
  return weights;
}

std::vector<double> jkr_start(const Dataset& data, const FitOptions& options, const PreparedFit& prepared) {
  std::vector<double> start;
  for (const FittedConstant& constant : prepared.fitted) start.push_back(constant.mean);
  double largest = 0, pull = 0;
  const Scales scales(data, prepared.constants);
  for (const std::size_t i : prepared.used) {
    const Point point = data.corrected(i, scales.of(i));
    largest = std::max(largest, point.shear());
    pull = std::max(pull, -point.P);
  }
  const std::size_t free = options.free.size();
  // if a load is below pull-off, a toughness at which the lowest load is 0.85 of pull-off
  for (std::size_t k = 0; k < free; ++k)
    if (options.free[k] == kToughness && !data.holds_approach() && above_pull_off(-pull) < 0)
      start[k] = std::log(pull / 4);
  PreparedFit unsheared = prepared;
  unsheared.objective = Objective::curve;
  std::fill(unsheared.held.begin(), unsheared.held.end(), true);
  unsheared.fitted.clear();
  std::vector<std::size_t> told;  // the free ones; the others have no effect without shear
  for (std::size_t k = 0; k < free; ++k)
    if (options.free[k] != kShape && options.free[k] != kShearOffset) {
      told.push_back(k);
      unsheared.fitted.push_back(prepared.fitted[k]);
    }
  unsheared.used = PointIndices();
  for (const std::size_t i : prepared.used)
    if (!(data.corrected(i, scales.of(i)).shear() > 0.01 * largest)) unsheared.used.push_back(i);
  if (told.empty() || unsheared.used.size() < told.size()) return start;
  SolverOptions solver;
  solver.engine = Engine::kernel;
  std::vector<double> begin;
  for (const std::size_t k : told) begin.push_back(start[k]);
  const auto minimum = descend(*make_problem(data, options, unsheared), begin, solver);
  if (minimum && minimum->stationary)
    for (std::size_t i = 0; i < told.size(); ++i) start[told[i]] = minimum->x[i];
  return start;
}

std::vector<double> solver_values(const Problem& problem, const std::vector<FittedParameter>& fitted) {
  std::vector<double> x;
  for (const FreeParameter& parameter : problem.parameters()) {
    const FittedParameter* const same = find_parameter(fitted, parameter.name);
    if (same && same->value)
      x.push_back(parameter.clamped(parameter.solver_value(*same->value)));
    else if (parameter.start)
      x.push_back(*parameter.start);
    else
      return {};
  }
  return x;
}

}  // namespace mixity
