#include "base/message.h"

#include <gtest/gtest.h>

#include "base/input_error.h"

namespace mixity {
namespace message_test {

std::string short_words(const Remedy& remedy) { return "<" + remedy.choices[0].option + ">"; }

TEST(Message, JoinsTextsAndRemedies) {
  Message message;
  EXPECT_TRUE(message.empty());
  message += "a" + std::string("b");
  message += "; " + Remedy::set("free", "radius") + ", " + Remedy::set("load", "1 mN");
  EXPECT_EQ(message.text(short_words), "ab; <free>, <load>");
  EXPECT_EQ(message.options(), (std::vector<std::string>{"free", "load"}));
  ASSERT_EQ(message.remedies().size(), 2u);
  EXPECT_EQ(message.remedies()[1].choices[0].value, "1 mN");
  EXPECT_TRUE(Message(Remedy::given("radius")).remedies().empty());
  EXPECT_EQ(message, Message("ab; free = \"radius\", load = \"1 mN\""));
  EXPECT_TRUE((Message("") + "").empty());
}

TEST(InputError, IsWordedByTheDoorThatShowsIt) {
  const InputError error("a.csv", 2, 5, "column 'A'\nis in pixels: " + Remedy::set_or_key("pixel", "2 um"));
  EXPECT_EQ(error.text(short_words), "a.csv:2:5: column 'A'?is in pixels: <pixel>");
  EXPECT_STREQ(error.what(), "a.csv:2:5: column 'A'?is in pixels: pixel = \"2 um\"");
  EXPECT_EQ(error.message().options(), std::vector<std::string>{"pixel"});
  EXPECT_EQ(InputError(Remedy::given("radius"), "is 0").text(short_words), "<radius>is 0");
  EXPECT_STREQ(InputError("a.csv", "is empty").what(), "a.csv: is empty");
}

}  // namespace message_test
}  // namespace mixity
