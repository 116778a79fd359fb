// Work on several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <future>
#include <thread>
#include <vector>

namespace mixity {

/// Number of processors; 1 if unknown, and in a browser, where threads are not used. Cached, since the system opens a
/// file to find it.
inline std::size_t processors() {
#ifdef __EMSCRIPTEN__
  return 1;
#endif
  static const std::size_t count = std::max(1u, std::thread::hardware_concurrency());
  return count;
}

/// Calls run() on this many threads, including the calling one, and waits for all. The calls share the work. If the
/// system grants fewer threads, some calls start late and find no work left.
template <class Run>
void run_on_threads(std::size_t threads, const Run& run) {
  std::vector<std::future<void>> helpers;
  for (std::size_t k = 1; k < threads; ++k) helpers.push_back(std::async(std::ref(run)));
  run();
  for (auto& helper : helpers) helper.get();
}

/// Calls body(i) for each i < n, on as many threads as there are processors, in any order.
template <class Body>
void parallel_for(std::size_t n, const Body& body) {
  std::atomic<std::size_t> next = 0;
  run_on_threads(std::min(n, processors()), [&] {
    for (std::size_t i; (i = next++) < n;) body(i);
  });
}

}  // namespace mixity
