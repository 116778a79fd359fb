// The blocks of points that a CurveObjective handles at a time.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <numeric>
#include <span>

#include "fitting/curve_objective.h"

namespace mixity {

inline constexpr std::size_t kBlock = 512;  // points whose arrays stay in the processor's cache
inline constexpr std::size_t kBlocksOfAPart = 64;

/// Arrays of a block: the points as scaled, where they are near to, their distances with derivatives, and their places.
struct CurveObjective::Workspace {
  static constexpr std::size_t kArrays = 13;
  Workspace(std::size_t n, std::size_t parameters) : values(new double[n * (kArrays + parameters)]), size(n) {}
  std::span<double> array(std::size_t which, std::size_t n) { return {values.get() + which * size, n}; }
  PointArrays points(std::size_t n) {
    return {array(0, n), array(1, n), array(2, n), array(3, n), array(4, n), array(5, n), array(6, n)};
  }
  std::unique_ptr<double[]> values;
  std::size_t size;
};

/// The indices of a block of points, given by their ranks.
struct CurveObjective::Indices {
  Indices(const CurveObjective& of, std::size_t begin, std::size_t n) {
    if (!of.order_.empty()) {
      list = std::span(of.order_).subspan(begin, n);
    } else {
      std::iota(own.begin(), own.begin() + n, static_cast<std::uint32_t>(begin));
      list = std::span(own).first(n);
    }
  }
  std::array<std::uint32_t, kBlock> own;
  std::span<const std::uint32_t> list;
};

}  // namespace mixity
