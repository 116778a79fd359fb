// Which loading run each row belongs to.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "base/number_text.h"
#include "dataset/dataset.h"

namespace mixity {

/// Loading runs by name, in the order in which the file comes to them. Rows of a run mostly follow each other.
class Runs {
 public:
  /// The run that the row's column names; failing that, points of equal load form one.
  std::size_t of(const std::optional<std::string_view>& name, const Point& point, const Dataset& data) {
    const double load = data.has_loads ? point.P : 0;
    if (!keys_.empty() && keys_[last_].given == name.has_value() &&
        (name ? *name == keys_[last_].name : load == last_load_))
      return last_;
    last_load_ = load;
    if (name) return last_ = index({std::string(*name), true}, load);
    return last_ = index({data.has_loads ? label(load, data.display) : "", false}, load);
  }
  /// Names by loads become those of what is turned round (P -> -P); loads() stay.
  void turn_loads(const Dataset& data) {
    for (std::size_t i = 0; i < keys_.size(); ++i)
      if (!keys_[i].given) keys_[i].name = label(0 - loads_[i], data.display);
  }
  /// A run may be given the name that another has by its load.
  struct Key {
    std::string name;
    bool given;
    bool operator<(const Key& other) const { return std::tie(name, given) < std::tie(other.name, other.given); }
  };
  /// The number of a run, a new one if there is none of this key.
  std::size_t index(const Key& key, double load) {
    const auto [found, is_new] = index_.try_emplace(key, keys_.size());
    if (is_new) {
      keys_.push_back(key);
      loads_.push_back(load);
    }
    return found->second;
  }
  const std::vector<Key>& keys() const { return keys_; }
  const std::vector<double>& loads() const { return loads_; }  // of each run's first point
  /// What readers see, no two the same.
  std::string shown(std::size_t i) const {
    const Key& key = keys_[i];
    return key.name + (!key.given && index_.contains({key.name, true}) ? " (not named)" : "");
  }

 private:
  static std::string label(double load, const DisplayUnits& units) {
    return "P=" + rounded(load * units.force_scale, 6) + (units.force.empty() ? "" : " " + units.force);
  }
  std::map<Key, std::size_t> index_;
  std::vector<Key> keys_;
  std::vector<double> loads_;
  std::size_t last_ = 0;
  double last_load_ = 0;
};

}  // namespace mixity
