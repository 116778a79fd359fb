// Every model of the registry as a type, for typed tests.
#pragma once

#include <gtest/gtest.h>

#include <tuple>

#include "mechanics/registry.h"

namespace mixity {

template <class Tuple>
struct AsTypes;
template <class... Model>
struct AsTypes<std::tuple<Model...>> {
  using type = ::testing::Types<Model...>;
};

using ModelTypes = AsTypes<Models>::type;

}  // namespace mixity
