#include "dataset/logs/clocks.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "base/input_error.h"
#include "base/number_text.h"
#include "base/phrases.h"
#include "dataset/logs/coarse_lag.h"
#include "dataset/logs/lag_events.h"

namespace mixity {
namespace {

using Lags = std::vector<TimeDensity>;  // from one event each, at the same times

constexpr double kOther = 0.02;  // probability that forces and areas do not show the same event

/// The lag from an event whose error is `scale` times what it is said to be, and whose time also scatters with a normal
/// deviation.
std::vector<double> probabilities(const TimeDensity& lag, double scale, double deviation) {
  TimeDensity scaled = lag;
  double before = 0, after = 0;
  for (double& one : scaled.p) {
    before += one;
    one = scale == 1 ? one : std::pow(one, 1 / (scale * scale));
    after += one;
  }
  for (double& one : scaled.p) one *= after > 0 ? before / after : 0;
  if (deviation > 0) {
    TimeDensity wider{lag.begin, lag.step, std::vector<double>(lag.p.size())};
    add_differences(normal_times(0, deviation, lag.step), scaled, wider);
    scaled = std::move(wider);
  }
  for (double& one : scaled.p) one = (1 - kOther) * one + kOther / static_cast<double>(scaled.p.size());
  return std::move(scaled.p);
}

/// The product over events of one kind. Their scatter says how large their errors are: the product is averaged over
/// factors on the errors and over additional scatter, each with its probability.
TimeDensity together(const Lags& lags) {
  const double tried = lags.front().step * static_cast<double>(lags.front().p.size());
  std::vector<std::vector<double>> products;
  double most = -std::numeric_limits<double>::infinity();
  const auto add = [&](double probability, double scale, double deviation) {
    std::vector<double> product(lags.front().p.size(), std::log(probability));
    for (const TimeDensity& lag : lags) {
      const std::vector<double> p = probabilities(lag, scale, deviation);
      for (std::size_t k = 0; k < product.size(); ++k) product[k] += std::log(p[k]);
    }
    most = std::max(most, *std::max_element(product.begin(), product.end()));
    products.push_back(std::move(product));
  };
  // Probabilities beforehand. Factors a third apart; scatter in shares of the range of lags tried.
  constexpr double kScales[] = {0.36, 0.48, 0.64, 0.85, 1.14, 1.52};
  for (const double scale : kScales) add(0.93 / std::size(kScales), scale, 0);
  add(0.05, 1, 0.02 * tried);
  add(0.02, 1, 0.1 * tried);
  TimeDensity all = lags.front();
  std::fill(all.p.begin(), all.p.end(), 0);
  for (const auto& product : products)
    for (std::size_t k = 0; k < all.p.size(); ++k) all.p[k] += std::exp(product[k] - most);
  return all;
}

/// The lag from events of one kind, counting those that make it more probable. Null if none does.
std::optional<LagPart> part_by(LagEvent::Kind kind, const Lags& lags, const TimeDensity& all) {
  const auto best = static_cast<std::size_t>(std::max_element(all.p.begin(), all.p.end()) - all.p.begin());
  const auto telling = static_cast<std::size_t>(std::count_if(lags.begin(), lags.end(), [&](const TimeDensity& lag) {
    return lag.p[best] * static_cast<double>(lag.p.size()) > 1;
  }));
  if (telling == 0) return std::nullopt;
  const auto [lag, error] = moments(all);
  return LagPart{to_string(kind), telling, lag, std::hypot(error, all.step / std::sqrt(12.0))};
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

/// `sample`: between readings of the forces, s. Null if no event determines the lag.
std::optional<Estimate> estimate_by(const std::vector<LagEvent>& events, LagRange range, double interval,
                                    double sample) {
  Estimate found;
  std::optional<TimeDensity> lag;
  for (const auto kind : {LagEvent::Kind::made, LagEvent::Kind::lost, LagEvent::Kind::fall}) {
    Lags lags;
    for (const LagEvent& event : events)
      if (event.kind == kind) lags.push_back(lag_by(event, range, interval));
    if (lags.empty()) continue;
    const TimeDensity by_kind = together(lags);
    if (const auto part = part_by(kind, lags, by_kind)) found.parts.push_back(*part);
    const double most = *std::max_element(by_kind.p.begin(), by_kind.p.end());
    if (!lag) lag = TimeDensity{by_kind.begin, by_kind.step, std::vector<double>(by_kind.p.size(), 1)};
    for (std::size_t k = 0; k < lag->p.size(); ++k) lag->p[k] *= by_kind.p[k] / most;
  }
  if (found.parts.empty()) return std::nullopt;
  found.lag = moments(*lag);
  // what all events share: which moment of its step a sample of the forces stands for, and the steps of the lags tried
  const double shared = std::hypot(sample, lag->step) / std::sqrt(12.0);
  found.lag.deviation = std::hypot(found.lag.deviation, shared);
  found.low = found.lag.mean - std::hypot(found.lag.mean - quantile(*lag, 0.025), kOf95 * shared);
  found.high = found.lag.mean + std::hypot(quantile(*lag, 0.975) - found.lag.mean, kOf95 * shared);
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
  const double interval = rough.interval, sample = typical_step(forces.time), wide = std::max(kWide, 4 * interval);
  const LagRange first{coarse - wide, coarse + wide};
  std::vector<LagEvent> events = contact_events(forces, rough, first);
  MeanAndDeviation near{coarse, wide / kErrors};
  if (const auto by_contacts = estimate_by(events, first, interval, sample)) near = by_contacts->lag;
  const double narrow = std::min(wide, std::max({kErrors * near.deviation, kNarrow, kFrames * interval}));
  const LagRange range{near.mean - narrow, near.mean + narrow};
  const Frames frames = make_frames(forces, areas, near.mean);
  if (auto nearer = contact_events(forces, frames, range); !nearer.empty()) events = std::move(nearer);
  const std::vector<LagEvent> falls = fall_events(frames, range);
  events.insert(events.end(), falls.begin(), falls.end());
  const auto found = estimate_by(events, range, interval, sample);
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
