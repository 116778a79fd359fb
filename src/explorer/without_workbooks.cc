// What stands for dataset/table/spreadsheet.cc in a browser, which has no minizip.
#include "base/input_error.h"
#include "dataset/table/spreadsheet.h"

namespace mixity {

bool is_workbook(std::string_view start) {
  return start.starts_with("PK\x03\x04") || start.starts_with("\xD0\xCF\x11\xE0");
}

Sheet read_workbook(const std::string& path, std::string_view, const SheetChoice&) {
  throw InputError(path,
                   "is a workbook, which the page does not read: save its sheet as CSV (Excel: Save As, CSV UTF-8)");
}

std::string describe(const Sheet&, const std::string& table) { return table; }

}  // namespace mixity
