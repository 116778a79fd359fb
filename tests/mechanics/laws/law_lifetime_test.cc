// A law that is defined at run time is freed with its last user, on whatever thread, while other laws are in use.
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <thread>
#include <vector>

#include "mechanics/contact_model.h"
#include "mechanics/laws/known_laws.h"
#include "mechanics/laws/user_law_view.h"

namespace mixity {
namespace law_lifetime_test {

std::shared_ptr<const UserLaw> made(const LawDefinition& definition) {
  LawError error;
  const auto law = UserLaw::make(definition, error);
  EXPECT_TRUE(law) << error.message;
  return law;
}

double area_of(const ContactModel& model, double lambda) {
  const double P = 2, T = 3;
  double A = 0;
  EquilibriumStatus status{};
  const Values parameter{&lambda, 0};
  model.areas({&parameter, 1}, {&P, 0}, {&T, 0}, {&A, 1}, {&status, 1});
  return A;
}

TEST(LawLifetime, EndsWithTheLastUser) {
  std::weak_ptr<const UserLaw> watched;
  {
    LawError error;
    auto law = define_law({"short_lived", "1 + p*t^2", {{"p", 0, 1, 0.5}}}, error);
    watched = law;
    std::optional<ContactModel> model = ContactModel::find("short_lived");
    std::optional<ContactModel> other = model;
    law.reset();
    forget_laws();
    EXPECT_FALSE(find_law("short_lived"));
    model.reset();
    EXPECT_FALSE(watched.expired());
    EXPECT_GT(area_of(*other, 0.5), 0);
  }
  EXPECT_TRUE(watched.expired());
}

TEST(LawLifetime, EndsForAllThatAreForgotten) {
  LawError error;
  const std::weak_ptr<const UserLaw> one = define_law({"forgotten_1", "1 + p*t^2", {{"p", 0, 1, 0.5}}}, error),
                                     two = define_law({"forgotten_2", "1 + p*t^2", {{"p", 0, 1, 0.5}}}, error);
  EXPECT_FALSE(one.expired());
  forget_laws();
  EXPECT_TRUE(one.expired());
  EXPECT_TRUE(two.expired());
  EXPECT_TRUE(law_keys().empty());
}

TEST(LawLifetime, KeepsWhatAFunctionRefersToAndNoLonger) {
  auto owned = std::make_shared<int>(0);
  const std::weak_ptr<int> watched = owned;
  auto sampler = std::make_shared<const LawSampler>(
      [owned](std::span<const double> psi, std::span<const double> p, std::span<double> f) {
        for (std::size_t i = 0; i < psi.size(); ++i) f[i] = 1 + p[0] * std::pow(std::tan(psi[i]), 2);
      });
  owned.reset();
  {
    const ContactModel model(made({"function", "f(psi, p)", {{"p", 0, 1, 0.5}}, "", false, std::move(sampler)}));
    EXPECT_GT(area_of(model, 0.5), 0);
  }
  EXPECT_TRUE(watched.expired());
}

// Built with a thread or an address sanitizer this shows that no thread is left with what another one frees.
TEST(LawLifetime, OfOneLawIsOfNoConcernToAnother) {
  const ContactModel lasting(made({"lasting", "K_I^2 + l*K_II^2 = 1", {{"l", 0, 1, 0.15}}}));
  const double expected = area_of(lasting, 0.15);
  std::atomic<bool> stop = false, same = true;
  std::vector<std::jthread> users;
  for (int k = 0; k < 2; ++k)
    users.emplace_back([&] {
      while (!stop) same = same && area_of(lasting, 0.15) == expected;
    });
  for (int i = 0; i < 50; ++i) {
    auto law = made({"passing", "1 + l*t^2", {{"l", 0, 1, 0.15}}});
    auto model = std::make_unique<ContactModel>(law);
    EXPECT_GT(area_of(*model, 0.3), 0);
    const std::weak_ptr<const UserLaw> watched = law;
    law.reset();
    std::jthread([last = std::move(model)]() mutable {
      EXPECT_GT(area_of(*last, 0.7), 0);
      last.reset();
    }).join();
    EXPECT_TRUE(watched.expired());
  }
  stop = true;
  users.clear();
  EXPECT_TRUE(same);
}

// The same law on several threads at once, each with parameters of its own.
TEST(LawLifetime, IsSharedByThreads) {
  const auto law = made({"shared", "1 + l*t^2", {{"l", 0, 1, 0.15}}});
  const ContactModel model(law);
  std::array<double, 4> found{}, alone{};
  {
    std::array<std::jthread, 4> threads;
    for (std::size_t k = 0; k < threads.size(); ++k)
      threads[k] = std::jthread([&, k] {
        for (int i = 0; i < 20; ++i) found[k] = area_of(model, 0.1 * static_cast<double>(k + 1));
      });
  }
  for (std::size_t k = 0; k < alone.size(); ++k) alone[k] = area_of(model, 0.1 * static_cast<double>(k + 1));
  EXPECT_EQ(found, alone);
}

}  // namespace law_lifetime_test
}  // namespace mixity
