#include <algorithm>
#include <array>
#include <cmath>

#include "base/number_text.h"
#include "dataset/display_units.h"
#include "fitting/predicted_area.h"
#include "fitting/predicted_curves.h"
#include "mechanics/regime_map.h"
#include "report/figures/data_figures.h"

namespace mixity {
namespace {

constexpr std::size_t kColumns = 96;

class RegimeMap {
 public:
  RegimeMap(const ReportedData& reported, const ContactModel& model, const FitResult& fit)
      : reported_(reported),
        data_(reported.result.data),
        units_(data_),
        lambda_(fit.parameters.front()),
        model_(model),
        fit_(fit) {
    const ParameterInfo& info = model.parameters()[0];
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
    for (std::size_t i = 0; i <= kColumns; ++i)
      loads.push_back(P_low_ + (P_high_ - P_low_) * static_cast<double>(i) / kColumns);
    static constexpr std::array<std::size_t, 4> kTint{6, 3, 1, 7};
    std::array<bool, 5> named{};
    const std::vector<RegimeRegion> all =
        regime_regions(loads, [&](double part, double P) { return regime(lambda_at(part), P).value(); });
    if (all.size() == 1) {
      left_out.push_back({"regime map of model " + fit_.model,
                          "one regime everywhere: " + std::string(regime_text(*all.front().regime)).substr(2)});
      return std::nullopt;
    }
    for (const RegimeRegion& region : all) {
      const auto number = static_cast<std::size_t>(*region.regime);
      Series series{named[number] ? "" : regime_text(*region.regime), Look::band, color(kTint[number - 1]), {}};
      named[number] = true;
      for (const auto& [P, part] : region.outline) series.points.emplace_back(P * units_.force, lambda_at(part));
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
  /// Null below pull-off.
  std::optional<Regime> regime(double lambda, double P) const {
    const auto report = model_.regime(ParameterValues{std::min(lambda, last_)}, P, tau0_);
    return report ? std::optional(report->regime) : std::nullopt;
  }

  Series data_loads() const {
    Series loads{"these data", model_symbol(fit_.model), color(0), {}};
    const auto& interval = lambda_.interval;
    for (std::size_t run = 0; run < data_.curves.size(); ++run) {
      const double P = data_.curve_loads[run] * units_.force;
      loads.points.emplace_back(P, *lambda_.value);
      loads.bars.push_back({P, P, interval && interval->low ? std::max(*interval->low, first_) : *lambda_.value,
                            interval && interval->high ? *interval->high : *lambda_.value});
      const auto at_load = regime(*lambda_.value, data_.curve_loads[run]);
      loads.hover.push_back("run " + data_.curves[run] + ": P = " + with_unit(P, 4, units_.force_unit) + ", " +
                            (at_load ? regime_text(*at_load) : "no contact"));
    }
    return loads;
  }

  const ReportedData& reported_;
  const Dataset& data_;
  DrawnUnits units_;
  const FittedParameter& lambda_;
  const ContactModel& model_;
  const FitResult& fit_;
  double P_low_, P_high_, first_, last_;
  bool logarithmic_;
  std::optional<double> tau0_;
};

}  // namespace

std::vector<Figure> regime_figures(const ReportedData& reported, std::vector<MissingFigure>& left_out) {
  std::vector<Figure> figures;
  if (!reported.result.data.has_loads || reported.result.data.curve_loads.empty()) return figures;
  for (const FitResult* fit : fits_with_values(reported.result.fits)) {
    const ContactModel model = model_of(*fit);
    if (model.parameters().size() != 1) continue;
    if (auto figure = RegimeMap(reported, model, *fit).draw(left_out)) figures.push_back(std::move(*figure));
  }
  return figures;
}

}  // namespace mixity
