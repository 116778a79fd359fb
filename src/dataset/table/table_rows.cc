#include "dataset/table/table_rows.h"

#include <algorithm>
#include <utility>

#include "base/input_error.h"
#include "dataset/table/header_lines.h"
#include "dataset/table/number.h"

namespace mixity {
namespace {

constexpr std::size_t kListed = std::size_t{1} << 16;  // bytes at the start of the file
constexpr std::string_view kSummaryRow = "summary row (text where the rows above have numbers)",
                           kWordsBelow = "words below the table",
                           kWordsInRow = "words where the rows above have numbers";

/// The number of the kind of table; as many as there are if it is none of them.
std::size_t index_of_kind(const std::vector<ListedTable>& kinds, const Table& table) {
  const auto same = [&](const ListedTable& one) { return same_headings(one.table, table); };
  return static_cast<std::size_t>(std::find_if(kinds.begin(), kinds.end(), same) - kinds.begin());
}

void add_kinds(const std::vector<ListedTable>& found, std::vector<ListedTable>& kinds) {
  for (const ListedTable& one : found)
    if (!one.table.headings.empty() && index_of_kind(kinds, one.table) == kinds.size()) kinds.push_back(one);
}

std::string list_of_kinds(const std::vector<ListedTable>& kinds) {
  std::string text;
  for (std::size_t k = 0; k < kinds.size(); ++k)
    text += (text.empty() ? "" : "; ") + std::to_string(k + 1) + ", from line " + std::to_string(kinds[k].first_line) +
            ": " + headings_text(kinds[k].table);
  return text;
}

/// A quick look at its first byte.
bool may_be_words(const CsvRow& row) {
  return row.size() == 0 || row[0].empty() || !(is_digit(row[0][0]) || row[0][0] == '-' || row[0][0] == '.');
}

}  // namespace

TableRows::TableRows(const std::string& path, CsvFile& file, const Rules& rules)
    : path_(path), file_(file), rules_(rules) {
  const std::string_view start = file_.start();  // which finds the line ends
  table_ = find_table(path_, start, file_.line_end(), rules_.columns, rules_.decimal);
  if (!table_) return;
  choose(start);
  head_ = file_.start().substr(0, table_->offset);
  file_.begin_at(table_->offset, table_->line, table_->format);
}

void TableRows::choose(std::string_view start) {
  ListingRules listing{path_, table_->format, rules_.columns, table_->format.decimal, {}, {}, &*table_};
  if (start.size() > kListed) start = start.substr(0, start.find_last_of("\r\n", kListed) + 1);
  std::vector<ListedTable> found = list_tables(start, 1, listing);
  add_kinds(found, kinds_);
  if (rules_.wanted) {
    if (*rules_.wanted > kinds_.size()) {
      listing.whole = nullptr;  // it was found in the first lines
      found = list_tables(file_.rest_from(0), 1, listing);
      add_kinds(found, kinds_);
    }
    if (*rules_.wanted > kinds_.size())
      throw InputError(path_, "has no table " + std::to_string(*rules_.wanted) + "; there is " +
                                  (kinds_.empty() ? "only one" : list_of_kinds(kinds_)));
    return take(kinds_[*rules_.wanted - 1]);
  }
  refuse_remarks(found);
  const std::size_t own = index_of_kind(kinds_, *table_);
  const bool told = own < kinds_.size();
  if (!told) kinds_.insert(kinds_.begin(), {*table_, {}, 0, table_->header_line, table_->line});
  require_one_kind({});
  if (!told || found.size() < 2) {
    if (!found.empty()) title_ = found[0].title;
    return;
  }
  const auto usable =
      std::find_if(kinds_.begin(), kinds_.end(), [&](const ListedTable& one) { return rules_.is_usable(one.table); });
  take(usable == kinds_.end() ? kinds_[own] : *usable);
}

void TableRows::take(const ListedTable& chosen) {
  for (const ListedTable& one : kinds_)
    if (one.first_line < chosen.first_line) others_.emplace_back(one.first_line, headings_text(one.table));
  table_ = chosen.table;
  title_ = chosen.title;
}

void TableRows::require_one_kind(const std::vector<ListedTable>& found) {
  add_kinds(found, kinds_);
  if (rules_.wanted || kinds_.size() < 2) return;
  std::vector<std::size_t> usable;
  for (std::size_t k = 0; k < kinds_.size(); ++k)
    if (rules_.is_usable(kinds_[k].table)) usable.push_back(k);
  if (usable.size() > 1)
    throw InputError(path_, kinds_[usable[1]].first_line, 1,
                     "the file has tables with different headings: " + list_of_kinds(kinds_) +
                         "; say which to read: " + Remedy::set_or_key("table", std::to_string(usable[0] + 1)) +
                         ", or " + Remedy::set("table", std::to_string(usable[1] + 1)));
}

/// Refuses words between the rows of the table that is read, which would end it there.
void TableRows::refuse_remarks(const std::vector<ListedTable>& found) const {
  for (std::size_t k = 0; k < found.size(); ++k) {
    const ListedTable& one = found[k];
    const bool ends_ours = k > 0 ? same_headings(found[k - 1].table, *table_) : listed_;
    if (one.may_be_a_remark && ends_ours && !same_headings(one.table, *table_))
      throw InputError(path_, one.first_line, 1,
                       "the words '" + headings_text(one.table) +
                           "' stand between rows of one form: if they are a remark, put '#' before them; if they are "
                           "the headings of another table, " +
                           Remedy::set("table", std::to_string(index_of_kind(kinds_, *table_) + 1)) +
                           " reads the one above");
  }
}

/// Lists the tables from this row on, which is to be read again.
void TableRows::list_rest(const CsvRow& row) {
  listed_ = true;
  const std::size_t line = row.line(), offset = file_.offset_of(row);
  const std::string_view rest = file_.rest_from(offset);
  rest_ = list_tables(rest, line, {path_, table_->format, rules_.columns, table_->format.decimal, form_, title_});
  if (!rules_.wanted) refuse_remarks(rest_);
  require_one_kind(rest_);
  file_.begin_at(offset, line, table_->format);
}

void TableRows::read(UseOfRows& use) {
  std::optional<InputError> refusal;  // of the first line of words behind the first row
  std::vector<std::size_t> words;     // these lines, which are no rows at the end of the table
  std::size_t rows = 0;
  const std::size_t summary = table_ && file_.at_end() ? table_->summary_line : 0;
  for (CsvRow row; file_.next(row);) {
    if (row.is_comment()) {
      use.comment(row);
      continue;
    }
    if (listed_ && use_listed(row, use)) continue;
    if (summary > 0 && row.line() >= summary && !listed_) {
      use.left_out(row.line(), kSummaryRow);
      continue;
    }
    if (refusal && has_a_number(row)) throw *refusal;
    if (rows > 0 && !listed_ && table_ && !form_.begins_with_words && may_be_words(row) && is_title(row, form_)) {
      list_rest(row);
      continue;
    }
    try {
      use.row(row);
      if (rows++ == 0) form_ = RowForm(row);
    } catch (const InputError& error) {
      if (rows == 0) throw;
      if (!listed_ && table_) {
        list_rest(row);
        continue;
      }
      if (has_a_number(row)) throw;
      if (!refusal) refusal = error;
      words.push_back(row.line());
    }
  }
  for (const std::size_t line : words) use.left_out(line, kWordsBelow);
}

/// Uses a row of one of the tables that were listed, or of their heads. False if it is none.
bool TableRows::use_listed(const CsvRow& row, UseOfRows& use) {
  while (next_ < rest_.size() && row.line() > rest_[next_].last_line) ++next_;
  if (next_ == rest_.size()) {
    const bool below = !rest_.empty() && is_title(row, form_) && has_a_number(row);
    if (below) use.left_out(row.line(), kWordsBelow);
    return below;
  }
  const ListedTable& listed = rest_[next_];
  if (row.line() < listed.head_line) return false;
  if (row.line() < listed.table.line) {
    const bool is_row = std::count(listed.rows_above.begin(), listed.rows_above.end(), row.line()) > 0 &&
                        (next_ == 0 || same_headings(rest_[next_ - 1].table, *table_));
    if (is_row && begins_with_words(row))
      use.left_out(row.line(), kWordsInRow);
    else if (is_row)
      use.row(row);
    return true;
  }
  const bool ours = same_headings(listed.table, *table_), begins = begun_ != next_ + 1;
  begun_ = next_ + 1;
  if (begins && ours) {
    ++count_;
    use.begin_table(listed.title);
  } else if (begins) {
    others_.emplace_back(listed.first_line, headings_text(listed.table));
  }
  if (!ours) return true;
  if (listed.table.summary_line > 0 && row.line() >= listed.table.summary_line)
    use.left_out(row.line(), kSummaryRow);
  else
    use.row(row);
  return true;
}

std::string describe(const TableRows& rows) {
  std::string text = describe(*rows.table());
  if (rows.tables() > 1) text += ", " + std::to_string(rows.tables()) + " tables";
  return text;
}

}  // namespace mixity
