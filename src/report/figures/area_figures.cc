#include <algorithm>

#include "base/number_text.h"
#include "base/phrases.h"
#include "dataset/display_units.h"
#include "fitting/predicted_curves.h"
#include "report/figures/data_figures.h"

namespace mixity {
namespace {

constexpr double kPastLargestT = 1.05;  // the axis of T ends at this multiple of the largest T

Points areas(const std::vector<DrawnPoint>& curve) {
  Points points;
  for (const DrawnPoint& q : curve) points.emplace_back(q.T, q.A);
  return points;
}

/// The area figures of one data set, which share points and axes.
class AreaFigures {
 public:
  explicit AreaFigures(const ReportedData& reported) : reported_(reported), data_(reported.result.data), units_(data_) {
    for (std::size_t k = 0; k < runs_.size(); ++k) measured_.push_back(measured(k));
  }

  std::vector<Figure> draw() const {
    std::vector<Figure> figures;
    if (reported_.figured.models.size() > 1) figures.push_back(all_models());
    for (const ModelCurves& model : reported_.figured.models) figures.push_back(one_model(model));
    return figures;
  }

 private:
  std::string load_text(std::size_t k) const {
    return (data_.holds_approach() ? "δ = " : "P = ") +
           with_unit(data_.curve_loads[runs_[k]] * units_.held, 4, units_.held_unit);
  }

