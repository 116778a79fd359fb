#include "dataset/table/channel_clocks.h"

#include <algorithm>
#include <cmath>

#include "base/input_error.h"
#include "base/number_text.h"
#include "base/text.h"
#include "base/units.h"

namespace mixity {
namespace {

/// Whether a unit is one of times, or missing: T (s) is no force T (N).
bool may_be_times(const Heading& heading) {
  const auto unit = heading.unit ? parse_unit(*heading.unit) : std::nullopt;
  return !heading.unit || (unit && unit->dimension == dimension::time);
}

/// The column of times; in a table that is no log, which needs none, the first that is named so.
std::optional<std::size_t> time_column(const std::vector<Heading>& headings, const Columns& columns,
                                       const ColumnRules& rules) {
  if (const Column* const time = columns.find(ColumnId::time)) return time->index;
  for (std::size_t i = 0; i < headings.size() && !rules.log; ++i) {
    if (const auto own = column_named(headings[i].name); own && own != ColumnId::time) continue;
    if (const auto read = rules.known_names().read(headings[i], i); read && read->id == ColumnId::time) return i;
  }
  return std::nullopt;
}

bool is_channel(ColumnId id) { return id < ColumnId::psi; }
bool is_size(ColumnId id) { return id != ColumnId::P && id != ColumnId::T; }

double factor_of(const Heading& heading) {
  const auto unit = heading.unit ? parse_unit(*heading.unit) : std::nullopt;
  return unit ? unit->factor : 1;
}

}  // namespace

std::vector<std::size_t> clocks_of_channels(const std::vector<Heading>& headings, std::size_t time) {
  const std::string letters = letters_of(headings[time].name);
  std::vector<std::size_t> clocks;
  for (std::size_t i = 0; i < headings.size(); ++i) {
    if (letters_of(headings[i].name) != letters || !may_be_times(headings[i])) continue;
    if (!clocks.empty() && clocks.back() + 1 == i) return {};
    clocks.push_back(i);
  }
  return clocks.size() < 2 || letters.empty() ? std::vector<std::size_t>{} : clocks;
}

std::optional<std::size_t> clock_of(const std::vector<Heading>& headings, std::size_t time, std::size_t first,
                                    std::size_t channel) {
  const std::vector<std::size_t> clocks = clocks_of_channels(headings, time);
  if (clocks.empty()) return std::nullopt;
  const auto behind = std::upper_bound(clocks.begin(), clocks.end(), channel);
  if (first > clocks.front()) return *(behind - 1);
  return behind == clocks.end() ? clocks.back() : *behind;
}

ChannelClocks::ChannelClocks(const std::string& path, const std::vector<Heading>& headings, const Columns& columns,
                             const ColumnRules& rules)
    : path_(path), log_(rules.log) {
  const auto time = time_column(headings, columns, rules);
  std::vector<Column> channels;
  for (const auto& column : columns.by_id)
    if (column && is_channel(column->id)) channels.push_back(*column);
  if (!time || channels.empty()) return;
  const auto by_place = [](const Column& one, const Column& other) { return one.index < other.index; };
  std::sort(channels.begin(), channels.end(), by_place);
  const std::size_t first = channels.front().index;
  const auto own = rules.log ? time : clock_of(headings, *time, first, first);
  if (!own) return;
  own_ = {*own, factor_of(headings[*own]), {}, false};
  name_ = printable(headings[*own].name, 40);
  for (const Column& channel : channels) {
    const auto clock = clock_of(headings, *time, first, channel.index);
    if (!clock || *clock == *own) continue;
    const auto known =
        std::find_if(others_.begin(), others_.end(), [&](const Clock& one) { return one.index == *clock; });
    Clock& other =
        known == others_.end() ? others_.emplace_back(Clock{*clock, factor_of(headings[*clock]), {}, true}) : *known;
    other.channels += (other.channels.empty() ? "" : ", ") + std::string(to_string(channel.id));
    other.only_sizes &= is_size(channel.id);
  }
}

void ChannelClocks::compare(const CsvRow& row) {
  constexpr double kShare = 0.01;  // of a step; less does not matter, and is how times are rounded
  const auto is_missing_in = [&](std::size_t i) { return i >= row.size() || row[i].empty(); };
  if (is_missing_in(own_.index)) return;
  double time = 0;
  const bool is_number = row.number(own_.index, time);
  time *= own_.factor;
  const double step = before_ ? std::abs(time - *before_) : 0;
  for (const Clock& other : others_) {
    double its = 0;
    if (is_missing_in(other.index)) continue;
    if (!is_number || !row.number(other.index, its)) {
      if (row[own_.index] != row[other.index]) refuse(row, other);
      continue;
    }
    const double apart = std::abs(its * other.factor - time);
    if (before_ && apart > kShare * step) refuse(row, other);  // a difference in the first row is seen in the second
  }
  if (is_number) before_ = time;
}

void ChannelClocks::refuse(const CsvRow& row, const Clock& other) const {
  const auto value = [&](std::size_t i) {
    double number = 0;  // a row of arrays has no text
    return row.number(i, number) ? rounded(number, 9) : printable(row[i], 40);
  };
  throw InputError(path_, row.place(other.index),
                   "the time of " + other.channels + " is " + value(other.index) + ", but column " +
                       std::to_string(own_.index + 1) + " '" + name_ + "' says " + value(own_.index) +
                       ": the channels have clocks of their own; resample them to one before the export, and export "
                       "one column of times" +
                       (log_ && other.only_sizes ? ", or export forces and areas as two files" : ""));
}

}  // namespace mixity
