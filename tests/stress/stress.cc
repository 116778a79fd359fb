// stress [--areas=N] [--fits=N] [--seed=S]: random cases over the whole domain, judged by independent formulas. Ends
// with 1 if any goes wrong.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <future>
#include <thread>

#include "stress/fits.h"

namespace {

using namespace mixity::stress;

/// Shares of the cases, each with a stream of its own, on all processors. The result depends on the seed alone.
template <class Run>
Tally shared_out(std::uint64_t seed, std::size_t cases, const Run& run) {
  constexpr std::size_t kShares = 64;
  const std::size_t threads = std::max(1u, std::thread::hardware_concurrency());
  std::vector<Tally> tallies(kShares);
  std::vector<std::future<void>> workers;
  for (std::size_t worker = 0; worker < threads; ++worker)
    workers.push_back(std::async(std::launch::async, [&, worker] {
      for (std::size_t share = worker; share < kShares; share += threads)
        tallies[share] = run(seed * 1000003 + share, (cases + kShares - 1) / kShares);
    }));
  for (auto& worker : workers) worker.get();
  Tally all = tallies[0];
  for (std::size_t share = 1; share < kShares; ++share) all.add(tallies[share]);
  return all;
}

void print(const Tally& tally) {
  std::printf("| %s | %zu | %zu | %.2g | %.3g us | %.3g us | %zu |\n", tally.what.c_str(), tally.cases, tally.answered,
              tally.worst_error, 1e-3 * tally.total_ns / static_cast<double>(tally.cases), 1e-3 * tally.slowest_ns,
              tally.failures);
}

void explain(const Tally& tally) {
  if (!tally.worst_case.empty()) std::printf("worst of %s: %s\n", tally.what.c_str(), tally.worst_case.c_str());
  std::printf("slowest of %s: %s\n", tally.what.c_str(), tally.slowest_case.c_str());
  for (const std::string& why : tally.first_failures) std::printf("FAILED: %s\n", why.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  std::size_t areas = 1000000, fits = 100000, seed = 1;
  for (int i = 1; i < argc; ++i) {
    const auto number = [&](const char* flag, std::size_t& value) {
      const std::size_t length = std::strlen(flag);
      if (std::strncmp(argv[i], flag, length) != 0) return false;
      value = std::strtoull(argv[i] + length, nullptr, 10);
      return true;
    };
    if (!number("--areas=", areas) && !number("--fits=", fits) && !number("--seed=", seed)) {
      std::fprintf(stderr, "stress [--areas=N] [--fits=N] [--seed=S]\n");
      return 2;
    }
  }
  const Tally by_area = shared_out(seed, areas, random_contacts), by_fit = shared_out(seed, fits, random_fits);
  std::printf(
      "| what | cases | answered | worst relative error | mean time | slowest | failures "
      "|\n|---|---|---|---|---|---|---|\n");
  print(by_area);
  print(by_fit);
  explain(by_area);
  explain(by_fit);
  return by_area.failures + by_fit.failures > 0;
}