  Series measured(std::size_t k) {
    const std::size_t run = runs_[k];
    Series series{rounded(data_.curve_loads[run] * units_.held, 4), Look::circles, color(k)};
    const auto& errors = reported_.result.fits.front().errors;
    const std::vector<std::size_t> shown = shown_points(points_[run], runs_.size());
    all_points_ += points_[run].size();
    points_shown_ += shown.size();
    for (const std::size_t i : shown) {
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

  /// The axes include the data and the model's jumps under load control, as long as the data cover half of the width.
  /// The caption names the jumps beyond.
  Figure empty(const std::string& name, const std::string& title, const ModelCurves& model) const {
    const double T_data = reported_.figured.T_data;
    double end = kPastLargestT * T_data * units_.force;
    std::vector<std::string> beyond;
    for (std::size_t k = 0; k < runs_.size(); ++k)
      for (const DrawnFold& fold : model.areas[k].folds) {
        if (fold.control != Control::Kind::load) continue;
        if (kPastLargestT * fold.T <= kWidestArea * T_data * units_.force)
          end = std::max(end, kPastLargestT * fold.T);
        else
          beyond.push_back(with_unit(fold.T, 4, units_.force_unit) + " (" + load_text(k) + ")");
      }
    const std::string jumps = joined(beyond, ", ", " Beyond the frame the contact jumps, under load control, at T = ");
    return {.name = reported_.stem + name,
            .title = title,
            .x = {units_.T(), 0.0, end},
            .y = {units_.A(), 0.0, {}},
            .key_place = KeyPlace::beside,
            .key_title = units_.P(),
            .wide = true,
            .caption = jumps.empty() ? jumps : jumps + "."};
  }

  Figure all_models() const {
    const std::vector<ModelCurves>& models = reported_.figured.models;
    Figure figure = empty("_area_models", "Contact area against tangential load, all models", models.front());
    figure.series = measured_;
    for (const ModelCurves& model : models) {
      const Look look = model_line(model.fit->model);
      figure.key.emplace_back("model " + model.fit->model, look);
      for (std::size_t k = 0; k < runs_.size(); ++k) {
        const std::vector<DrawnPoint>& curve = model.areas[k].points;
        const auto end = std::find_if(curve.begin(), curve.end(), [](const DrawnPoint& q) { return !q.stable; });
        figure.series.push_back({"", look, color(k), areas({curve.begin(), end})});
      }
    }
    figure.caption =
        "Measured areas and the stable branch of every model at its fitted parameters; a line that ends "
        "within the frame ends where the contact jumps." +
        unshown();
    return figure;
  }

  /// The numbers of runs and points that the figures leave out.
  std::string unshown() const {
    const std::string runs =
        runs_.size() < data_.curves.size()
            ? " " + std::to_string(runs_.size()) + " of " + std::to_string(data_.curves.size()) + " runs are shown."
            : "";
    return runs + shown_note(points_shown_, all_points_);
  }

  Figure one_model(const ModelCurves& model) const {
    const std::string& key = model.fit->model;
    Figure figure = empty("_area_" + key, "Contact area against tangential load, model " + key, model);
    for (std::size_t k = 0; k < model.area_band.size(); ++k) {
      const auto& [low, high] = model.area_band[k];
      figure.series.push_back(band("", color(k), areas(low.points), areas(high.points)));
    }
    Series load{"", Look::triangles, color(0)}, displacement{"", Look::diamonds, color(0)};
    for (std::size_t k = 0; k < runs_.size(); ++k) {
      figure.series.push_back(measured_[k]);
      Series stable{"", Look::solid, color(k)}, unstable{"", Look::dashed, color(k)};
      for (const DrawnPoint& q : model.areas[k].points) {
        if (!q.stable && unstable.points.empty() && !stable.points.empty())
          unstable.points.push_back(stable.points.back());
        (q.stable ? stable : unstable).points.emplace_back(q.T, q.A);
      }
      figure.series.push_back(std::move(stable));
      figure.series.push_back(std::move(unstable));
      for (const DrawnFold& fold : model.areas[k].folds)
        add_fold(fold, k, fold.control == Control::Kind::load ? load : displacement);
    }
    figure.key = {{"stable", Look::solid}, {"unstable", Look::dashed}};
    if (!load.points.empty()) figure.key.emplace_back("jump, load controlled", Look::triangles);
    if (!displacement.points.empty()) figure.key.emplace_back("jump, displacement controlled", Look::diamonds);
    figure.series.push_back(std::move(load));
    figure.series.push_back(std::move(displacement));
    const bool strength = add_strength(figure);
    figure.caption = "Equilibrium curves of model " + key + " at its fitted parameters" +
                     (model.area_band.empty() ? "" : ", bands for the ends of the interval") +
                     "; open triangles and diamonds mark where the contact jumps under load and displacement control" +
                     (strength ? "; below the dotted line T > τ0 A, and the interface slides" : "") + "." +
                     figure.caption + unshown();
    return figure;
  }

  void add_fold(const DrawnFold& fold, std::size_t k, Series& series) const {
    series.points.emplace_back(fold.T, fold.A);
    series.hover.push_back("jump under " + std::string(to_string(fold.control)) + " control at " + load_text(k) +
                           ": T = " + with_unit(fold.T, 5, units_.force_unit) +
                           ", A = " + with_unit(fold.A, 5, units_.area_unit) +
                           ", u = " + with_unit(fold.u, 4, units_.displacement_unit) + ", to " + fold.jumps_to);
  }

  /// Adds the line of sliding. False if no strength is stated.
  bool add_strength(Figure& figure) const {
    const auto strength = stated_strength(data_);
    if (!strength) return false;
    const double T_axis = *figure.x.high,
                 tau0 = *strength * units_.force / units_.area;  // T = tau0 A in the drawn units
    figure.series.push_back({"sliding, T = τ_0 A", Look::dotted, color(0), {{0, 0}, {T_axis, T_axis / tau0}}});
    double largest = 0;
    for (const Point& point : data_.points) largest = std::max(largest, point.A * units_.area);
    figure.y.high = 1.1 * largest;
    return true;
  }

  const ReportedData& reported_;
  const Dataset& data_;
  DrawnUnits units_;
  const std::vector<std::size_t>& runs_ = reported_.figured.runs;
  std::vector<std::vector<std::size_t>> points_ = points_by_curve(data_);  // by run
  std::vector<Series> measured_{};                                         // per shown run
  std::size_t points_shown_ = 0, all_points_ = 0;
};

}  // namespace

std::vector<Figure> area_figures(const ReportedData& reported) {
  if (!reported.result.data.has_loads || reported.result.data.points.empty()) return {};
  return AreaFigures(reported).draw();
}

}  // namespace mixity
