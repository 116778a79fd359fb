#include "dataset/table/several_tables.h"

#include <algorithm>
#include <utility>

#include "base/input_error.h"
#include "base/text.h"
#include "dataset/table/header_lines.h"
#include "dataset/table/number.h"

namespace mixity {
namespace {

constexpr std::size_t kHead = 60;  // lines between two tables that are looked at

/// Whether its fields differ, as headings do: "OVL,OVL,OVL" is a row of an instrument that is overloaded.
bool has_different_words(const CsvRow& row) {
  std::string_view first;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (first.empty()) first = row[i];
    if (!row[i].empty() && row[i] != first) return true;
  }
  return false;
}

std::size_t count_numbers(const CsvRow& row) {
  std::size_t numbers = 0;
  for (std::size_t i = 0; i < row.size(); ++i) numbers += is_number(row[i]);
  return numbers;
}

/// The fields of a line as one text; empty if that is long.
std::string title_of(const CsvRow& line) {
  constexpr std::size_t kLongest = 40;
  std::string title;
  for (std::size_t i = 0; i < line.size(); ++i)
    if (!line[i].empty()) title += (title.empty() ? "" : " ") + std::string(line[i]);
  return title.size() <= kLongest ? printable(title, kLongest) : "";
}

std::string title_letters(const std::string& title) {
  std::string letters = folded(title);
  std::erase_if(letters, is_digit);
  return letters;
}

bool has_a_digit(const std::string& text) { return std::any_of(text.begin(), text.end(), is_digit); }

/// A line of a text, kept while it may belong to the head of a table.
struct HeadLine {
  CsvRow row;
  std::size_t offset;
};

/// Where a table lies in the text.
struct TablePart {
  std::size_t offset, line;             // of the first line of its head
  std::size_t headings, first_row = 0;  // lines; of a part without headings the same
  std::size_t row_offset = 0;           // of the first row
  std::size_t last_line = 0;
  std::string title;
  bool has_headings;
  std::vector<std::size_t> rows_above{};
  bool has_rows_as_before = false;
};

/// The line that may be the headings of a row; null if there is none.
const HeadLine* headings_above(const std::vector<HeadLine>& above, const CsvRow& row) {
  const std::size_t numbers = count_numbers(row);
  const auto found = std::find_if(above.rbegin(), above.rend(), [&](const HeadLine& line) {
    return !has_a_number(line.row) && !is_row_of_units(line.row, {}) && has_different_words(line.row) &&
           count_filled(line.row) + 1 >= numbers;
  });
  return found == above.rend() ? nullptr : &*found;
}

/// Finds where tables begin and end.
class TableParts {
 public:
  explicit TableParts(const ListingRules& rules) : rows_(rules.rows), title_(rules.title) {}

  void take(const CsvRow& row, std::size_t offset) {
    const bool may_be_data = is_row_of_numbers(row) && !(rows_ ? is_title(row, *rows_) : begins_with_words(row));
    const bool may_begin = may_be_data && !above_.empty();
    if (const HeadLine* const headings = may_begin ? headings_above(above_, row) : nullptr)
      begin(*headings, true, row);
    else if (may_begin && rows_ && repeats_title(above_.back()))
      begin(above_.back(), false, row);
    if (!may_be_data || !rows_) {
      if (above_.size() == kHead) above_.erase(above_.begin());
      above_.push_back({row, offset});
      return;
    }
    above_.clear();
    if (parts_.empty()) return;
    TablePart& last = parts_.back();
    if (last.first_row == 0) {
      rows_ = RowForm(row);
      last.first_row = row.line();
      last.row_offset = offset;
    }
    last.last_line = row.line();
  }

  /// Whether rows of the last table are being read, among which only other lines could begin another.
  bool goes_on() const { return rows_ && above_.empty(); }

  std::vector<TablePart> found() && { return std::move(parts_); }

 private:
  bool repeats_title(const HeadLine& line) const {
    const std::string title = title_of(line.row);
    return !title_.empty() && title != title_ && has_a_digit(title) && title_letters(title) == title_letters(title_);
  }

  /// Whether a line of the head has as many fields as the rows before, and a number: a row with a fault, or a summary.
  bool is_like_a_row(const HeadLine& line) const {
    return rows_ && line.row.size() == rows_->fields && has_a_number(line.row) &&
           count_filled(line.row) >= rows_->numbers && !repeats_title(line);
  }

