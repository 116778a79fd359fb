#include "dataset/table/csv_numbers.h"

#include <charconv>
#include <cstdint>
#include <utility>

#include "base/trim.h"

namespace mixity {
namespace {

constexpr std::size_t kMostDigits = 19;  // the largest number of that many does not overflow yet
constexpr std::array<double, kMostDigits + 1> kPowersOfTen{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,
                                                           1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19};

/// The number at the front of a text that ends with a byte none can hold; where it ends, null if there is none. Digits
/// that make an integer below 2^53 over a power of ten that is a double, too, are one correctly rounded division away
/// from the nearest double; for others there is std::from_chars.
const char* read_number(const char* const begin, const char* end, char decimal, double& value) {
  const bool negative = *begin == '-';
  const char* at = begin + negative;
  std::uint64_t digits = 0;
  const auto take_digits = [&] {
    const char* const first = at;
    for (unsigned digit; (digit = static_cast<unsigned char>(*at) - unsigned{'0'}) < 10; ++at)
      digits = 10 * digits + digit;
    return static_cast<std::size_t>(at - first);
  };
  const std::size_t whole = take_digits();
  std::size_t decimals = 0;
  if (*at == decimal) {
    ++at;
    decimals = take_digits();
  }
  if (whole + decimals == 0) return nullptr;
  if (whole + decimals > kMostDigits || digits > (std::uint64_t{1} << 53) || (*at | 0x20) == 'e') {
    if (decimal != '.') return nullptr;
    const auto [behind, error] = std::from_chars(begin, end, value);
    return error == std::errc() ? behind : nullptr;
  }
  value = static_cast<double>(digits) / kPowersOfTen[decimals];
  if (negative) value = -value;
  return at;
}

}  // namespace

const CsvRow& CsvNumbers::row(std::size_t i) const {
  if (write_) {
    written_ = write_(i);
    row_.split(written_, line(i), format_);
    return row_;
  }
  const auto length = static_cast<std::size_t>(begins_[i + 1] - begins_[i]);
  row_.split({begins_[i], length}, line(i), format_);
  return row_;
}

NumberRows::NumberRows(const CsvWanted& wanted, const CsvFormat& format, const UseNumbers& use)
    : format_(format), use_(use), fields_(wanted.count) {
  rows_.format_ = format;
  rows_.numbers_.resize(wanted.numbers.size());
  rows_.texts_.resize(wanted.texts.size());
  for (std::size_t k = 0; k < wanted.numbers.size(); ++k) fields_[wanted.numbers[k]].number = rows_.numbers_[k].data();
  for (std::size_t k = 0; k < wanted.texts.size(); ++k) fields_[wanted.texts[k]].text = rows_.texts_[k].data();
  for (Field& field : fields_) field.behind = &field == &fields_.back() ? format.line_end : format.delimiter;
}

/// Reads a row as number i; where the next one begins, null if it is not understood.
const char* NumberRows::row(const char* at, const char* end, std::size_t i) {
  if (format_.comments && *at == '#') return nullptr;
  const bool blanks = format_.delimiter == kBlanks;
  const auto skip_blanks = [&] {
    const char* const first = at;
    while (*at == ' ' || (blanks && *at == '\t')) ++at;
    return at != first;
  };
  for (const Field& field : fields_) {
    if (blanks) skip_blanks();
    if (field.number) {
      skip_blanks();
      at = read_number(at, end, format_.decimal, field.number[i]);
      if (!at) return nullptr;
      if (skip_blanks() && blanks && field.behind == kBlanks) continue;
    } else {
      const char* const begin = at;
      while (*at != format_.delimiter && *at != '\n' && *at != '\r' && !(blanks && *at == '\t')) ++at;
      if (field.text) field.text[i] = trim({begin, static_cast<std::size_t>(at - begin)});
      if (blanks && skip_blanks() && field.behind == kBlanks) continue;
    }
    if (*at == '\r' && field.behind == '\n') ++at;
    if (*at++ != field.behind) return nullptr;
  }
  return at;
}

std::size_t NumberRows::take(std::string_view& text, const char* end, std::size_t line) {
  const char* at = text.data();
  std::size_t taken = 0;
  do {
    std::size_t& i = rows_.size_;
    for (i = 0; i < CsvNumbers::kMost && at < end; ++i) {
      const char* const next = row(at, end, i);
      if (!next) break;
      rows_.begins_[i] = std::exchange(at, next);
    }
    rows_.begins_[i] = at;
    rows_.first_line_ = line + taken;
    taken += i;
    if (i > 0) use_(rows_);
  } while (rows_.size_ == CsvNumbers::kMost);
  text.remove_prefix(static_cast<std::size_t>(at - text.data()));
  return taken;
}

}  // namespace mixity
