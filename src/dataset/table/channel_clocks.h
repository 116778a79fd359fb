// Tables with a column of times for each channel: "X_Value, Force, X_Value, Area".
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dataset/table/columns.h"
#include "dataset/table/csv.h"
#include "dataset/table/heading.h"

namespace mixity {

/// The columns of times that alternate with channels: named like `time`, except for a number. Empty if there is one, or
/// if two stand side by side.
std::vector<std::size_t> clocks_of_channels(const std::vector<Heading>& headings, std::size_t time);

/// The column of times that stands beside a channel; null if they do not alternate. `first`: the first channel that is
/// read; if it stands before all times, times follow their channels.
std::optional<std::size_t> clock_of(const std::vector<Heading>& headings, std::size_t time, std::size_t first,
                                    std::size_t channel);

/// Requires the channels of each row to have one time, as one row is read as one moment.
class ChannelClocks {
 public:
  ChannelClocks() = default;
  ChannelClocks(const std::string& path, const std::vector<Heading>& headings, const Columns& columns,
                const ColumnRules& rules);

  /// Throws InputError, and changes nothing, if the times differ by more than a hundredth of the step between rows.
  void take(const CsvRow& row) {
    if (!others_.empty()) compare(row);
  }

 private:
  struct Clock {
    std::size_t index;
    double factor;         // of its unit
    std::string channels;  // that it belongs to
    bool only_sizes;       // whether these are areas or lengths
  };
  void compare(const CsvRow& row);
  [[noreturn]] void refuse(const CsvRow& row, const Clock& other) const;

  std::string path_;
  Clock own_{};  // of the column that is read as the time
  std::vector<Clock> others_;
  std::string name_;
  bool log_ = false;
  std::optional<double> before_;  // the time of the row above
};

}  // namespace mixity
