// stress [--areas=N] [--fits=N] [--large=N] [--experiments=N] [--seed=S]: random cases over the whole domain, judged by
// independent formulas. --large: data sets of a million points. Ends with 1 if any goes wrong.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <future>
#include <thread>

#include "stress/experiments.h"
#include "stress/fits.h"

namespace {

using namespace mixity::stress;

/// Shares of the cases, each with a stream of its own, on all processors. The result depends on the seed alone.
template <class Run>
Tally shared_out(std::uint64_t seed, std::size_t cases, const Run& run) {
  const std::size_t shares = std::min<std::size_t>(64, cases);
  const std::size_t threads = std::max(1u, std::thread::hardware_concurrency());
  std::vector<Tally> tallies(std::max<std::size_t>(shares, 1));
  std::vector<std::future<void>> workers;
  for (std::size_t worker = 0; worker < threads; ++worker)
    workers.push_back(std::async(std::launch::async, [&, worker] {
      for (std::size_t share = worker; share < shares; share += threads)
        tallies[share] = run(seed * 1000003 + share, (cases + shares - 1) / shares);
    }));
  for (auto& worker : workers) worker.get();
  Tally all = tallies[0];
  for (std::size_t share = 1; share < shares; ++share) all.add(tallies[share]);
  return all;
}

void print(const Tally& tally) {
  if (tally.cases == 0) return;
  std::printf("| %s | %zu | %zu | %zu | %.2g | %.3g us | %.3g us | %zu |\n", tally.what.c_str(), tally.cases,
              tally.answered, tally.given_up, tally.worst_error,
              1e-3 * tally.total_ns / static_cast<double>(tally.cases), 1e-3 * tally.slowest_ns, tally.failures);
}

void explain(const Tally& tally) {
  if (tally.cases == 0) return;
  if (!tally.worst_case.empty()) std::printf("worst of %s: %s\n", tally.what.c_str(), tally.worst_case.c_str());
  std::printf("slowest of %s: %s\n", tally.what.c_str(), tally.slowest_case.c_str());
  for (const std::string& where : tally.first_given_up) std::printf("given up: %s\n", where.c_str());
  for (const std::string& why : tally.first_failures) std::printf("FAILED: %s\n", why.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  std::size_t areas = 1000000, fits = 100000, large = 4, experiments = 500, seed = 1;
  for (int i = 1; i < argc; ++i) {
    const auto number = [&](const char* flag, std::size_t& value) {
      const std::size_t length = std::strlen(flag);
      if (std::strncmp(argv[i], flag, length) != 0) return false;
      value = std::strtoull(argv[i] + length, nullptr, 10);
      return true;
    };
    if (!number("--areas=", areas) && !number("--fits=", fits) && !number("--large=", large) &&
        !number("--experiments=", experiments) && !number("--seed=", seed)) {
      std::fprintf(stderr, "stress [--areas=N] [--fits=N] [--large=N] [--experiments=N] [--seed=S]\n");
      return 2;
    }
  }
  const Tally tallies[] = {shared_out(seed, areas, random_contacts), shared_out(seed, fits, random_fits),
                           shared_out(seed, large, large_fits), shared_out(seed, experiments, random_experiments)};
  std::printf(
      "| what | cases | answered | given up | worst error | mean time | slowest | failures |\n"
      "|---|---|---|---|---|---|---|---|\n");
  for (const Tally& tally : tallies) print(tally);
  std::printf("errors of areas are relative, those of fits in standard errors from the scanned minimum\n");
  std::size_t failures = 0;
  for (const Tally& tally : tallies) {
    explain(tally);
    failures += tally.failures;
  }
  return failures > 0;
}
