// One experiment as programs and laboratories export it.
#pragma once

#include <gtest/gtest.h>
#include <iconv.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <sstream>

#include "base/number_text.h"
#include "dataset/dataset.h"
#include "dataset/definition.h"
#include "dataset/temporary_folder.h"

namespace mixity {
namespace exports {

using Row = std::array<double, 3>;  // P and T in mN, A in mm^2

inline std::vector<Row> experiment() {
  std::vector<Row> rows;
  for (const double P : {4.68, 2.31, 0.95})
    for (const double T : {0.0, 1.5, 3.25, 5.125, 7.0})
      rows.push_back({P, T, 0.3 + 0.02 * P - 0.0004 * T * T / (1 + P)});
  return rows;
}

inline std::string with_comma(std::string number) {
  std::replace(number.begin(), number.end(), '.', ',');
  return number;
}

/// Lines of the experiment, each field as `field` writes it from what `convert` makes of a row.
struct Form {
  char separator = ',';
  std::function<std::string(double)> field = [](double value) { return shortest(value); };
  std::function<std::vector<double>(const Row&)> convert = [](const Row& row) {
    return std::vector<double>(row.begin(), row.end());
  };
};
inline std::string lines(const Form& form) {
  std::string text;
  for (const Row& row : experiment()) {
    std::string line;
    for (const double value : form.convert(row))
      line += (line.empty() ? "" : std::string(1, form.separator)) + form.field(value);
    text += line + "\n";
  }
  return text;
}
inline const auto kComma = [](double value) { return with_comma(shortest(value)); };
inline std::string german() { return lines({';', kComma}); }

inline std::string encoded(const std::string& text, const char* encoding) {
  const iconv_t state = iconv_open(encoding, "UTF-8");
  std::string in = text, out(4 * text.size() + 16, '\0');
  char *from = in.data(), *to = out.data();
  std::size_t left = in.size(), room = out.size();
  EXPECT_NE(iconv(state, &from, &left, &to, &room), static_cast<std::size_t>(-1));
  iconv_close(state);
  out.resize(out.size() - room);
  return out;
}

inline const Overrides kConstants{{"radius", "9.42 mm"}, {"modulus", "2.133 MPa"}, {"toughness", "27 mJ/m^2"}};

inline Overrides with(Overrides more) {
  more.insert(more.end(), kConstants.begin(), kConstants.end());
  return more;
}

/// The definition that is saved of a file reads the file to the same bits without any option but a load.
inline void expect_to_be_read_alike(const Dataset& data, const TemporaryFolder& folder, const std::string& name,
                                    const std::string& text) {
  const std::string path = folder.path("definition.toml"), definition = definition_text({understood(data)}, path);
  folder.write("definition.toml", definition);
  Overrides options{{"definition", path}};
  if (const auto load = stated_text(data.metadata, "load")) options.emplace_back("load", *load);
  Dataset again;
  try {
    again = load_dataset(folder.path(name), options);
  } catch (const InputError& error) {
    FAIL() << error.what() << "\n" << definition << text;
  }
  ASSERT_EQ(again.points.size(), data.points.size()) << definition << text;
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    const Point &one = data.points[i], &other = again.points[i];
    EXPECT_TRUE(one.P == other.P && one.T == other.T && one.A == other.A && one.curve == other.curve)
        << definition << text;
  }
  EXPECT_EQ(again.curves, data.curves) << definition;
  EXPECT_EQ(again.ignored_columns, data.ignored_columns) << definition;
  EXPECT_EQ(again.mapping, data.mapping) << definition;
}

/// 1e-12 is what conversions of units and the square of a radius may round away.
inline void expect_the_experiment(const std::string& text, const Overrides& more = {},
                                  const std::string& name = "a.csv") {
  const TemporaryFolder folder;
  Dataset data;
  try {
    data = load_dataset(folder.write(name, text), with(more));
  } catch (const InputError& error) {
    FAIL() << error.what() << "\n" << text;
  }
  const auto rows = experiment();
  ASSERT_EQ(data.points.size(), rows.size()) << text;
  ASSERT_TRUE(data.contact) << text;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto near = [&](double found, double wanted) {
      EXPECT_NEAR(found, wanted, 1e-12 * std::abs(wanted)) << text;
    };
    near(data.points[i].P * data.contact->force_unit(), 1e-3 * rows[i][0]);
    near(data.points[i].T * data.contact->force_unit(), 1e-3 * rows[i][1]);
    near(data.points[i].A * data.contact->area_unit(), 1e-6 * rows[i][2]);
  }
  expect_to_be_read_alike(data, folder, name, text);
}

}  // namespace exports
}  // namespace mixity
