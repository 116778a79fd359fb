#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "dataset/display_units.h"
#include "fitting/predicted_curves.h"
#include "report/figures/data_figures.h"

namespace mixity {
namespace {

/// One data set's area figures share its points, curves and axes.
class AreaFigures {
 public:
  explicit AreaFigures(const ReportedData& reported)
      : reported_(reported),
        data_(reported.result.data),
        units_(data_),
        runs_(reported.figured.runs),
        points_(points_by_curve(data_)),
        models_(reported.figured.models) {}

  std::vector<Figure> draw() const {
    std::vector<Figure> figures;
    if (models_.size() > 1) figures.push_back(all_models());
    for (const ModelCurves& model : models_) figures.push_back(one_model(model));
    return figures;
  }

 private:
  static constexpr double kMargin = 1.05;  // of the largest T: the axis beyond it

  /// Where the contacts of a model jump under load control, with the run's place among those shown.
  std::vector<std::pair<std::size_t, double>> jumps(const ModelCurves& model) const {
    std::vector<std::pair<std::size_t, double>> list;
    for (std::size_t k = 0; k < runs_.size(); ++k)
      for (const DrawnFold& fold : model.areas[k].folds)
        if (fold.control == Control::Kind::load) list.emplace_back(k, fold.T);
    return list;
  }

  /// The axis holds the data and the jumps of a model that leave the data half of the width.
  double widest() const { return kWidestArea * reported_.figured.T_data * units_.force; }
  double axis(const ModelCurves& model) const {
    double end = kMargin * reported_.figured.T_data * units_.force;
    for (const auto& [k, T] : jumps(model))
      if (kMargin * T <= widest()) end = std::max(end, kMargin * T);
    return end;
  }

  /// Where the jumps are that the axis does not hold.
  std::string jumps_beyond(const ModelCurves& model) const {
    std::string text;
    for (const auto& [k, T] : jumps(model))
      if (kMargin * T > widest())
        text += (text.empty() ? " Beyond the frame the contact jumps, under load control, at T = " : ", ") +
                with_unit(T, 4, units_.force_unit) +
                " (P = " + with_unit(data_.curve_loads[runs_[k]] * units_.force, 4, units_.force_unit) + ")";
    return text.empty() ? text : text + ".";
  }

  Figure empty(const std::string& name, const std::string& title, const ModelCurves& model) const {
    Figure figure{reported_.stem + name, title, {units_.T(), 0.0, axis(model)}, {units_.A(), 0.0, {}}, {}};
    figure.key_title = units_.P();
    figure.wide = true;
    figure.key_place = KeyPlace::beside;
    return figure;
  }

  Series measured(std::size_t k) const {
    const std::size_t run = runs_[k];
    Series series{rounded(data_.curve_loads[run] * units_.force, 4), Look::circles, color(k), {}};
    const auto& errors = reported_.result.fits.front().errors;
    for (const std::size_t i : shown_points(points_[run], runs_.size())) {
      const Point& point = data_.points[i];
      const double T = point.shear() * units_.force, A = point.A * units_.area;
      series.points.emplace_back(T, A);
      series.hover.push_back(point_hover(data_, i));
      if (!errors) continue;
      const double dT = errors->T[i] * units_.force, dA = errors->A[i] * units_.area;
      series.bars.push_back({T - dT, T + dT, A - dA, A + dA});
    }
    return series;
  }

  Figure all_models() const {
    Figure figure = empty("_area_models", "Contact area against tangential load, all models", models_.front());
    for (std::size_t k = 0; k < runs_.size(); ++k) figure.series.push_back(measured(k));
    for (const ModelCurves& model : models_) {
      const Look look = model_line(model.fit->model);
      figure.key.emplace_back("model " + model.fit->model, look);
      for (std::size_t k = 0; k < runs_.size(); ++k) {
        Series line{"", look, color(k), {}};
        for (const DrawnPoint& q : model.areas[k].points) {
          if (!q.stable) break;
          line.points.emplace_back(q.T, q.A);
        }
        figure.series.push_back(std::move(line));
      }
    }
    figure.caption =
        "Measured areas and the stable branch of every model at its fitted parameters; a line that ends "
        "within the frame ends where the contact jumps." +
        unshown();
    return figure;
  }

