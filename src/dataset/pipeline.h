// Several threads that read, work and hand over, in the order of what was read.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>

#include "base/side_by_side.h"

namespace mixity {

/// Until next(item) returns false: work(item), then take(item). Only work is called side by side; take comes in the
/// order of next. Each thread uses one Item again and again. Of several exceptions the first in that order is thrown,
/// and nothing that comes after it is taken.
template <class Item, class Next, class Work, class Take>
void pipeline(std::size_t threads, const Next& next, const Work& work, const Take& take) {
  std::mutex reading, taking;
  std::condition_variable turns;
  std::size_t read = 0, taken = 0;
  std::exception_ptr failure;
  const auto attempt = [](const auto& action) -> std::exception_ptr {
    try {
      action();
      return nullptr;
    } catch (...) {
      return std::current_exception();
    }
  };
  const auto run = [&] {
    Item item;
    for (bool more = true; more;) {
      std::size_t turn = 0;
      const auto own = attempt([&] {
        {
          const std::lock_guard lock(reading);
          turn = read++;
          more = next(item);
        }
        if (more) work(item);
      });
      {
        std::unique_lock lock(taking);
        turns.wait(lock, [&] { return taken == turn; });
        if (!failure) failure = own;
        if (!failure && more) failure = attempt([&] { take(item); });
        more = more && !failure;
        ++taken;
      }
      turns.notify_all();
    }
  };
  side_by_side(threads, run);
  if (failure) std::rethrow_exception(failure);
}

}  // namespace mixity
