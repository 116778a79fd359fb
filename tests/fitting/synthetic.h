// Synthetic (psi, f) data of a model for tests.
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "dataset/dataset.h"
#include "fitting/models.h"

namespace mixity {

/// Points of a model at these angles, ln f shifted by noise(i).
inline Dataset synthetic(
    const std::string& model, const ParameterValues& p, const std::vector<double>& angles,
    const std::function<double(std::size_t)>& noise = [](std::size_t) { return 0.0; }) {
  Dataset data;
  data.path = data.name = "synthetic";
  data.curves = {""};
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const auto mixity = mixity_from_angle(angles[i]);
    data.points.push_back({i + 2, 0, 0, 0, 0});
    data.converted.push_back({mixity, std::exp(log_f(model_named(model), p, mixity) + noise(i))});
  }
  data.rows = angles.size();
  return data;
}

/// n angles from 0 to `last`, evenly.
inline std::vector<double> angles_up_to(double last, std::size_t n) {
  std::vector<double> angles;
  for (std::size_t i = 0; i < n; ++i) angles.push_back(last * static_cast<double>(i) / static_cast<double>(n - 1));
  return angles;
}

/// A fixed sequence that looks random and has mean near zero, in [-1, 1].
inline double scatter(std::size_t i) { return std::sin(static_cast<double>(12 * i * i + 7 * i)); }

}  // namespace mixity