  /// How many runs and points of them are left out of the picture.
  std::string unshown() const {
    std::size_t all = 0, shown = 0;
    for (const std::size_t run : runs_) {
      all += points_[run].size();
      shown += shown_points(points_[run], runs_.size()).size();
    }
    const std::string runs =
        runs_.size() < data_.curves.size()
            ? " " + std::to_string(runs_.size()) + " of " + std::to_string(data_.curves.size()) + " runs are shown."
            : "";
    return runs + shown_note(shown, all);
  }

  Figure one_model(const ModelCurves& model) const {
    const std::string& key = model.fit->model;
    Figure figure = empty("_area_" + key, "Contact area against tangential load, model " + key, model);
    const bool bands = !model.area_band.empty();
    for (std::size_t k = 0; k < model.area_band.size(); ++k) {  // one polygon each
      const auto& [low, high] = model.area_band[k];
      Series band{"", Look::band, color(k), {}};
      for (const DrawnPoint& q : low.points) band.points.emplace_back(q.T, q.A);
      for (auto q = high.points.rbegin(); q != high.points.rend(); ++q) band.points.emplace_back(q->T, q->A);
      figure.series.push_back(std::move(band));
    }
    Series load{"", Look::triangles, "#000000", {}}, displacement{"", Look::diamonds, "#000000", {}};
    for (std::size_t k = 0; k < runs_.size(); ++k) {
      figure.series.push_back(measured(k));
      Series stable{"", Look::solid, color(k), {}}, unstable{"", Look::dashed, color(k), {}};
      for (const DrawnPoint& q : model.areas[k].points) {
        if (!q.stable && unstable.points.empty() && !stable.points.empty())
          unstable.points.push_back(stable.points.back());
        (q.stable ? stable : unstable).points.emplace_back(q.T, q.A);
      }
      figure.series.push_back(std::move(stable));
      figure.series.push_back(std::move(unstable));
      for (const DrawnFold& fold : model.areas[k].folds) add_fold(fold, k, load, displacement);
    }
    figure.key = {{"stable", Look::solid}, {"unstable", Look::dashed}};
    if (!load.points.empty()) figure.key.emplace_back("jump, load controlled", Look::triangles);
    if (!displacement.points.empty()) figure.key.emplace_back("jump, displacement controlled", Look::diamonds);
    figure.series.push_back(std::move(load));
    figure.series.push_back(std::move(displacement));
    const bool strength = add_strength(figure);
    figure.caption = "Equilibrium curves of model " + key + " at its fitted parameters" +
                     (bands ? ", bands for the ends of the interval" : "") +
                     "; open triangles and diamonds mark where the contact jumps under load and displacement control" +
                     (strength ? "; below the dotted line T > τ0 A, and the interface slides" : "") + "." +
                     jumps_beyond(model) + unshown();
    return figure;
  }

  void add_fold(const DrawnFold& fold, std::size_t k, Series& load, Series& displacement) const {
    const bool by_load = fold.control == Control::Kind::load;
    Series& series = by_load ? load : displacement;
    series.points.emplace_back(fold.T, fold.A);
    series.hover.push_back(std::string("jump under ") + (by_load ? "load" : "displacement") + " control at P = " +
                           with_unit(data_.curve_loads[runs_[k]] * units_.force, 4, units_.force_unit) + ": T = " +
                           with_unit(fold.T, 5, units_.force_unit) + ", A = " + with_unit(fold.A, 5, units_.area_unit) +
                           ", u = " + with_unit(fold.u, 4, units_.displacement_unit) + ", to " + fold.jumps_to);
  }

  bool add_strength(Figure& figure) const {
    const auto strength = stated_strength(data_);
    if (!strength) return false;
    const double T_axis = *figure.x.high,
                 tau0 = *strength * units_.force / units_.area;  // T = tau0 A in the drawn units
    figure.series.push_back({"sliding, T = τ_0 A", Look::dotted, "#000000", {{0, 0}, {T_axis, T_axis / tau0}}});
    double largest = 0;
    for (const Point& point : data_.points) largest = std::max(largest, point.A * units_.area);
    figure.y.high = 1.1 * largest;
    return true;
  }

  const ReportedData& reported_;
  const Dataset& data_;
  DrawnUnits units_;
  const std::vector<std::size_t>& runs_;
  std::vector<std::vector<std::size_t>> points_;  // by run
  const std::vector<ModelCurves>& models_;
};

}  // namespace

std::vector<Figure> area_figures(const ReportedData& reported) {
  if (!reported.result.data.has_loads || reported.result.data.points.empty()) return {};
  return AreaFigures(reported).draw();
}

}  // namespace mixity
