#include "dataset/logs/compression.h"

#include <algorithm>
#include <cmath>

#include "base/input_error.h"
#include "dataset/logs/contacts.h"
#include "statistics/noise.h"

namespace mixity {
namespace {

/// Correlation of load and area over the frames for which `is_one` is true; 0 if one of them is constant.
template <class IsOne>
double correlation(const Frames& frames, const IsOne& is_one) {
  double n = 0, P = 0, A = 0, pp = 0, pa = 0, aa = 0;
  for (std::size_t i = 0; i < frames.time.size(); ++i) {
    if (!is_one(i)) continue;
    ++n;
    P += frames.P[i];
    A += frames.A[i];
  }
  for (std::size_t i = 0; i < frames.time.size(); ++i) {
    if (!is_one(i)) continue;
    const double p = frames.P[i] - P / n, a = frames.A[i] - A / n;
    pp += p * p;
    pa += p * a;
    aa += a * a;
  }
  return pp > 0 && aa > 0 ? pa / std::sqrt(pp * aa) : 0;
}

}  // namespace

bool compression_is_negative(const Recording& forces, const Recording& areas, double lag) {
  constexpr double kOfAll = -0.5, kOfContact = -0.3, kChanges = 0.2;
  Frames frames;
  try {
    frames = make_frames(forces, areas, lag);
  } catch (const InputError&) {  // no overlap in time: reported when frames are needed
    return false;
  }
  std::vector<bool> touching(frames.time.size());
  double least = 0, most = 0;  // of P in contact, less the zero
  const auto contact = contacts(frames, noise_of(frames.A));
  const double zero = load_zero(frames, contact).value;
  for (const FrameRange& one : contact)
    for (std::size_t i = one.begin; i < one.end; ++i) {
      touching[i] = true;
      least = std::min(least, frames.P[i] - zero);
      most = std::max(most, frames.P[i] - zero);
    }
  return -least > most && most - least > kChanges * -least &&
         correlation(frames, [](std::size_t) { return true; }) < kOfAll &&
         correlation(frames, [&](std::size_t i) { return touching[i]; }) < kOfContact;
}

}  // namespace mixity
