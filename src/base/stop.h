// Lets somebody stop long work: it calls may_go_on() wherever it can end.
#pragma once

#include <functional>
#include <utility>

namespace mixity {

/// Throws if the work is to stop. Called from any thread that works.
using StopCheck = std::function<void()>;

namespace stop_detail {
inline thread_local const StopCheck* check = nullptr;
}  // namespace stop_detail

/// The check of this thread; null: none.
inline const StopCheck* stop_check() { return stop_detail::check; }

/// While it exists, may_go_on() calls the check, on this thread and on those that work for it (threads.h). Null: none.
class Stoppable {
 public:
  explicit Stoppable(const StopCheck* check) : before_(std::exchange(stop_detail::check, check)) {}
  ~Stoppable() { stop_detail::check = before_; }
  Stoppable(const Stoppable&) = delete;
  Stoppable& operator=(const Stoppable&) = delete;

 private:
  const StopCheck* before_;
};

/// Throws what the check throws. Costs next to nothing where there is none.
inline void may_go_on() {
  if (stop_detail::check) (*stop_detail::check)();
}

}  // namespace mixity
