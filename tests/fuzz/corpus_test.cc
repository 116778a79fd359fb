// Repeats every input of the fuzzer's corpus with the compiler of the tests.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

#include "base/files.h"
#include "fuzz/fuzz_input.h"
#include "fuzz/promise.h"

namespace mixity::fuzz {
namespace corpus_test {

TEST(Fuzz, EveryReaderKeepsItsPromisesOnTheWholeCorpus) {
  std::set<char> readers;
  for (const auto& entry : std::filesystem::directory_iterator(MIXITY_ROOT "/tests/fuzz/corpus")) {
    const std::string input = read_file(entry.path().string());
    ASSERT_FALSE(input.empty()) << entry.path();
    readers.insert(input[0]);
    EXPECT_EQ(fuzz_input(reinterpret_cast<const std::uint8_t*>(input.data()), input.size()), 0) << entry.path();
  }
  EXPECT_EQ(readers, std::set<char>(kReaders.begin(), kReaders.end()));
}

/// A check that accepts everything would find nothing.
TEST(FuzzDeathTest, ABrokenPromiseEndsTheProgram) {
  const auto refuse = [] { throw InputError("other.csv", 1, 1, "wrong"); };
  EXPECT_DEATH(accepts({"a.csv:"}, refuse), "a message names the file");
  EXPECT_DEATH(promise(is_one_printable_line("two\nlines"), "one line"), "broken promise: one line");
  EXPECT_FALSE(is_one_printable_line("\xff"));
  EXPECT_FALSE(is_one_printable_line("\xc2\x85"));
  EXPECT_TRUE(is_one_printable_line("µm²"));
}

}  // namespace corpus_test
}  // namespace mixity::fuzz
