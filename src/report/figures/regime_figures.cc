#include <algorithm>
#include <array>
#include <cmath>
#include <list>

#include "dataset/number_text.h"
#include "mechanics/regimes.h"
#include "report/figures/data_figures.h"
#include "report/figures/drawn_units.h"
#include "report/figures/model_curves.h"

namespace mixity {
namespace {

constexpr std::size_t kColumns = 96, kRows = 64;
constexpr int kHalvings = 12;  // of a row: boundaries come out smooth

const char* regime_text(Regime regime) {
  switch (regime) {
    case Regime::asymptote:
      return "1 shrinks, never to Hertz";
    case Regime::hertz:
      return "2 shrinks to Hertz";
    case Regime::jump:
      return "3 jumps";
    case Regime::strength:
      break;
  }
  return "4 slides first";
}

/// A regime's extent at one load, as parts 0..1 of the axis of lambda.
struct Extent {
  Regime regime;
  double low, high;
};

template <class Classify>
std::vector<Extent> extents(const Classify& classify_at) {
  std::vector<Extent> column{{classify_at(0), 0, 0}};
  for (std::size_t j = 1; j <= kRows; ++j) {
    const double part = static_cast<double>(j) / kRows;
    const Regime here = classify_at(part);
    if (here == column.back().regime) continue;
    double low = static_cast<double>(j - 1) / kRows, high = part;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (low + high);
      (classify_at(middle) == column.back().regime ? low : high) = middle;
    }
    column.back().high = high;
    column.push_back({here, high, 0});
  }
  column.back().high = 1;
  return column;
}

/// One connected region of the map: its lower and upper boundary from left to right.
struct Region {
  Regime regime;
  std::vector<std::pair<double, double>> lower, upper;  // (load, part)
  Extent last;
  bool open = true;
};

/// Extents of neighbouring loads belong together where they overlap.
std::list<Region> regions(const std::vector<double>& loads, const std::vector<std::vector<Extent>>& columns) {
  std::list<Region> all;
  const double half = 0.5 * (loads[1] - loads[0]);
  for (std::size_t i = 0; i < loads.size(); ++i) {
    std::vector<Region*> grown;
    for (const Extent& extent : columns[i]) {
      const auto found = std::find_if(all.begin(), all.end(), [&](const Region& region) {
        return region.open && region.regime == extent.regime && region.last.low < extent.high &&
               extent.low < region.last.high && std::find(grown.begin(), grown.end(), &region) == grown.end();
      });
      Region& region = found != all.end() ? *found : all.emplace_back(Region{extent.regime, {}, {}, extent});
      if (region.lower.empty() && i > 0) {  // begins between two columns
        region.lower.emplace_back(loads[i] - half, extent.low);
        region.upper.emplace_back(loads[i] - half, extent.high);
      }
      region.lower.emplace_back(loads[i], extent.low);
      region.upper.emplace_back(loads[i], extent.high);
      region.last = extent;
      grown.push_back(&region);
    }
    for (Region& region : all)
      if (region.open && std::find(grown.begin(), grown.end(), &region) == grown.end()) {
        region.open = false;
        region.lower.emplace_back(loads[i] - half, region.last.low);
        region.upper.emplace_back(loads[i] - half, region.last.high);
      }
  }
  return all;
}

template <class Model>
class RegimeMap {
 public:
  RegimeMap(const ReportedData& reported, const FitResult& fit)
      : reported_(reported), data_(reported.result.data), units_(data_), lambda_(fit.parameters.front()), fit_(fit) {
    const ParameterInfo& info = Model::parameters[0];
    const auto [least, most] = std::minmax_element(data_.curve_loads.begin(), data_.curve_loads.end());
    const double margin = 0.1 * (*most - *least) + 0.5;
    P_low_ = std::max(*least - margin, -1.5 * pi<double>() * 0.999);
    P_high_ = *most + margin;
    last_ = info.upper;
    logarithmic_ = *lambda_.value > 0 && *lambda_.value < 0.05 * last_;  // 0 has no place on a logarithmic axis
    first_ = logarithmic_ ? std::max(0.1 * *lambda_.value, 1e-6) : info.lower;
    tau0_ = stated_strength(data_);
  }

