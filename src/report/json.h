// JSON values whose objects keep the order of their fields.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

namespace mixity {
namespace json_detail {  // of its own, so that nlohmann's search for to_json by argument does not find that of results

/// nlohmann::ordered_map is a vector of pairs with constant keys. Such pairs cannot be moved: each time it grows it
/// copies every value with all that this contains. Here the values are moved.
template <class Key, class Value, class Less, class Allocator>
class OrderedFields : public nlohmann::ordered_map<Key, Value, Less, Allocator> {
  using Base = nlohmann::ordered_map<Key, Value, Less, Allocator>;

 public:
  using Base::Base;

  template <class Name>
  auto emplace(Name&& name, Value&& value) {
    make_room();
    return Base::emplace(std::forward<Name>(name), std::move(value));
  }
  template <class Name>
  Value& operator[](Name&& name) {
    return emplace(std::forward<Name>(name), Value()).first->second;
  }

 private:
  void make_room() {
    if (this->size() < this->capacity()) return;
    Base larger;
    larger.reserve(std::max<std::size_t>(4, 2 * this->size()));
    for (auto& [key, value] : *this) static_cast<typename Base::Container&>(larger).emplace_back(key, std::move(value));
    this->swap(larger);
  }
};

}  // namespace json_detail

using Json = nlohmann::basic_json<json_detail::OrderedFields>;

}  // namespace mixity
