#include "base/text.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace mixity {
namespace text_test {

TEST(Printable, LeavesTextAsItIs) {
  for (const char* text : {"", "a.csv:1:2: wrong", "µm² ≤ 90°", "\U0001F600"}) EXPECT_EQ(printable(text), text);
}

TEST(Printable, ControlCharactersBecomeQuestionMarks) {
  EXPECT_EQ(printable("a\nb\tc\r\x1b[31m\x7f"), "a?b?c??[31m?");
  EXPECT_EQ(printable(std::string("a\0b", 3)), "a?b");
  EXPECT_EQ(printable("a\xC2\x85z\xC2\x9Bz"), "a?z?z");  // those beyond ASCII: next line, control sequence
}

TEST(Printable, BytesThatAreNoUtf8BecomeQuestionMarks) {
  EXPECT_EQ(printable("\xFF\xFEP"), "??P");
  EXPECT_EQ(printable("mm\xB2"), "mm?");        // Latin-1
  EXPECT_EQ(printable("\xC2"), "?");            // cut off
  EXPECT_EQ(printable("\xE2\x89z"), "??z");     // cut off
  EXPECT_EQ(printable("\xC0\xAF"), "??");       // longer than need be
  EXPECT_EQ(printable("\xED\xA0\x80"), "???");  // a surrogate
  EXPECT_EQ(printable("\xF5\x80\x80\x80"), "????");
  EXPECT_EQ(printable("\xEF\xBF\xBEz\xEF\xBF\xBF"), "?z?");  // no characters of XML
}

TEST(Printable, LongTextIsCutBetweenCharacters) {
  EXPECT_EQ(printable("µµµ", 6), "µµµ");
  EXPECT_EQ(printable("µµµ", 5), "µµ...");
  EXPECT_EQ(printable("abcd", 3), "abc...");
}

TEST(Trim, TakesBlanksOfEveryKindFromBothEnds) {
  EXPECT_EQ(trim(" \t a b\r\n"), "a b");
  EXPECT_EQ(trim("ab"), "ab");
  EXPECT_EQ(trim(" \n"), "");
  EXPECT_EQ(trim(""), "");
}

TEST(Split, GivesOnePartMoreThanSeparators) {
  using Parts = std::vector<std::string_view>;
  EXPECT_EQ(split("a, b ,c"), (Parts{"a", "b", "c"}));
  EXPECT_EQ(split("a,,"), (Parts{"a", "", ""}));
  EXPECT_EQ(split(""), Parts{""});
  EXPECT_EQ(split("1;2", ';'), (Parts{"1", "2"}));
}

TEST(Padded, LeavesABlankAfterALongText) {
  EXPECT_EQ(padded("ab", 4), "ab  ");
  EXPECT_EQ(padded("abcd", 4), "abcd ");
}

}  // namespace text_test
}  // namespace mixity
