// Parts that the C++ library of Debian's Emscripten lacks: conversion of doubles to and from text, bit_cast. Included
// before every file of the explorer's build, and nowhere else.
#pragma once

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace std {  // NOLINT: other libraries define these here

inline from_chars_result from_chars(const char* first, const char* last, double& value,
                                    chars_format = chars_format::general) {
  char text[512];
  const auto n = min<size_t>(static_cast<size_t>(last - first), sizeof text - 1);
  memcpy(text, first, n);
  text[n] = 0;
  // strtod also accepts blanks and a plus sign before a number, and hexadecimal numbers
  const char* const digits = text + (text[0] == '-');
  if (!(isdigit(static_cast<unsigned char>(*digits)) || *digits == '.' || *digits == 'i' || *digits == 'n'))
    return {first, errc::invalid_argument};
  if (digits[0] == '0' && (digits[1] == 'x' || digits[1] == 'X')) {
    value = 0;
    return {first + (digits + 1 - text), errc()};
  }
  char* end = nullptr;
  const double found = strtod(text, &end);
  if (end == text) return {first, errc::invalid_argument};
  if (found > 1.7976931348623157e308 || found < -1.7976931348623157e308)
    if (*digits != 'i') return {first + (end - text), errc::result_out_of_range};
  value = found;
  return {first + (end - text), errc()};
}

/// The shortest text that reads back as the same number.
inline to_chars_result to_chars(char* first, char* last, double value) {
  for (int digits = 1; digits <= 17; ++digits) {
    const int n = snprintf(first, static_cast<size_t>(last - first), "%.*g", digits, value);
    if (digits == 17 || strtod(first, nullptr) == value) return {first + n, errc()};
  }
  return {first, errc::value_too_large};
}

inline to_chars_result to_chars(char* first, char* last, double value, chars_format format, int precision) {
  const int n = snprintf(first, static_cast<size_t>(last - first), format == chars_format::fixed ? "%.*f" : "%.*g",
                         precision, value);
  return {first + n, errc()};
}

template <class To, class From>
constexpr To bit_cast(const From& from) {
  return __builtin_bit_cast(To, from);
}

}  // namespace std
