// Parts that the C++ library of Debian's Emscripten lacks: conversion of doubles to and from text, bit_cast. Included
// before every file of the explorer's build, and nowhere else.
#pragma once

#include <fast_float/fast_float.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdio>
#include <cstdlib>

namespace std {  // NOLINT: other libraries define these here

inline from_chars_result from_chars(const char* first, const char* last, double& value,
                                    chars_format = chars_format::general) {
  double found = 0;
  const auto [end, error] = fast_float::from_chars(first, last, found);
  if (error != errc()) return {end, error};
  // beyond the range of doubles fast_float 3.9 gives 0 or infinity
  const bool number = isdigit(static_cast<unsigned char>(first[*first == '-'])) || first[*first == '-'] == '.';
  const bool vanished = found == 0 && any_of(first, find_if(first, end, [](char c) { return c == 'e' || c == 'E'; }),
                                             [](char c) { return c >= '1' && c <= '9'; });
  if (vanished || (number && __builtin_isinf(found))) return {end, errc::result_out_of_range};
  value = found;
  return {end, errc()};
}

/// The shortest text that reads back as the same number, without an exponent where that is no longer. What needs at
/// most 15 digits is what 15 digits say.
inline to_chars_result to_chars(char* first, char* last, double value) {
  const auto room = static_cast<size_t>(last - first);
  for (const int digits : {15, 16, 17}) {
    const char* const end = first + snprintf(first, room, "%.*e", digits - 1, value);
    double read = 0;
    if (digits < 17 && !(fast_float::from_chars(first, end, read).ec == errc() && read == value)) continue;
    const char *const power = find<const char*>(first, end, 'e'), *last_digit = power;
    if (power == end) return {first + (end - first), errc()};  // infinite, or not a number
    while (last_digit[-1] == '0' && last_digit - first > 1) --last_digit;
    const int needed =
        max(1, static_cast<int>(count_if<const char*>(first, last_digit, [](char c) { return c >= '0' && c <= '9'; })));
    const int exponent = atoi(power + 1), decimals = max(0, needed - 1 - exponent);
    const int plain = max(exponent, 0) + 1 + (decimals > 0) + decimals;
    const int short_form = needed + (needed > 1) + static_cast<int>(end - power);
    const int n = plain <= short_form ? snprintf(first, room, "%.*f", decimals, value)
                                      : snprintf(first, room, "%.*e", needed - 1, value);
    return {first + n, errc()};
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
