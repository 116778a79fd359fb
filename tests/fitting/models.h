// Models by their keys, for tests.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "mechanics/contact_model.h"

namespace mixity {

inline ContactModel model_named(const std::string& key) { return ContactModel::find(key).value(); }

inline std::vector<std::string> published_keys() {
  std::vector<std::string> keys;
  for (const ContactModel& model : ContactModel::published()) keys.emplace_back(model.info().key);
  return keys;
}

/// ln f at one point.
inline double log_f(const ContactModel& model, const ParameterValues& p, const Mixity<double>& mixity) {
  double value = 0;
  model.log_toughness(p, {&mixity, 1}, {&value, 1}, {});
  return value;
}

/// A test of the model whose key is its parameter.
class OfModel : public ::testing::TestWithParam<std::string> {
 protected:
  std::string key() const { return GetParam(); }
  ContactModel model() const { return model_named(GetParam()); }
  std::size_t parameter_count() const { return model().parameters().size(); }
};

}  // namespace mixity
