// The functions that libFuzzer calls. MIXITY_FUZZ_READER restricts inputs to one reader.
#include <cstdlib>

#include "fuzz_input.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return mixity::fuzz::fuzz_input(data, size);
}

/// Mutates an input, but keeps its first byte a valid reader: of random bytes, few are.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
  using mixity::fuzz::kReaders;
  static const char* const chosen = std::getenv("MIXITY_FUZZ_READER");
  const char first = size > 0 ? static_cast<char>(data[0]) : '\0';
  const std::size_t after = max_size > 1 ? LLVMFuzzerMutate(data + 1, size > 0 ? size - 1 : 0, max_size - 1) : 0;
  const bool known = kReaders.find(first) != std::string_view::npos && first != '\0';
  const char reader = chosen && *chosen ? *chosen : known ? first : kReaders[seed % kReaders.size()];
  data[0] = static_cast<std::uint8_t>(reader);
  return after + 1;
}
