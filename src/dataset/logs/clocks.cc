#include "dataset/logs/clocks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/input_error.h"
#include "base/number_text.h"
#include "base/phrases.h"
#include "dataset/logs/coarse_lag.h"
#include "dataset/logs/lag_events.h"

namespace mixity {
namespace {

using Lags = std::vector<TimeDensity>;  // from one event each, at the same times

/// The lag from an event whose time also scatters with a normal deviation.
TimeDensity scattered(const TimeDensity& lag, double deviation) {
  TimeDensity wider{lag.begin, lag.step, std::vector<double>(lag.p.size())};
  add_differences(normal_times(0, deviation, lag.step), lag, wider);
  return wider;
}

/// The product over events, averaged over additional scatter beyond their own errors, each value with its probability:
/// none, or a fraction of the range of lags tried.
TimeDensity together(const Lags& lags) {
  const double tried = lags.front().step * static_cast<double>(lags.front().p.size());
  std::vector<std::vector<double>> products;
  double most = -std::numeric_limits<double>::infinity();
  for (const double share : {0.0, 0.02, 0.1}) {
    // price of one more estimated deviation, as in BIC
    const double beforehand = share > 0 ? -0.5 * std::log(static_cast<double>(lags.size() + 1)) : 0;
    std::vector<double> product(lags.front().p.size(), beforehand);
    for (const TimeDensity& lag : lags) {
      const TimeDensity wider = share > 0 ? scattered(lag, share * tried) : lag;
      for (std::size_t k = 0; k < product.size(); ++k) product[k] += std::log(wider.p[k]);
    }
    most = std::max(most, *std::max_element(product.begin(), product.end()));
    products.push_back(std::move(product));
  }
  TimeDensity all = lags.front();
  std::fill(all.p.begin(), all.p.end(), 0);
  for (const auto& product : products)
    for (std::size_t k = 0; k < all.p.size(); ++k) all.p[k] += std::exp(product[k] - most);
  return all;
}

/// The lag from events of one kind, counting those that make it more probable. Null if none does.
std::optional<LagPart> part_by(LagEvent::Kind kind, const Lags& lags) {
  if (lags.empty()) return std::nullopt;
  const TimeDensity all = together(lags);
  const auto best = static_cast<std::size_t>(std::max_element(all.p.begin(), all.p.end()) - all.p.begin());
  const auto telling = static_cast<std::size_t>(std::count_if(lags.begin(), lags.end(), [&](const TimeDensity& lag) {
    return lag.p[best] * static_cast<double>(lag.p.size()) > 1;
  }));
  if (telling == 0) return std::nullopt;
  const auto [lag, error] = moments(all);
  return LagPart{to_string(kind), telling, lag, error};
}

struct Estimate {
  MeanAndDeviation lag;
  double low = 0, high = 0;  // 95 %
  std::vector<LagPart> parts;
  bool disagree = false;
};

constexpr double kOf95 = 1.96;  // standard errors

/// If two kinds of events contradict each other, error and interval cover both.
void cover_both(const LagPart& low, const LagPart& high, Estimate& found) {
  constexpr double kDisagree = 3;  // standard errors
  const double apart = high.lag - low.lag;
  if (!(apart > kDisagree * std::hypot(low.error, high.error))) return;
  found.disagree = true;
  found.lag.deviation = std::max(found.lag.deviation, apart / 2);
  found.low = std::min(found.low, low.lag - kOf95 * low.error);
  found.high = std::max(found.high, high.lag + kOf95 * high.error);
}

/// Null if no event determines the lag.
std::optional<Estimate> estimate_by(const std::vector<LagEvent>& events, LagRange range, double interval) {
  Estimate found;
  Lags all;
  for (const auto kind : {LagEvent::Kind::made, LagEvent::Kind::lost, LagEvent::Kind::fall}) {
    Lags lags;
    for (const LagEvent& event : events)
      if (event.kind == kind) lags.push_back(lag_by(event, range, interval));
    if (const auto part = part_by(kind, lags)) found.parts.push_back(*part);
    all.insert(all.end(), lags.begin(), lags.end());
  }
  if (found.parts.empty()) return std::nullopt;
  const TimeDensity lag = together(all);
  found.lag = moments(lag);
  found.low = quantile(lag, 0.025);
  found.high = quantile(lag, 0.975);
  for (const LagPart& one : found.parts)
    for (const LagPart& other : found.parts) cover_both(one, other, found);
  return found;
}

/// Refines a lag known to some tenths of a second. Contacts come first: near the lag that they give, falls are not
/// mistaken for one another.
std::optional<Estimate> estimate(const Recording& forces, const Recording& areas, double coarse) {
  constexpr double kWide = 0.6, kNarrow = 0.1, kKnown = 0.05;  // s
  constexpr double kFrames = 3, kErrors = 5;
  const Frames rough = make_frames(forces, areas, coarse);
  const double interval = rough.interval, wide = std::max(kWide, 4 * interval);
  const LagRange first{coarse - wide, coarse + wide};
  std::vector<LagEvent> events = contact_events(forces, rough, first);
  MeanAndDeviation near{coarse, wide / kErrors};
  if (const auto by_contacts = estimate_by(events, first, interval)) near = by_contacts->lag;
  const double narrow = std::min(wide, std::max({kErrors * near.deviation, kNarrow, kFrames * interval}));
  const LagRange range{near.mean - narrow, near.mean + narrow};
  const std::vector<LagEvent> falls = fall_events(make_frames(forces, areas, near.mean), range);
  events.insert(events.end(), falls.begin(), falls.end());
  const auto found = estimate_by(events, range, interval);
  // with a larger deviation, several lags are possible
  return found && (found->disagree || found->lag.deviation < std::max(kKnown, 2 * interval)) ? found : std::nullopt;
}

}  // namespace

Frames on_one_clock(const Recording& forces, const Recording& areas, std::optional<double> lag) {
  if (&forces == &areas || lag) {
    Frames frames = make_frames(forces, areas, lag.value_or(0));
    frames.lag_source = lag ? "stated" : "one clock";
    // the picture was taken up to one sample before its row
    if (!lag && frames.samples > 1) frames.lag_error = 0.5 * typical_step(forces.time);
    return frames;
  }
  const Pictures shown = pictures(areas);
  if (shown.time.size() < 3) throw InputError(areas.path, "holds fewer than three areas");
  const auto by_load = lag_by_load(forces, shown);
  const auto coarse = by_load ? std::optional(by_load->lag) : lag_by_drops(forces, areas, shown);
  const auto found = coarse ? estimate(forces, areas, *coarse) : std::nullopt;
  if (!found)
    throw InputError(areas.path, "no contact or fall of T that " + forces.path +
                                     " also shows determines the lag between their clocks; state it: " +
                                     Remedy::set("lag", coarse ? rounded(*coarse, 3) + " s" : "0 s") +
                                     (by_load ? " is where the area follows the load, to some tenths" : ""));
  Frames frames = make_frames(forces, areas, found->lag.mean);
  frames.lag_error = found->lag.deviation;
  frames.lag_low = found->low;
  frames.lag_high = found->high;
  frames.lag_parts = found->parts;
  frames.lags_disagree = found->disagree;
  frames.lag_source =
      joined(texts_of(found->parts, [](const LagPart& part) { return std::to_string(part.events) + " " + part.by; }),
             ", ", "from ");
  return frames;
}

}  // namespace mixity
