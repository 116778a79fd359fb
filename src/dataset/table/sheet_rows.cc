#include "dataset/table/sheet_rows.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <optional>

#include "base/input_error.h"
#include "base/number_text.h"
#include "base/units.h"
#include "dataset/table/csv.h"
#include "dataset/table/number.h"
#include "dataset/table/sheet_xml.h"

namespace mixity {
namespace {

constexpr std::size_t kMostRows = std::size_t{1} << 20, kMostColumns = std::size_t{1} << 14;  // of Excel

struct CellPlace {
  std::size_t column = 0, row = 0;  // from 0, from 1
};

/// "AB12" is column 27 in row 12. Null for anything else.
std::optional<CellPlace> parse_place(std::string_view text) {
  CellPlace place;
  std::size_t letters = 0;
  for (; letters < std::min<std::size_t>(text.size(), 3) && text[letters] >= 'A' && text[letters] <= 'Z'; ++letters)
    place.column = 26 * place.column + static_cast<std::size_t>(text[letters] - 'A') + 1;
  const char* const end = text.data() + text.size();
  const bool whole = std::from_chars(text.data() + letters, end, place.row).ptr == end;
  if (letters == 0 || !whole || place.column > kMostColumns || place.row < 1 || place.row > kMostRows)
    return std::nullopt;
  --place.column;
  return place;
}

/// A number as it is stored, in this decimal sign. A fourth decimal is added to three, which might be a group of
/// digits.
std::string number_field(std::string text, char decimal) {
  const std::size_t point = text.find('.');
  if (point == std::string::npos) return text;
  const std::size_t end = std::min(text.find_first_of("eE"), text.size());
  if (end - point == 4) text.insert(end, "0");
  text[point] = decimal;
  return text;
}

/// Days since the first day of the workbook as "2026-05-01T10:05:00.25", or without the date. `stored`: these days as
/// text. In a time with a date, doubles are good to 1 us, and to 10 us from writers that round them to 15 digits; such
/// remainders would make uneven steps of even ones.
std::string time_field(double days, std::string_view stored, bool dated, bool timed, int days_before_1970) {
  constexpr long long kSecond = 1000000, kDay = 86400 * kSecond;  // us
  const double whole = std::floor(days);
  long long time = std::llround((days - whole) * static_cast<double>(kDay));
  const long long even = (time + 5) / 10 * 10;
  const bool coarse = std::count_if(stored.begin(), stored.end(), is_digit) <= 15;
  if (dated && (coarse || std::abs(time - even) <= 1)) time = even;
  const long long day = static_cast<long long>(whole) + time / kDay;
  time %= kDay;
  std::string text;
  char part[40];
  if (dated) {
    using namespace std::chrono;
    const year_month_day date{sys_days{std::chrono::days{day - days_before_1970}}};
    std::snprintf(part, sizeof part, "%04d-%02u-%02u", static_cast<int>(date.year()),
                  static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
    text = part;
    if (time == 0 && !timed) return text;
    text += 'T';
  }
  const long long seconds = time / kSecond;
  std::snprintf(part, sizeof part, "%02lld:%02lld:%02lld.%06lld", seconds / 3600, seconds / 60 % 60, seconds % 60,
                time % kSecond);
  text += part;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

struct Cell {
  std::string text;
  bool is_number = false;
};

/// The name of a column, from 0: "A", "AB".
std::string letters(std::size_t column) {
  std::string name;
  for (++column; column > 0; column = (column - 1) / 26)
    name.insert(name.begin(), static_cast<char>('A' + (column - 1) % 26));
  return name;
}

class RowsReader {
 public:
  RowsReader(const Workbook& book, const Workbook::Sheet& sheet, char decimal, const SheetTraits& given)
      : book_(book), sheet_(sheet), stated_(decimal), given_(given), values_(given.merged.size()) {}

  SheetRows read(std::size_t bytes) {
    for_each_element(book_.archive, sheet_.part, {"col", "row", "mergeCell"}, [&](pugi::xml_node element) {
      const std::string_view name = local_name(element.name());
      if (name == "row")
        row(element);
      else if (name == "col")
        columns(element);
      else
        merged(element.attribute("ref").value());
      if (made_.text.size() > Archive::kMostUnpacked)
        throw InputError(book_.archive.path(), "holds more than 2 GB of text; save the columns that matter as CSV");
      return made_.text.size() < bytes;
    });
    for (const std::size_t column : numbers_)
      if (is_hidden(column)) made_.hidden_columns += (made_.hidden_columns.empty() ? "" : ", ") + letters(column);
    SheetTraits& traits = made_.traits;
    std::set_intersection(with_date_.begin(), with_date_.end(), without_date_.begin(), without_date_.end(),
                          std::inserter(traits.dated, traits.dated.end()));
    traits.decimal = stated_ ? stated_ : commas_ && !points_ ? ',' : '.';
    traits.one_column = width_ == 1;
    traits.width = uneven_ ? width_ : 0;
    return std::move(made_);
  }

 private:
  void columns(pugi::xml_node element) {
    if (element.attribute("hidden").as_bool())
      hidden_.emplace_back(element.attribute("min").as_uint(), element.attribute("max").as_uint());
  }
  bool is_hidden(std::size_t column) const {
    return std::any_of(hidden_.begin(), hidden_.end(),
                       [&](const auto& range) { return column + 1 >= range.first && column + 1 <= range.second; });
  }

  void row(pugi::xml_node element) {
    const std::size_t number = element.attribute("r").as_uint(static_cast<unsigned>(row_ + 1));
    if (number <= row_ || number > kMostRows) damaged("row " + std::to_string(number));
    made_.text.append(number - std::max<std::size_t>(row_, 1), '\n');
    row_ = number;
    cells_.clear();
    for (const pugi::xml_node one : element.children()) {
      if (local_name(one.name()) != "c") continue;
      std::size_t column = cells_.size();
      if (const std::string_view place = one.attribute("r").value(); !place.empty()) {
        const auto at = parse_place(place);
        if (!at || at->column < cells_.size() || at->row != row_) damaged("cell " + std::string(place));
        column = at->column;
      }
      if (column >= kMostColumns) damaged("row " + std::to_string(number));
      cells_.resize(column + 1);
      cells_[column] = cell(one, column);
    }
    while (!cells_.empty() && cells_.back().text.empty()) cells_.pop_back();
    const bool numbers = std::any_of(cells_.begin(), cells_.end(), [](const Cell& one) { return one.is_number; });
    for (std::size_t i = 0; i < cells_.size(); ++i)
      if (cells_[i].is_number) numbers_.insert(i);
    fill_merged(numbers);
    if (numbers && element.attribute("hidden").as_bool()) ++made_.hidden;
    if (cells_.size() > width_) {
      width_ = cells_.size();
      uneven_ |= after_numbers_;
    }
    after_numbers_ |= numbers;
    if (!cells_.empty()) cells_.resize(std::max(width_, given_.width));
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (i > 0) made_.text += '\t';
      // as in a file that a spreadsheet program writes, '#' in the first column begins a comment
      const std::string& text = cells_[i].text;
      made_.text += given_.one_column || (i == 0 && is_comment_) ? text : csv_field(text);
    }
  }

  Cell cell(pugi::xml_node node, std::size_t column) {
    const std::string_view type = node.attribute("t").as_string("n");
    std::string value = child_of(node, "v").child_value();
    if (column == 0) is_comment_ = false;
    if (child_of(node, "f") && type != "str" && (value.empty() || (book_.computed_when_opened && value == "0")))
      throw InputError(book_.archive.path(), row_, 0,
                       "sheet '" + sheet_.name + "', column " + std::to_string(column + 1) +
                           " holds a formula without its value: open the file in a spreadsheet program and save it");
    if (type == "s") {
      std::size_t index = 0;
      const char* const end = value.data() + value.size();
      if (value.empty()) return {};
      if (std::from_chars(value.data(), end, index).ptr != end || index >= book_.strings.size())
        damaged("row " + std::to_string(row_));
      value = book_.strings[index];
    } else if (type == "inlineStr") {
      value = text_of(child_of(node, "is"));
    } else if (double number = 0; type == "n" && parse_number(std::string_view(value), number)) {
      return {written(value, number, column, node.attribute("s").as_uint()), true};
    } else if (type == "b") {
      return {value, true};
    } else if (type == "e" || type == "d") {
      return {value, false};
    }
    return {text(std::move(value), column), false};
  }

  /// A cell of text as one line.
  std::string text(std::string value, std::size_t column) {
    for (char& c : value)
      if (static_cast<unsigned char>(c) < ' ') c = ' ';
    if (column == 0) is_comment_ = value.starts_with('#');
    if (value.find('%') != std::string::npos) in_percent_.insert(column);
    const auto is_only = [&](char decimal, char other) {
      double number = 0;
      NumberStyle style;
      return value.find(decimal) != std::string::npos && parse_number(value, decimal, number, &style) &&
             !style.grouped && !parse_number(value, other, number);
    };
    commas_ |= is_only(',', '.');
    points_ |= is_only('.', ',');
    return value;
  }

  std::string written(const std::string& value, double number, std::size_t column, unsigned style) {
    const CellFormat format = style < book_.styles.size() ? book_.styles[style] : CellFormat::number;
    if (format == CellFormat::percent && in_percent_.count(column))
      return number_field(shortest(100 * number), given_.decimal);
    constexpr double kLastDay = 2958466;  // of the year 9999
    if (format == CellFormat::number || format == CellFormat::percent || !(number >= 0 && number < kLastDay))
      return number_field(value, given_.decimal);
    const bool dated = number >= 1;
    (dated ? with_date_ : without_date_).insert(column);
    return time_field(number, value, dated || given_.dated.count(column) > 0, format == CellFormat::time,
                      book_.days_before_1970);
  }

  void merged(std::string_view range) {
    const auto first = parse_place(range.substr(0, range.find(':'))),
               last = parse_place(range.substr(std::min(range.find(':') + 1, range.size())));
    if (!first || !last) damaged("merged cells " + std::string(range));
    if (last->row > first->row) made_.traits.merged.push_back({first->column, first->row, last->row});
  }

  /// In rows of numbers, merged cells state their value once for all of their rows.
  void fill_merged(bool numbers) {
    for (std::size_t i = 0; i < given_.merged.size() && numbers; ++i) {
      const auto& [column, first_row, last_row] = given_.merged[i];
      if (row_ == first_row && column < cells_.size()) values_[i] = cells_[column];
      if (row_ <= first_row || row_ > last_row || values_[i].text.empty()) continue;
      if (column >= cells_.size()) cells_.resize(column + 1);
      if (cells_[column].text.empty()) cells_[column] = values_[i];
    }
  }

  [[noreturn]] void damaged(const std::string& where) const {
    throw InputError(book_.archive.path(), "is damaged: sheet '" + sheet_.name + "', " + where);
  }

  const Workbook& book_;
  const Workbook::Sheet& sheet_;
  char stated_;
  const SheetTraits& given_;
  std::vector<Cell> values_;  // of merged cells
  SheetRows made_;
  std::vector<Cell> cells_;
  std::size_t row_ = 0, width_ = 0;
  bool uneven_ = false, after_numbers_ = false;
  bool is_comment_ = false, commas_ = false, points_ = false;
  std::set<std::size_t> numbers_;                                // columns that have some
  std::vector<std::pair<std::size_t, std::size_t>> hidden_;      // first and last column, from 1
  std::set<std::size_t> with_date_, without_date_, in_percent_;  // columns
};

}  // namespace

SheetRows read_rows(const Workbook& book, const Workbook::Sheet& sheet, char decimal, const SheetTraits& given,
                    std::size_t bytes) {
  return RowsReader(book, sheet, decimal, given).read(bytes);
}

}  // namespace mixity
