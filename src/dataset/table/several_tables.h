// The tables of a file that has several: intervals, steps, blocks.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dataset/table/table.h"

namespace mixity {

struct ListedTable {
  Table table;                 // its offset counts in the text that was listed, its lines in the file
  std::string title;           // the words above the headings, "Interval 2"; empty if there are none
  std::size_t head_line = 0;   // of the first line of words above the headings, which is not part of a table before
  std::size_t first_line = 0;  // of the headings
  std::size_t last_line = 0;   // of the last row
  std::vector<std::size_t> rows_above{};  // lines of the head that look like rows of the table before
  /// Whether its headings may be a remark: they name nothing that is known, have no units, and rows as before follow.
  bool may_be_a_remark = false;
};

/// What the rows of a table look like, by its first.
struct RowForm {
  bool begins_with_words = false;  // in the first field that is filled
  std::size_t numbers = 0, fields = 0;
  RowForm() = default;
  explicit RowForm(const CsvRow& row);
};

/// Whether a line is no row of such a table but a title, "Interval;2;10;;": it begins with words where rows do not, and
/// has fewer numbers.
bool is_title(const CsvRow& line, const RowForm& rows);

/// How to split and read what follows.
struct ListingRules {
  const std::string& path;
  CsvFormat format;
  const ColumnRules& columns;
  char decimal = 0;               // as it is stated, else 0
  std::optional<RowForm> rows{};  // of the table that goes on where the text begins; null: none does
  std::string title{};            // of that table
  const Table* whole = nullptr;   // what find_table finds in the whole text, if that is known
};

/// The tables that begin in a text: lines of words with rows of as many numbers below them, which do not begin with
/// words. Without such a line, words
/// that are the title of the table before but for a number ("Segment 2") begin another one, without headings.
std::vector<ListedTable> list_tables(std::string_view text, std::size_t first_line, const ListingRules& rules);

/// Whether two tables have the same headings and units, or one has none.
bool same_headings(const Table& one, const Table& other);

/// "P [mN], T [mN], A [mm^2]".
std::string headings_text(const Table& table);

}  // namespace mixity
