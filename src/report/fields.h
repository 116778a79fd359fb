// Outputs by description: each type lists its fields once, with their names, meanings and values. The list gives both
// the JSON of a value and the JSON Schema of all values.
//
//   void describe(Fields<BudgetPart>& field) {
//     field("share", "part of the variance, 0 to 1", &BudgetPart::share);
//   }
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/light_function.h"
#include "base/message.h"
#include "report/json.h"

namespace mixity {

struct FitResult;
struct Analysis;

/// The fit and the data set of a value, which determine units and line numbers; null if there is none.
struct Within {
  const Analysis* result = nullptr;
  const FitResult* fit = nullptr;
};

/// A message in the wording that the request states.
std::string worded(const Message& message, const Within& within);

/// An object with these keys, which its schema does not list.
template <class Value>
using Named = std::vector<std::pair<std::string, Value>>;

/// A field that is omitted if it has no value. Fields of empty std::optional and null pointers are written as null.
template <class Value>
struct IfAny {
  std::optional<Value> value;
};

template <class T>
class Fields;

/// The list that describe(Fields<T>&) fills; that function must be declared before this is used.
template <class T>
const Fields<T>& fields() {
  static const Fields<T> all = [] {
    Fields<T> described;
    describe(described);
    return described;
  }();
  return all;
}

template <class Value, template <class...> class Template>
inline constexpr bool is_a = false;
template <template <class...> class Template, class... Arguments>
inline constexpr bool is_a<Template<Arguments...>, Template> = true;

template <class Value>
inline constexpr bool is_text = std::is_convertible_v<Value, std::string_view>;
template <class Value>
inline constexpr bool may_be_null = is_a<Value, std::optional> || is_a<Value, std::shared_ptr> ||
                                    (std::is_pointer_v<Value> && !is_text<Value>);
template <class Value>
inline constexpr bool is_named = is_a<Value, std::map>;
template <class Value>
inline constexpr bool is_named<Named<Value>> = true;

template <class Value>
inline constexpr bool is_list = is_a<Value, std::vector>;
template <class Value>
inline constexpr bool is_list<std::span<Value>> = true;

template <class Value>
Json json_of(const Value& value, const Within& within = {}) {
  if constexpr (is_a<Value, IfAny>) {
    return value.value ? json_of(*value.value, within) : Json(Json::value_t::discarded);
  } else if constexpr (may_be_null<Value>) {
    return value ? json_of(*value, within) : Json();
  } else if constexpr (is_named<Value>) {
    Json object = Json::object();
    for (const auto& [name, one] : value) object[name] = json_of(one, within);
    return object;
  } else if constexpr (is_list<Value>) {
    Json list = Json::array();
    for (const auto& one : value) list.push_back(json_of(one, within));
    return list;
  } else if constexpr (std::is_enum_v<Value>) {
    return to_string(value);
  } else if constexpr (is_text<Value> || std::is_arithmetic_v<Value>) {
    return value;
  } else if constexpr (std::is_same_v<Value, Message>) {
    return worded(value, within);
  } else {
    return fields<Value>().json(value, within);
  }
}

template <class Value>
Json schema_of() {
  if constexpr (is_a<Value, IfAny>) {
    return schema_of<typename decltype(Value::value)::value_type>();
  } else if constexpr (may_be_null<Value>) {
    Json schema = schema_of<std::remove_cvref_t<decltype(*std::declval<Value>())>>();
    if (schema.contains("enum"))
      schema["enum"].push_back(nullptr);
    else
      schema["type"] = {schema["type"], "null"};
    return schema;
  } else if constexpr (is_named<Value>) {
    return {
        {"type", "object"},
        {"additionalProperties", schema_of<std::remove_cvref_t<decltype(std::declval<Value>().begin()->second)>>()}};
  } else if constexpr (is_list<Value>) {
    return {{"type", "array"}, {"items", schema_of<typename Value::value_type>()}};
  } else if constexpr (std::is_enum_v<Value>) {
    Json names = Json::array();  // beyond the last enumerator to_string repeats a name
    for (int i = 0; std::find(names.begin(), names.end(), to_string(Value(i))) == names.end(); ++i)
      names.push_back(to_string(Value(i)));
    return {{"enum", names}};
  } else if constexpr (is_text<Value> || std::is_same_v<Value, Message>) {
    return {{"type", "string"}};
  } else if constexpr (std::is_same_v<Value, bool>) {
    return {{"type", "boolean"}};
  } else if constexpr (std::is_integral_v<Value>) {
    return {{"type", "integer"}, {"minimum", 0}};
  } else if constexpr (std::is_arithmetic_v<Value>) {
    return {{"type", "number"}};
  } else {
    return fields<Value>().schema();
  }
}

template <class T>
class Fields {
 public:
  /// Adds a field. `get`: a member of T, or a function of a const T& and, optionally, a const Within&. `limits`: JSON
  /// with additional keys of the schema.
  template <class Get>
  void operator()(const char* name, const char* meaning, const char* limits, Get get) {
    using Value = std::remove_cvref_t<decltype(got(get, std::declval<const T&>(), Within{}))>;
    list_.push_back({name, meaning, limits, !is_a<Value, IfAny>, &schema_of<Value>,
                     [get](const T& of, const Within& within) { return json_of(got(get, of, within), within); }});
  }
  template <class Get>
  void operator()(const char* name, const char* meaning, Get get) {
    (*this)(name, meaning, "{}", get);
  }

  /// Adds all fields of another type. `get` returns its value for a T.
  template <class Get>
  void all_of(Get get) {
    using Other = std::remove_cvref_t<std::invoke_result_t<Get, const T&>>;
    for (const auto& field : fields<Other>().list_)
      list_.push_back({field.name, field.meaning, field.limits, field.required, field.schema,
                       [get, &field](const T& of, const Within& within) {
                         const Other& other = get(of);
                         return field.read(other, Fields<Other>::entered(other, within));
                       }});
  }

  Json json(const T& value, const Within& within) const {
    const Within inside = entered(value, within);
    Json object = Json::object();
    auto& members = object.get_ref<Json::object_t&>();
    members.reserve(list_.size());
    for (const Field& field : list_)
      if (Json one = field.read(value, inside); !one.is_discarded()) members.emplace_back(field.name, std::move(one));
    return object;
  }

  Json schema() const {
    Json properties = Json::object(), required = Json::array();
    for (const Field& field : list_) {
      Json one = {{"description", field.meaning}};
      one.update(field.schema());
      one.update(Json::parse(field.limits));
      properties[field.name] = std::move(one);
      if (field.required) required.push_back(field.name);
    }
    return {{"type", "object"}, {"required", required}, {"additionalProperties", false}, {"properties", properties}};
  }

 private:
  template <class>
  friend class Fields;

  struct Field {
    const char *name, *meaning, *limits;
    bool required;
    Json (*schema)();
    LightFunction<Json(const T&, const Within&)> read;
  };

  template <class Get>
  static decltype(auto) got(const Get& get, const T& of, const Within& within) {
    if constexpr (std::is_invocable_v<const Get&, const T&, const Within&>)
      return std::invoke(get, of, within);
    else
      return std::invoke(get, of);
  }

  static Within entered([[maybe_unused]] const T& value, Within within) {
    if constexpr (std::is_same_v<T, Analysis>) within.result = &value;
    if constexpr (std::is_same_v<T, FitResult>) within.fit = &value;
    return within;
  }

  std::vector<Field> list_;
};

}  // namespace mixity
