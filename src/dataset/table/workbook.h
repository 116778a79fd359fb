// The parts of an Excel workbook (.xlsx, ECMA-376) that the cells of its sheets refer to.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "dataset/table/archive.h"

namespace mixity {

/// How a number is shown.
enum class CellFormat { number, percent, date, time };

/// By the code of a number format, such as "yyyy-mm-dd hh:mm:ss" or "0.00%".
CellFormat format_of(std::string_view code);

struct Workbook {
  struct Sheet {
    std::string name, part;
    bool hidden = false;
  };

  /// Throws InputError if the bytes are no .xlsx; the message says how to save the file.
  Workbook(const std::string& path, std::string_view bytes);

  /// The sheet of this name, or else of this number, which counts the sheets from 1. Throws InputError if there is
  /// none.
  const Sheet& sheet(const std::string& name) const;

  Archive archive;
  std::vector<Sheet> sheets;  // those with cells
  std::vector<std::string> strings;
  std::vector<CellFormat> styles;
  int days_before_1970 = 25569;       // from the first day of the workbook
  bool computed_when_opened = false;  // values of its formulas are not to be relied on
};

}  // namespace mixity
