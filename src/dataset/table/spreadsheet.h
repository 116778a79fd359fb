// Sheets of Excel workbooks (.xlsx) as text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"

namespace mixity {

struct ColumnRules;

/// Which sheet is read, and how.
struct SheetChoice {
  std::string sheet{};  // its name or number; empty: the first whose headings the rules know, or else with a table
  char decimal = 0;     // of numbers in cells of text: '.' or ',' if stated, else 0
  const ColumnRules* rules = nullptr;  // null: those of the shipped names
};

struct Sheet {
  /// Fields between tabs. Each line is a row of the sheet, so that both have the same number; a line end within a cell
  /// is a blank. Numbers have all their digits. Dates and times are those of ISO 8601.
  std::string text;
  std::string name;
  std::vector<Message> notes;
};

/// Whether a file that begins with these bytes is read by read_workbook.
bool is_workbook(std::string_view start);

/// Throws InputError for a file that is no .xlsx, is damaged or unpacks to more than Archive::kMostUnpacked; if the
/// sheet does not exist or is empty; and if it holds a formula whose value is not stored.
Sheet read_workbook(const std::string& path, std::string_view bytes, const SheetChoice& choice);

/// The format of a sheet's table, for people: "sheet 'Run 1', units in line 2".
std::string describe(const Sheet& sheet, const std::string& table);

}  // namespace mixity
