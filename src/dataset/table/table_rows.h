// The rows of the table of a file, or of all its tables with the same headings.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dataset/table/csv_file.h"
#include "dataset/table/several_tables.h"

namespace mixity {

/// What becomes of the lines of a file.
class UseOfRows {
 public:
  UseOfRows() = default;
  UseOfRows(const UseOfRows&) = delete;
  UseOfRows& operator=(const UseOfRows&) = delete;
  virtual ~UseOfRows() = default;

  /// Throws InputError, and does nothing, for a row that cannot be understood.
  virtual void row(const CsvRow& row) = 0;
  virtual void comment(const CsvRow&) {}
  /// A line that is no row: of a summary or of words. `reason`: a fixed text.
  virtual void left_out(std::size_t line, std::string_view reason) = 0;
  /// Another table with the same headings begins.
  virtual void begin_table(const std::string& title) = 0;
};

class TableRows {
 public:
  struct Rules {
    const ColumnRules& columns;
    char decimal;                                 // as stated, else 0
    std::optional<std::size_t> wanted;            // the stated number of a table, from 1
    std::function<bool(const Table&)> is_usable;  // whether it has the columns that are needed
  };

  /// Finds the table. Of tables with different headings, the one that is wanted, else the only one that is usable.
  /// Throws InputError, which lists them, if there are several, and as find_table does.
  TableRows(const std::string& path, CsvFile& file, const Rules& rules);

  /// Null if none was found: then the first row is the headings.
  const std::optional<Table>& table() const { return table_; }
  const std::string& title() const { return title_; }  // of the first table
  const std::string& head() const { return head_; }    // the lines above its first row

  /// Reads all rows. Throws InputError for a row that is not understood, except for lines of words below the last one
  /// and between tables.
  void read(UseOfRows& use);

  // After read():
  std::size_t tables() const { return count_; }  // that were read
  /// Headings of tables that were not, with the line of each.
  const std::vector<std::pair<std::size_t, std::string>>& other_tables() const { return others_; }

 private:
  void choose(std::string_view start);
  void take(const ListedTable& chosen);
  void list_rest(const CsvRow& row);
  void require_one_kind(const std::vector<ListedTable>& found);
  void refuse_remarks(const std::vector<ListedTable>& found) const;
  bool use_listed(const CsvRow& row, UseOfRows& use);

  std::string path_;
  CsvFile& file_;
  Rules rules_;
  std::optional<Table> table_;
  std::string title_, head_;
  std::vector<ListedTable> kinds_;  // the first table of each
  std::vector<ListedTable> rest_;   // tables behind the first row that is not understood
  std::size_t next_ = 0;            // of rest_: the first that does not lie before the row
  std::size_t begun_ = 0;           // how many of rest_ began
  bool listed_ = false;
  RowForm form_;  // of the first row
  std::size_t count_ = 1;
  std::vector<std::pair<std::size_t, std::string>> others_;
};

/// "commas, headings in line 2, 3 tables".
std::string describe(const TableRows& rows);

}  // namespace mixity
