// What a run of random cases found: worst error, slowest case, and everything that went wrong.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace mixity::stress {

struct Tally {
  std::string what;
  std::size_t cases = 0, answered = 0, given_up = 0, failures = 0;  // given up: fits that did not converge, and said so
  double worst_error = 0, slowest_ns = 0, total_ns = 0;
  std::string worst_case, slowest_case;
  std::vector<std::string> first_failures, first_given_up;  // at most ten

  void fail(const std::string& why) {
    ++failures;
    note(first_failures, why);
  }
  void give_up(const std::string& where) {
    ++given_up;
    note(first_given_up, where);
  }
  void see_error(double error, const std::string& where) {
    if (!(error > worst_error)) return;
    worst_error = error;
    worst_case = where;
  }
  template <class Action>
  auto timed(const std::string& where, Action&& action) {
    const auto start = std::chrono::steady_clock::now();
    auto result = action();
    const double ns = std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
    total_ns += ns;
    if (ns > slowest_ns) {
      slowest_ns = ns;
      slowest_case = where;
    }
    return result;
  }
  void add(const Tally& other) {
    cases += other.cases;
    answered += other.answered;
    given_up += other.given_up;
    failures += other.failures;
    total_ns += other.total_ns;
    see_error(other.worst_error, other.worst_case);
    if (other.slowest_ns > slowest_ns) {
      slowest_ns = other.slowest_ns;
      slowest_case = other.slowest_case;
    }
    for (const std::string& why : other.first_failures) note(first_failures, why);
    for (const std::string& where : other.first_given_up) note(first_given_up, where);
  }

 private:
  static void note(std::vector<std::string>& list, const std::string& text) {
    if (list.size() < 10) list.push_back(text);
  }
};

/// At least so many cases, from a random stream of their own: draw(random, tally) makes and judges some.
template <class Draw>
Tally random_cases(const char* what, std::uint64_t seed, std::size_t cases, const Draw& draw) {
  Tally tally;
  tally.what = what;
  std::mt19937_64 random(seed);
  while (tally.cases < cases) draw(random, tally);
  return tally;
}

}  // namespace mixity::stress
