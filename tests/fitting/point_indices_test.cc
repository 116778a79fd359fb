#include "fitting/point_indices.h"

#include <gtest/gtest.h>

#include <vector>

namespace mixity {
namespace point_indices_test {

using List = std::vector<std::size_t>;

/// Whether they are these, in whichever way they are read.
void expect_list(const PointIndices& indices, const List& list) {
  EXPECT_EQ(indices.list(), list);
  ASSERT_EQ(indices.size(), list.size());
  EXPECT_EQ(indices.empty(), list.empty());
  for (std::size_t k = 0; k < list.size(); ++k) EXPECT_EQ(indices[k], list[k]) << k;
  std::size_t k = 0;
  for (const std::size_t i : indices) EXPECT_EQ(i, list[k++]);
  EXPECT_EQ(k, list.size());
}

TEST(PointIndices, AreThoseOfTheListTheyAreMadeOf) {
  for (const List& list : {List{}, List{0}, List{3}, List{0, 1, 2, 3}, List{0, 1, 3, 4}, List{1, 2, 3}, List{2, 1, 0},
                           List{0, 1, 1, 2}, List{0, 0, 0}}) {
    expect_list(PointIndices(list), list);
    PointIndices one_by_one;
    for (const std::size_t i : list) one_by_one.push_back(i);
    EXPECT_EQ(one_by_one, PointIndices(list));
  }
}

TEST(PointIndices, KnowWhetherTheyAreAllPointsInTheirOrder) {
  EXPECT_TRUE(PointIndices(4).are_all(4));
  EXPECT_TRUE(PointIndices(List{0, 1, 2, 3}).are_all(4));
  EXPECT_EQ(PointIndices(List{0, 1, 2, 3}), PointIndices(4));
  EXPECT_FALSE(PointIndices(4).are_all(5));
  EXPECT_TRUE(PointIndices(4).are_first());
  for (const List& list : {List{1, 2, 3, 4}, List{0, 2, 1, 3}, List{0, 1, 2, 2}}) {
    EXPECT_FALSE(PointIndices(list).are_all(4));
    EXPECT_FALSE(PointIndices(list).are_first());
    EXPECT_FALSE(PointIndices(list) == PointIndices(4));
  }
}

}  // namespace point_indices_test
}  // namespace mixity
