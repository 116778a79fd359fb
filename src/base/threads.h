// The same work on several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <future>
#include <thread>
#include <vector>

namespace mixity {

/// Number of processors; 1 where it is not known, and in a browser, which has no threads here. Found once: the system
/// opens a file for it.
inline std::size_t processors() {
#ifdef __EMSCRIPTEN__
  return 1;
#endif
  static const std::size_t count = std::max(1u, std::thread::hardware_concurrency());
  return count;
}

/// Calls run() on so many threads, this one included, and waits for all of them. If the system grants fewer threads,
/// some calls come after others: run() has to share the work out, and finds none left then.
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
