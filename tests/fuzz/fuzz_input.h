// One function that calls every reader of user input, for the fuzzer and for the test of its corpus.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace mixity::fuzz {

/// The first byte of an input selects the reader of the rest: c rows of a CSV, d a data set (TOML, a line "---", CSV),
/// p peak forces (likewise), m metadata, f a fit definition, u units and numbers, i an import (x, y and loads in three
/// lines, then the export), l a law as a flag states it.
inline constexpr std::string_view kReaders = "cdpmfuil";

/// Aborts unless the reader throws only InputError, with one printable line that names the file, and accepts only input
/// that is finite and complete. Returns 0, as libFuzzer requires.
int fuzz_input(const std::uint8_t* bytes, std::size_t size);

}  // namespace mixity::fuzz
