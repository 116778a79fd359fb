// Data, starts and certified values of the NIST StRD sets, as they stand in tests/solver/nist.
#pragma once

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace mixity::nist {

inline std::vector<std::vector<std::string>> read_cells(const std::string& name) {
  std::ifstream file(std::string(MIXITY_ROOT "/tests/solver/nist/") + name + ".csv");
  if (!file) throw std::runtime_error("cannot read the NIST set " + name);
  std::vector<std::vector<std::string>> rows;
  std::string line, cell;
  std::getline(file, line);  // headings
  while (std::getline(file, line)) {
    rows.emplace_back();
    for (std::istringstream cells(line); std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

/// Decimal, as NIST prints them: a number of many digits must not pass through a double.
struct Set {
  std::string name;
  std::vector<std::string> y, values, standard_deviations;
  std::vector<std::vector<std::string>> x;  // one or two for each y
  std::vector<double> starts[2];
  std::string sum_of_squares;

  explicit Set(std::string of) : name(std::move(of)) {
    for (const auto& row : read_cells(name)) {
      y.push_back(row.at(0));
      x.emplace_back(row.begin() + 1, row.end());
    }
    for (const auto& row : read_cells("certified")) {
      if (row.at(0) != name) continue;
      if (row.at(1) == "sum_of_squares") {
        sum_of_squares = row.at(4);
        continue;
      }
      for (const std::size_t s : {0, 1}) starts[s].push_back(std::stod(row.at(2 + s)));
      values.push_back(row.at(4));
      standard_deviations.push_back(row.at(5));
    }
  }
};

/// Observations as numbers of type X, in what the model predicts: y, or a function of it.
template <class Model, class X>
struct Observations {
  std::vector<X> y;
  std::vector<std::vector<X>> x;

  explicit Observations(const Set& set) {
    const auto number = [](const std::string& text) {
      if constexpr (std::is_same_v<X, double>)
        return std::stod(text);
      else
        return X(text);
    };
    for (std::size_t i = 0; i < set.y.size(); ++i) {
      if constexpr (requires { Model::response(X{}); })
        y.push_back(Model::response(number(set.y[i])));
      else
        y.push_back(number(set.y[i]));
      x.emplace_back();
      for (const std::string& text : set.x[i]) x.back().push_back(number(text));
    }
  }
};

}  // namespace mixity::nist
