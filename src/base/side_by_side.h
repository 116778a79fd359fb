// The same work on several threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <future>
#include <thread>
#include <vector>

namespace mixity {

/// Processors of the machine; 1 where that is not known, and in a browser, which gives no threads here. Asked once: the
/// system opens a file to answer.
inline std::size_t processors() {
#ifdef __EMSCRIPTEN__
  return 1;
#endif
  static const std::size_t count = std::max(1u, std::thread::hardware_concurrency());
  return count;
}

/// Calls run() on so many threads, this one among them, and waits for all. Where the system gives fewer, some calls
/// come one after the other: run() shares the work out itself, and finds none left then.
template <class Run>
void side_by_side(std::size_t threads, const Run& run) {
  std::vector<std::future<void>> helpers;
  for (std::size_t k = 1; k < threads; ++k) helpers.push_back(std::async(std::ref(run)));
  run();
  for (auto& helper : helpers) helper.get();
}

}  // namespace mixity
