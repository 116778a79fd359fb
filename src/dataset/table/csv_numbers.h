// Rows of numbers read where they stand: what nearly all of a large file is.
#pragma once

#include <string_view>
#include <vector>

#include "dataset/table/csv.h"

namespace mixity {

/// Takes rows of numbers off a text. It decides nothing: a row that it does not understand is left to whoever reads
/// rows one by one.
class NumberRows {
 public:
  NumberRows(const CsvWanted& wanted, const CsvFormat& format, const UseNumbers& use);

  /// Takes rows off the front of a text without quotes, up to one it does not understand, and hands them over. Returns
  /// how many. The first is on this line of the file.
  /// `end`: where the last whole line of the text ends.
  std::size_t take(std::string_view& text, const char* end, std::size_t line);

 private:
  struct Field {
    double* number = nullptr;  // where those of successive rows go
    std::string_view* text = nullptr;
    char behind = 0;
  };
  const char* row(const char* at, const char* end, std::size_t i);

  const CsvFormat& format_;
  const UseNumbers& use_;
  CsvNumbers rows_;
  std::vector<Field> fields_;
};

}  // namespace mixity
