// One value for each parameter of a law, when their number is known at run time only.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <span>

namespace mixity {

/// Up to seven numbers, stored without heap allocation: two sets of three and Poisson's ratio (elliptic contacts).
class ParameterValues {
 public:
  static constexpr std::size_t kMost = 7;

  ParameterValues() = default;
  ParameterValues(std::initializer_list<double> values) : ParameterValues(std::span(values.begin(), values.size())) {}
  explicit ParameterValues(std::span<const double> values) : size_(std::min(values.size(), kMost)) {
    std::copy_n(values.begin(), size_, values_.begin());
  }
  /// n <= kMost values of 0.
  static ParameterValues zeros(std::size_t n) {
    constexpr std::array<double, kMost> kZeros{};
    return ParameterValues(std::span(kZeros).first(n));
  }

  std::size_t size() const { return size_; }
  double& operator[](std::size_t i) { return values_[i]; }
  double operator[](std::size_t i) const { return values_[i]; }
  double* data() { return values_.data(); }
  const double* data() const { return values_.data(); }
  double* begin() { return values_.data(); }
  double* end() { return values_.data() + size_; }
  const double* begin() const { return values_.data(); }
  const double* end() const { return values_.data() + size_; }

  friend bool operator==(const ParameterValues&, const ParameterValues&) = default;

 private:
  std::array<double, kMost> values_{};  // those beyond size_ stay 0
  std::size_t size_ = 0;
};

}  // namespace mixity
