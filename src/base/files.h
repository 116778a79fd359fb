// Whole files as text.
#pragma once

#include <cstddef>
#include <string>

namespace mixity {

/// The most bytes that are held at once: of a file that is read whole, or of one row of a table.
inline constexpr std::size_t kMostText = std::size_t{1} << 28;

/// The file's bytes. Throws InputError if it cannot be read or holds more than kMostText bytes.
std::string read_file(const std::string& path);

}  // namespace mixity