  void begin(const HeadLine& headings, bool has_headings, const CsvRow& first_row) {
    std::string title;
    std::vector<std::size_t> rows_above;
    for (const HeadLine& line : above_)
      if (is_like_a_row(line)) rows_above.push_back(line.row.line());
    for (const HeadLine& line : above_) {
      const bool below = has_headings && line.row.line() >= headings.row.line();
      // "Run 1" alone in a line may also stand below the headings
      if (below && (line.row.line() == headings.row.line() || count_filled(line.row) != 1)) continue;
      if (is_row_of_units(line.row, {}) || (below && !has_a_digit(title_of(line.row)))) continue;
      title = title_of(line.row);
    }
    parts_.push_back({above_.front().offset, above_.front().row.line(), headings.row.line(), 0, 0, 0, title,
                      has_headings, std::move(rows_above), rows_ && rows_->fields == first_row.size()});
    title_ = title;
    rows_ = RowForm{};
  }

  std::vector<TablePart> parts_;
  std::vector<HeadLine> above_;  // lines of words since the last row of numbers
  std::optional<RowForm> rows_;  // of the table that goes on
  std::string title_;
};

/// Whether half of the headings, or two, have a known name or a unit.
bool are_known(const std::vector<Heading>& headings, const ColumnRules& rules) {
  std::size_t filled = 0, known = 0;
  for (std::size_t i = 0; i < headings.size(); ++i) {
    const Heading& heading = headings[i];
    filled += !heading.text.empty();
    const bool mapped = std::any_of(rules.mapping.begin(), rules.mapping.end(), [&](const auto& one) {
      return folded(split_heading(one.second, {}).name) == folded(heading.name);
    });
    known +=
        !heading.text.empty() && (mapped || column_named(heading.name) || rules.known_names().find(heading.name) ||
                                  rules.known_names().read(heading, i) || (heading.unit && parse_unit(*heading.unit)));
  }
  return known >= 2 || 2 * known >= filled;
}

}  // namespace

RowForm::RowForm(const CsvRow& row)
    : begins_with_words(mixity::begins_with_words(row)), numbers(count_numbers(row)), fields(row.size()) {}

bool is_title(const CsvRow& line, const RowForm& rows) {
  return !rows.begins_with_words && begins_with_words(line) && count_numbers(line) < rows.numbers;
}

std::vector<ListedTable> list_tables(std::string_view text, std::size_t first_line, const ListingRules& rules) {
  TableParts parts(rules);
  CsvSplitter splitter({}, rules.format, first_line);
  const std::size_t last = rules.whole && rules.whole->only_rows ? rules.whole->line : std::string::npos;
  try {
    std::string_view rest = text;
    for (CsvRow row; splitter.next(rest, true, row) && !(row.line() > last && parts.goes_on());)
      if (!row.is_comment()) parts.take(row, static_cast<std::size_t>(row.raw().data() - text.data()));
  } catch (const InputError&) {  // of quotes, which are reported when the rows are read
  }
  const std::vector<TablePart> found = std::move(parts).found();
  std::vector<ListedTable> tables;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const TablePart& part = found[k];
    ListedTable listed{{}, part.title, part.line, part.headings, part.last_line, part.rows_above};
    if (part.has_headings) {
      const std::size_t end = k + 1 < found.size() ? found[k + 1].offset : text.size();
      std::optional<Table> table;
      if (rules.whole && found.size() == 1 && part.offset == 0)
        table = *rules.whole;
      else
        try {
          table = find_table(rules.path, text.substr(part.offset, end - part.offset), rules.format.line_end,
                             rules.columns, rules.decimal);
        } catch (const InputError&) {  // of its units: its rows will not be understood
        }
      if (!table) continue;
      const std::size_t before = part.line - 1;
      table->offset += part.offset;
      for (std::size_t* const line : {&table->line, &table->header_line, &table->units_line, &table->summary_line})
        if (*line > 0) *line += before;
      for (std::size_t& line : table->passed_over) line += before;
      if (table->header_line > 0) listed.first_line = table->header_line;
      listed.may_be_a_remark =
          part.has_rows_as_before && table->units_line == 0 && !are_known(table->headings, rules.columns);
      listed.table = std::move(*table);
    } else {
      listed.table.format = rules.format;
      listed.table.offset = part.row_offset;
      listed.table.line = part.first_row;
    }
    tables.push_back(std::move(listed));
  }
  return tables;
}

bool same_headings(const Table& one, const Table& other) {
  return one.headings.empty() || other.headings.empty() ||
         std::equal(one.headings.begin(), one.headings.end(), other.headings.begin(), other.headings.end(),
                    [](const Heading& first, const Heading& second) {
                      return folded(first.name) == folded(second.name) && first.unit == second.unit;
                    });
}

std::string headings_text(const Table& table) {
  constexpr std::size_t kShown = 8;
  std::string text;
  for (std::size_t i = 0; i < table.headings.size(); ++i) {
    if (i == kShown) return text + ", ...";
    const Heading& heading = table.headings[i];
    text += (text.empty() ? "" : ", ") + printable(heading.name, 40);
    if (heading.unit) text += " [" + printable(*heading.unit, 20) + "]";
  }
  return text;
}

}  // namespace mixity
