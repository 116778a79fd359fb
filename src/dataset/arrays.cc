#include "dataset/arrays.h"

#include "base/number_text.h"
#include "base/text.h"
#include "dataset/collector.h"
#include "dataset/table/csv.h"

namespace mixity {

/// Presents columns as rows of a file. Numbers become text only in fields that are read as a name or a flag.
class ArrayRows {
 public:
  ArrayRows(const std::vector<ArrayColumn>& columns, const Columns& read) : columns_(columns) {
    for (const ColumnId id : {ColumnId::curve, ColumnId::include})
      if (const Column* column = read.find(id)) as_text_.push_back(column->index);
    row_.numbers_.resize(columns.size());
    row_.fields_.assign(columns.size(), "number");
    for (std::size_t k = 0; k < columns.size(); ++k)
      if (columns[k].heading.empty()) row_.fields_[k] = {};
  }

  const CsvRow& row(std::size_t i) {
    constexpr std::size_t kFirstLine = 2;  // below the header
    row_.line_ = i + kFirstLine;
    for (std::size_t k = 0; k < columns_.size(); ++k)
      if (columns_[k].texts.empty()) row_.numbers_[k] = columns_[k].numbers[i];
    row_.unquoted_.clear();
    for (const std::size_t k : as_text_)
      row_.fields_[k] = columns_[k].texts.empty() ? row_.unquoted_.emplace_back(shortest(columns_[k].numbers[i]))
                                                  : trim(columns_[k].texts[i]);
    return row_;
  }

 private:
  const std::vector<ArrayColumn>& columns_;
  std::vector<std::size_t> as_text_;
  CsvRow row_;
};

Dataset make_dataset(const std::string& name, const std::vector<ArrayColumn>& columns, const Overrides& constants) {
  Metadata metadata;
  apply_overrides(constants, metadata);
  require_whole_modulus(metadata, name, constants);
  return make_dataset(name, columns, metadata);
}

Dataset make_dataset(const std::string& name, const std::vector<ArrayColumn>& columns, const Metadata& metadata) {
  Dataset data;
  data.path = data.name = name;
  data.metadata = metadata;
  if (columns.empty()) throw InputError(name, "has no columns");
  const auto size_of = [](const ArrayColumn& column) {
    return column.texts.empty() ? column.numbers.size() : column.texts.size();
  };
  const std::size_t size = size_of(columns[0]);
  std::vector<Heading> headings;
  for (const ArrayColumn& column : columns) {
    if (size_of(column) != size)
      throw InputError(name, "column '" + column.heading + "' has " + std::to_string(size_of(column)) + " rows, '" +
                                 columns[0].heading + "' has " + std::to_string(size));
    headings.push_back(split_heading(column.heading, {1, headings.size() + 1}));
  }
  Inputs inputs;
  Collector collector("", headings, rules_of(metadata, inputs), std::nullopt, data);
  for (const std::optional<Column>& column : collector.columns().by_id)
    if (column && column->id != ColumnId::curve && !columns[column->index].texts.empty())
      throw InputError(name, "column '" + columns[column->index].heading + "' holds texts where numbers are wanted");
  data.points.reserve(size);
  ArrayRows rows(columns, collector.columns());
  for (std::size_t i = 0; i < size; ++i) collector.row(rows.row(i));
  collector.finish();
  return data;
}

}  // namespace mixity
