#include "report/json.h"

#include <gtest/gtest.h>

#include <string>

namespace mixity {
namespace {

TEST(Json, FieldsKeepTheirOrderAndTheLastValueOfANameCounts) {
  Json object = {{"z", 1}, {"a", 2}};
  object["m"] = 3;
  object["z"] = 4;
  object.update({{"a", 5}, {"b", 6}});
  object.erase("m");
  EXPECT_EQ(object.dump(), R"({"z":4,"a":5,"b":6})");
  EXPECT_EQ(Json::parse(object.dump()), object);
}

TEST(Json, ObjectsThatGrowMoveTheirValues) {
  Json object = {{"list", {1, 2, 3}}};
  const Json* const first = &object["list"][0];
  for (int i = 0; i < 100; ++i) object["field " + std::to_string(i)] = i;
  EXPECT_EQ(&object["list"][0], first);
  EXPECT_EQ(object.size(), 101u);
}

}  // namespace
}  // namespace mixity
