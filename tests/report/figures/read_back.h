// What a figure's data file says, read back.
#pragma once

#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "report/figures/figure.h"

namespace mixity {

struct DataBlock {
  std::vector<std::vector<double>> rows;
  std::vector<std::string> hover;
  bool operator==(const DataBlock&) const = default;
};

inline std::vector<DataBlock> blocks_of(const std::string& data) {
  std::vector<DataBlock> blocks;
  std::istringstream in(data);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("# index")) blocks.emplace_back();
    if (line.empty() || line[0] == '#') continue;
    const std::size_t quote = line.find('"');
    if (quote != std::string::npos) blocks.back().hover.push_back(line.substr(quote + 1, line.size() - quote - 2));
    std::istringstream fields(line.substr(0, quote));
    blocks.back().rows.emplace_back();
    for (double value; fields >> value;) blocks.back().rows.back().push_back(value);
  }
  return blocks;
}

inline const Figure& figure_named(const std::vector<Figure>& figures, const std::string& name) {
  for (const Figure& figure : figures)
    if (figure.name == name) return figure;
  throw std::runtime_error("no figure " + name);
}

inline const Series& series_named(const Figure& figure, const std::string& label) {
  for (const Series& series : figure.series)
    if (series.label == label) return series;
  throw std::runtime_error("no series " + label + " in " + figure.name);
}

}  // namespace mixity
