// Numbers in the fields of a table.
#include "dataset/table/number.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>

#include "base/number_text.h"
#include "dataset/table/csv_file.h"

namespace mixity {
namespace number_test {

/// Compared with the C library's own conversion.
TEST(Number, IsTheNearestDoubleInEverySpelling) {
  std::mt19937_64 random(1);
  const auto spelling = [&]() -> std::string {
    char text[64];
    const double value = std::bit_cast<double>(random()), usual = std::ldexp(static_cast<double>(random()), -50);
    switch (random() % 6) {
      case 0:
        return std::isfinite(value) ? shortest(value) : "0";
      case 1:
        std::snprintf(text, sizeof text, "%.*f", static_cast<int>(random() % 20), usual);
        return text;
      case 2:
        std::snprintf(text, sizeof text, "%.*g", static_cast<int>(1 + random() % 25), -usual);
        return text;
      case 3:
        return std::to_string(random() >> random() % 64);  // up to 2^64
      case 4:
        std::snprintf(text, sizeof text, "%05d.%06d", static_cast<int>(random() % 99999),
                      static_cast<int>(random() % 1000000));
        return text;
      default:
        return std::array{"0",
                          "-0",
                          ".5",
                          "5.",
                          "-0.0",
                          "1e3",
                          "9007199254740993",
                          "9007199254740992",
                          "0.00000000000000000001",
                          "123456789012345678901234567890",
                          "1E5"}[random() % 11];
    }
  };
  for (int i = 0; i < 100000; ++i) {
    const std::string text = spelling();
    double value = 0, comma = 0;
    ASSERT_TRUE(parse_number(text, '.', value)) << text;
    const double nearest = std::strtod(text.c_str(), nullptr);
    if (std::abs(nearest) >= 0x1p-1022 || nearest == 0) {  // what is smaller may become 0
      ASSERT_EQ(std::bit_cast<std::uint64_t>(value), std::bit_cast<std::uint64_t>(nearest)) << text;
    }
    std::string with_comma = text;
    std::replace(with_comma.begin(), with_comma.end(), '.', ',');
    ASSERT_TRUE(parse_number(with_comma, ',', comma)) << with_comma;
    ASSERT_EQ(comma, value) << with_comma;
  }
}

TEST(Number, HasAnExponentAsMathematicaWritesIt) {
  double value = 0;
  EXPECT_TRUE(parse_number("7.73*^-3", '.', value));
  EXPECT_EQ(value, 7.73e-3);
  EXPECT_TRUE(parse_number("-2*^6", '.', value));
  EXPECT_EQ(value, -2e6);
  for (const char* text : {"2*6", "2*^", "2*^^3", "*^3"}) EXPECT_FALSE(parse_number(text, '.', value)) << text;
}

TEST(Number, BeginsWithADigitASignOrAName) {
  for (const char* text : {"1", " 1", "-1", "+1", ".5", ",5", "-,5", "inf", "-inf", "NaN",
                           "\xE2\x88\x92"
                           "1",
                           "1,234.5", "1'234", "1D3", "1,5D3", "0.61(5)", "0,61 \xC2\xB1 0,05"})
    EXPECT_TRUE(is_number(text)) << text;
  for (const char* text : {"", " ", "word", "P=5", "'1", "e5", "(5)",
                           "\xC2\xB1"
                           "5",
                           "1;2", "1,2,3", "1.2.3", "+-5", "-+5", "1:2", "d5", "n", "i"})
    EXPECT_FALSE(is_number(text)) << text;
}

TEST(Number, IsReadInEverySpellingOfATable) {
  for (const std::string text :
       {"1,a,b,2\n3,c,d,4\n", "1;a;b;2\n3;c;d;4\n", "1\ta\tb\t2\n3\tc\td\t4\n", "1,a,b,2\r\n3,c,d,4\r\n",
        "1,a,b,2\r3,c,d,4\r", " 1 ,a , b , 2 \n3, c, d, 4\n", "\"1\",a,\"b\",\" 2 \"\n3,c,d,\"4\""}) {
    std::vector<double> numbers;
    std::string texts;
    read_csv_text(text, "text", true, [&](const CsvRow& row) {
      ASSERT_EQ(row.size(), 4) << text;
      double first = 0, last = 0;
      EXPECT_TRUE(row.number(0, first) && row.number(3, last)) << text;
      EXPECT_FALSE(row.number(1, first)) << text;
      numbers.insert(numbers.end(), {first, last});
      texts += std::string(row[2]);
    });
    EXPECT_EQ(numbers, (std::vector<double>{1, 2, 3, 4})) << text;
    EXPECT_EQ(texts, "bd") << text;
  }
}

TEST(Number, MayHaveItsStandardErrorBesideIt) {
  struct Case {
    const char* text;
    char decimal;
    double value, error;
  };
  for (const auto& [text, decimal, value, error] : {
           Case{"0.61+/-0.05", '.', 0.61, 0.05},
           {"0.61 \xC2\xB1 0.05", '.', 0.61, 0.05},
           {"0.61+-0.05", '.', 0.61, 0.05},
           {"-61 \xC2\xB1 5 %", '.', -61, 3.05},
           {"0,61 +/- 0,05", ',', 0.61, 0.05},
           {"0.61(5)", '.', 0.61, 0.05},
           {"0.61(12)", '.', 0.61, 0.12},
           {"61(5)", '.', 61, 5},
           {"0.61(0.05)", '.', 0.61, 0.05},
           {"6.1(5)e-1", '.', 0.61, 0.05},
           {"-0,61(5)", ',', -0.61, 0.05},
           {"1e3 +/- 0", '.', 1e3, 0},
       }) {
    double found = 0, of = 0;
    ASSERT_TRUE(parse_with_error(text, decimal, found, of)) << text;
    EXPECT_DOUBLE_EQ(found, value) << text;
    EXPECT_DOUBLE_EQ(of, error) << text;
    EXPECT_TRUE(is_number(text)) << text;
  }
  for (const char* text :
       {"0.61", "0.61()", "(5)", "0.61(5", "0.61(-5)", "0.61(a)", "0.61 +/- ", "+/- 0.05", "0.61 +/- -0.05",
        "0.61 +/- nan", "0.61(5)x", "0.61(5)(6)", "a(5)", "0,61(5)", "1 +/- 2 +/- 3"}) {
    double found = 0, of = 0;
    EXPECT_FALSE(parse_with_error(text, '.', found, of)) << text;
  }
}

TEST(Number, IsReadOnlyOfAWholeField) {
  double value = 0;
  for (const std::string_view text : {"", "x", "1.2.3", "4e", "1 2", "1-2", "--1", "+-1", "0x10", "1,5"})
    EXPECT_FALSE(parse_number(text, '.', value)) << text;
  EXPECT_TRUE(parse_number("+1", '.', value));
  EXPECT_EQ(value, 1);
  EXPECT_TRUE(parse_number("1e999", '.', value));
  EXPECT_EQ(value, HUGE_VAL);
  EXPECT_TRUE(parse_number("-1e-999", '.', value));
  EXPECT_EQ(value, 0);
}

}  // namespace number_test
}  // namespace mixity
