// One entry to everything that reads what a user wrote, for a fuzzer and for the test that repeats what it found.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace mixity::fuzz {

/// First byte of an input: which reader gets the rest. c rows of a CSV, d a data set (TOML, a line "---", CSV), p peak
/// forces (likewise), m metadata, f a fit definition, u units and numbers, i an import (x, y and loads in three lines,
/// then the export), l a law as a flag has it.
inline constexpr std::string_view kReaders = "cdpmfuil";

/// Aborts if the reader breaks its word: it throws nothing but InputError, whose message is one printable line that
/// names the file, and what it accepts is finite and complete. Returns 0, as a fuzzer wants it.
int fuzz_input(const std::uint8_t* bytes, std::size_t size);

}  // namespace mixity::fuzz
