#include "dataset/table/spreadsheet.h"

#include <algorithm>

#include "base/input_error.h"
#include "dataset/table/sheet_rows.h"
#include "dataset/table/table.h"

namespace mixity {
namespace {

enum class Fit { empty, text, table, known };  // known: the headings of its table name quantities

/// How well the first rows of a sheet fit. A table that is refused fits, so that the refusal is told.
Fit fit_of(const Workbook& book, const Workbook::Sheet& sheet, const SheetChoice& choice) {
  constexpr std::size_t kSearched = std::size_t{1} << 16;
  const ColumnRules shipped;
  const ColumnRules& rules = choice.rules ? *choice.rules : shipped;
  const std::string& path = book.archive.path();
  try {
    const SheetRows rows = read_rows(book, sheet, choice.decimal, {}, kSearched);
    if (rows.text.find_first_not_of("\t\n") == std::string::npos) return Fit::empty;
    const auto table = find_table(path, rows.text, '\n', rules, choice.decimal);
    if (!table) return Fit::text;
    return number_columns(path, table->headings, rules).size() > 1 ? Fit::known : Fit::table;
  } catch (const InputError&) {
    return Fit::known;
  }
}

/// What chooses a sheet: its name, or its number if a shell reads other things in the name.
std::string typed(const Workbook& book, const Workbook::Sheet& sheet) {
  if (sheet.name.find_first_of("\"'\\`$!") == std::string::npos) return sheet.name;
  return std::to_string(&sheet - book.sheets.data() + 1);
}

/// The sheet that is read, with a note on others that fit as well.
const Workbook::Sheet& choose(const Workbook& book, const SheetChoice& choice, std::vector<Message>& notes) {
  if (!choice.sheet.empty()) return book.sheet(choice.sheet);
  if (book.sheets.size() == 1) return book.sheets[0];
  const Workbook::Sheet* best = nullptr;
  Fit most = Fit::empty;
  std::string others, another;
  for (const bool hidden : {false, true})
    for (const Workbook::Sheet& one : book.sheets) {
      if (one.hidden != hidden) continue;
      if (hidden && most >= Fit::table) break;
      const Fit fit = fit_of(book, one, choice);
      if (!best || fit > most) {
        best = &one;
        most = fit;
        others.clear();
        another.clear();
      } else if (fit == most && fit >= Fit::table) {
        others += (others.empty() ? "'" : ", '") + one.name + "'";
        if (another.empty()) another = typed(book, one);
      }
    }
  if (!others.empty())
    notes.push_back("sheet '" + best->name + "' is read; to read another (" + others +
                    "): " + Remedy::set("sheet", another));
  return *best;
}

}  // namespace

bool is_workbook(std::string_view start) {
  return start.starts_with("PK\x03\x04") || start.starts_with("\xD0\xCF\x11\xE0");
}

Sheet read_workbook(const std::string& path, std::string_view bytes, const SheetChoice& choice) {
  const Workbook book(path, bytes);
  Sheet made;
  const Workbook::Sheet& sheet = choose(book, choice, made.notes);
  made.name = sheet.name;
  SheetRows rows = read_rows(book, sheet, choice.decimal, {}, std::string::npos);
  if (rows.text.find_first_not_of("\t\n") == std::string::npos)
    throw InputError(path, "sheet '" + sheet.name + "' is empty");
  if (const SheetTraits traits = rows.traits; traits != SheetTraits{})
    rows = read_rows(book, sheet, choice.decimal, traits, std::string::npos);
  if (rows.hidden > 0)
    made.notes.push_back("sheet '" + sheet.name + "' has " + std::to_string(rows.hidden) + " hidden row" +
                         (rows.hidden == 1 ? "" : "s") + ", read like the others");
  if (const std::string& columns = rows.hidden_columns; !columns.empty())
    made.notes.push_back("sheet '" + sheet.name + "' has numbers in hidden columns, read like the others: " + columns);
  made.text = std::move(rows.text);
  return made;
}

std::string describe(const Sheet& sheet, const std::string& table) {
  const std::string_view tabs = "tabs";  // how the sheet's cells are parted here
  return "sheet '" + sheet.name + "'" + (table.starts_with(tabs) ? table.substr(tabs.size()) : ", " + table);
}

}  // namespace mixity