  /// Null, and why it is left out, if the map is one regime.
  std::optional<Figure> draw(std::vector<MissingFigure>& left_out) const {
    Figure figure{reported_.stem + "_regimes_" + fit_.model,
                  "What becomes of the contact over load and lambda, model " + fit_.model,
                  {units_.P(), P_low_ * units_.force, P_high_ * units_.force},
                  {"λ", first_, last_, logarithmic_},
                  {}};
    std::vector<double> loads;
    std::vector<std::vector<Extent>> columns;
    for (std::size_t i = 0; i <= kColumns; ++i) {
      loads.push_back(P_low_ + (P_high_ - P_low_) * static_cast<double>(i) / kColumns);
      columns.push_back(extents([&](double part) { return regime(lambda_at(part), loads.back()); }));
    }
    static constexpr std::array<std::size_t, 4> kTint{6, 3, 1, 7};
    std::array<bool, 5> named{};
    const std::list<Region> all = regions(loads, columns);
    if (all.size() == 1) {
      left_out.push_back({"regime map of model " + fit_.model,
                          "one regime everywhere: " + std::string(regime_text(all.front().regime)).substr(2)});
      return std::nullopt;
    }
    for (const Region& region : all) {
      const auto number = static_cast<std::size_t>(region.regime);
      Series series{named[number] ? "" : regime_text(region.regime), Look::band, color(kTint[number - 1]), {}};
      named[number] = true;
      const auto add = [&](const std::pair<double, double>& place) {
        series.points.emplace_back(place.first * units_.force, lambda_at(place.second));
      };
      std::for_each(region.lower.begin(), region.lower.end(), add);
      std::for_each(region.upper.rbegin(), region.upper.rend(), add);
      figure.series.push_back(std::move(series));
    }
    figure.series.push_back(data_loads());
    figure.caption = "Regimes of model " + fit_.model + (tau0_ ? " with the stated shear strength" : "") +
                     "; symbols are the data's loads at the fitted lambda.";
    return figure;
  }

 private:
  double lambda_at(double part) const {
    return logarithmic_ ? first_ * std::pow(last_ / first_, part) : first_ + (last_ - first_) * part;
  }
  Regime regime(double lambda, double P) const { return classify<Model>({std::min(lambda, last_)}, P, tau0_).regime; }

  Series data_loads() const {
    Series loads{"these data", model_symbol(fit_.model), color(0), {}};
    const auto& interval = lambda_.interval;
    for (std::size_t run = 0; run < data_.curves.size(); ++run) {
      const double P = data_.curve_loads[run] * units_.force;
      loads.points.emplace_back(P, *lambda_.value);
      loads.bars.push_back({P, P, interval && interval->low ? std::max(*interval->low, first_) : *lambda_.value,
                            interval && interval->high ? *interval->high : *lambda_.value});
      loads.hover.push_back("run " + data_.curves[run] + ": P = " + with_unit(P, 4, units_.force_unit) + ", " +
                            regime_text(regime(*lambda_.value, data_.curve_loads[run])));
    }
    return loads;
  }

  const ReportedData& reported_;
  const Dataset& data_;
  DrawnUnits units_;
  const FittedParameter& lambda_;
  const FitResult& fit_;
  double P_low_, P_high_, first_, last_;
  bool logarithmic_;
  std::optional<double> tau0_;
};

}  // namespace

std::vector<Figure> regime_figures(const ReportedData& reported, std::vector<MissingFigure>& left_out) {
  std::vector<Figure> figures;
  if (!reported.result.data.has_loads || reported.result.data.curve_loads.empty()) return figures;
  for (const FitResult* fit : fits_with_values(reported.result))
    with_model(fit->model, [&](auto chosen) {
      using Model = decltype(chosen);
      if constexpr (parameter_count<Model> == 1)
        if (auto figure = RegimeMap<Model>(reported, *fit).draw(left_out)) figures.push_back(std::move(*figure));
    });
  return figures;
}

}  // namespace mixity
