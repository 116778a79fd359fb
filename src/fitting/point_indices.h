// Which points of a data set a fit uses.
#pragma once

#include <cstddef>
#include <iterator>
#include <vector>

#include "dataset/dataset.h"

namespace mixity {

/// Indices into Dataset::points, each once or several times. 0, 1, 2, ..., as where a fit uses all points, take no
/// memory: of millions of points a list would count.
class PointIndices {
 public:
  /// Gives values, since there may be no list to refer to.
  class const_iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = std::size_t;
    using difference_type = std::ptrdiff_t;
    using pointer = const std::size_t*;
    using reference = std::size_t;

    const_iterator() = default;
    const_iterator(const PointIndices& of, std::size_t at) : of_(&of), at_(at) {}
    std::size_t operator*() const { return (*of_)[at_]; }
    const_iterator& operator++() {
      ++at_;
      return *this;
    }
    const_iterator operator++(int) {
      const const_iterator before = *this;
      ++at_;
      return before;
    }
    bool operator==(const const_iterator& other) const { return at_ == other.at_; }

   private:
    const PointIndices* of_ = nullptr;
    std::size_t at_ = 0;
  };
  using value_type = std::size_t;

  PointIndices() = default;
  /// The first n points.
  explicit PointIndices(std::size_t n) : size_(n) {}
  PointIndices(const std::vector<std::size_t>& list) {
    for (const std::size_t i : list) push_back(i);
  }

  void push_back(std::size_t i) {
    if (are_first() && i != size_)  // the first that needs a list
      for (std::size_t k = 0; k < size_; ++k) list_.push_back(static_cast<Point::Index>(k));
    if (!are_first() || i != size_) list_.push_back(static_cast<Point::Index>(i));
    ++size_;
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  std::size_t operator[](std::size_t k) const { return list_.empty() ? k : list_[k]; }
  const_iterator begin() const { return {*this, 0}; }
  const_iterator end() const { return {*this, size_}; }
  /// Whether these are the first points in their order: 0 to size() - 1.
  bool are_first() const { return list_.empty(); }
  /// Whether these are the points 0 to n - 1 in their order.
  bool are_all(std::size_t n) const { return are_first() && size_ == n; }
  std::vector<std::size_t> list() const { return {begin(), end()}; }
  bool operator==(const PointIndices&) const = default;

 private:
  std::size_t size_ = 0;
  std::vector<Point::Index> list_;  // empty: the first `size_` points
};

}  // namespace mixity
