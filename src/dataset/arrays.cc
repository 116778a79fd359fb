#include "dataset/arrays.h"

#include <algorithm>

#include "base/number_text.h"
#include "dataset/collector.h"
#include "dataset/table/csv.h"

namespace mixity {

/// Rows of columns, handed over as those of a file are. It is written as text only where a row is read as one.
class ArrayRows {
 public:
  explicit ArrayRows(const std::vector<ArrayColumn>& columns) : columns_(columns) { format_.delimiter = kSeparator; }

  std::size_t size() const { return columns_[0].texts.empty() ? columns_[0].numbers.size() : columns_[0].texts.size(); }

  void read(const PointReader& reader, const Dataset& data, Part& part) {
    const std::size_t n = size();
    const CsvWanted* const wanted = reader.wanted();
    if (!wanted) {
      CsvRow row;
      std::string text;
      for (std::size_t i = 0; i < n; ++i) {
        text = written(i);
        row.split(text, i + kFirstLine, format_);
        part.row(reader, data, row);
      }
      return;
    }
    CsvNumbers numbers;
    numbers.format_ = format_;
    numbers.numbers_.resize(wanted->numbers.size());
    numbers.texts_.resize(wanted->texts.size());
    for (std::size_t first = 0; first < n; first += CsvNumbers::kMost) {
      numbers.first_line_ = first + kFirstLine;
      numbers.size_ = std::min(CsvNumbers::kMost, n - first);
      numbers.write_ = [&, first](std::size_t i) { return written(first + i); };
      for (std::size_t k = 0; k < wanted->numbers.size(); ++k) {
        const auto& values = columns_[wanted->numbers[k]].numbers;
        std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(first), numbers.size_, numbers.numbers_[k].begin());
      }
      for (std::size_t k = 0; k < wanted->texts.size(); ++k) take_texts(wanted->texts[k], first, k, numbers);
      part.numbers(reader, data, numbers);
    }
  }

 private:
  static constexpr char kSeparator = '\x1f';  // which no text has that can be shown
  static constexpr std::size_t kFirstLine = 2;

  void take_texts(std::size_t column, std::size_t first, std::size_t k, CsvNumbers& numbers) {
    const ArrayColumn& from = columns_[column];
    names_.clear();
    names_.reserve(numbers.size_);
    for (std::size_t i = 0; i < numbers.size_; ++i)
      numbers.texts_[k][i] =
          from.texts.empty() ? names_.emplace_back(shortest(from.numbers[first + i])) : from.texts[first + i];
  }

  std::string written(std::size_t i) const {
    std::string row;
    for (const ArrayColumn& column : columns_) {
      if (&column != &columns_.front()) row += kSeparator;
      row += column.texts.empty() ? shortest(column.numbers[i]) : printable(column.texts[i], std::string::npos);
    }
    return row;
  }

  const std::vector<ArrayColumn>& columns_;
  CsvFormat format_;
  std::vector<std::string> names_;
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
  ArrayRows rows(columns);
  std::vector<Heading> headings;
  for (const ArrayColumn& column : columns) {
    const std::size_t size = column.texts.empty() ? column.numbers.size() : column.texts.size();
    if (size != rows.size())
      throw InputError(name, "column '" + column.heading + "' has " + std::to_string(size) + " rows, '" +
                                 columns[0].heading + "' has " + std::to_string(rows.size()));
    headings.push_back(split_heading(column.heading, {1, headings.size() + 1}));
  }
  const PointReader reader(name, headings, data);
  data.taken = reader.taken();
  for (const ColumnKind& kind : kColumnKinds) {
    const Column* const column = kind.id == ColumnId::curve ? nullptr : reader.columns().find(kind.id);
    if (column && !columns[column->index].texts.empty())
      throw InputError(name, "column '" + columns[column->index].heading + "' holds texts where numbers are wanted");
  }
  Part part;
  part.clear(rows.size());
  rows.read(reader, data, part);
  part.shear = shear_ranges(part.points, part.runs.keys().size());
  Collector collector(data);
  collector.take(part);
  collector.finish(reader, name);
  return data;
}

}  // namespace mixity
