// growth_laws [N]: defines, uses and drops N laws (10,000 by default) on each of two threads. Prints time and memory
// after every thousand, which must not grow. Fails if the resident memory at the end exceeds that after the first
// thousand by more than 10 %.
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

#include "growth/measure.h"
#include "mechanics/contact_model.h"
#include "mechanics/laws/user_law.h"

namespace {

using namespace mixity;

/// An expression, a criterion, or an expression of two parameters, in turn.
LawDefinition definition(const std::string& key, std::size_t i) {
  const std::string number = std::to_string(1 + static_cast<double>(i) / 1e6);
  if (i % 3 == 0) return {key, "1 + (1-l)*" + number + "*tan(psi)^2", {{"l", 0.1, 1, 0.15}}};
  if (i % 3 == 1) return {key, "K_I^2 + l*" + number + "*K_II^2 = 1", {{"l", 0.1, 1, 0.15}}};
  return {key, "1 + p*" + number + "*t^2/(1 + q*B^1.5)", {{"p", 0, 1, 0.5}, {"q", 0, 1, 0.5}}};
}

bool use(const ContactModel& model) {
  std::vector<double> p;
  for (const ParameterInfo& one : model.parameters()) p.push_back(one.typical);
  std::vector<Values> values;
  for (const double& one : p) values.push_back({&one, 0});
  const std::array<double, 3> P{2, 2, 2}, T{0.5, 2, 4}, sigma_T{0.1, 0.1, 0.1}, sigma_A{0.2, 0.2, 0.2};
  std::array<double, 3> A{}, r{};
  std::array<EquilibriumStatus, 3> status{};
  model.areas(values, {P.data(), 1}, {T.data(), 1}, A, status);
  for (double& area : A) area *= 1.02;
  CurveDistances out{r, {}, {}, {}, {}};
  return model.curve_distances(p, {P, T, A, sigma_T, sigma_A}, Search::local, false, out) && r[0] != 0;
}

bool define_use_and_drop(const std::string& key, std::size_t i) {
  LawError error;
  const auto law = UserLaw::make(definition(key, i), error);
  return law && use(ContactModel(law));
}

}  // namespace

int main(int argc, char** argv) {
  constexpr std::size_t kThreads = 2, kStep = 1000;
  const std::size_t laws = argc > 1 ? static_cast<std::size_t>(std::atol(argv[1])) : 10000;
  std::atomic<bool> ok = true;
  double first = 0, last = 0;
  std::printf("laws on each of %zu threads, us per law, resident memory\n", kThreads);
  for (std::size_t done = 0; done < laws && ok; done += kStep) {
    const auto start = std::chrono::steady_clock::now();
    {
      std::array<std::jthread, kThreads> threads;
      for (std::size_t k = 0; k < kThreads; ++k)
        threads[k] = std::jthread([&, k] {
          for (std::size_t i = done; i < done + kStep; ++i)
            if (!define_use_and_drop("law_" + std::to_string(k) + "_" + std::to_string(i), i)) ok = false;
        });
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    last = growth::memory("VmRSS");
    if (done == 0) first = last;
    std::printf("%6zu %8.1f us %8.2f MB\n", done + kStep, 1e6 * seconds / (kThreads * kStep), last / 1048576);
  }
  if (!ok || last > 1.1 * first) std::printf(ok ? "the memory grows\n" : "a law cannot be used\n");
  return ok && last <= 1.1 * first ? 0 : 1;
}
