#include "analysis/laws.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>

#include "base/input_error.h"
#include "base/toml_file.h"
#include "fitting/options.h"
#include "mechanics/contact_model.h"
#include "mechanics/laws/known_laws.h"
#include "mechanics/laws/law_check.h"

namespace mixity {

extern const char* const kShippedLaws;  // data/laws.toml, made into a source file by CMake

namespace {

/// Defines a law and checks it. Throws LawError.
DefinedLaw define(const LawDefinition& definition) {
  if (!find_law(definition.key) && is_model(definition.key))
    throw LawError{{}, "'" + definition.key + "' is one of the published models: choose another key"};
  LawError error;
  const std::shared_ptr<const UserLaw> made = UserLaw::make(definition, error);
  if (!made) throw error;
  LawCheck check = check_law(*made);
  if (check.error) throw LawError{definition.sampler ? std::nullopt : std::optional<std::size_t>(0), *check.error};
  DefinedLaw defined{add_law(made, error), std::move(check.warnings)};
  if (!defined.law) throw error;
  return defined;
}

/// A law without a key becomes law_1, law_2, ...; the same law gets the same key again.
LawDefinition with_key(LawDefinition law) {
  if (!law.key.empty()) return law;
  for (std::size_t n = 1;; ++n) {
    law.key = "law_" + std::to_string(n);
    const auto known = find_law(law.key);
    if (!known || same_law(known->definition(), law)) return law;
  }
}

/// A law without a key gets a hash of its definition (FNV-1a), which is the same in every process. Functions, which
/// their text does not determine, get unique keys.
LawDefinition with_lasting_key(LawDefinition law) {
  if (!law.key.empty()) return law;
  LawDefinition stated = law;
  stated.sampler = nullptr;
  std::uint32_t hash = 2166136261U;
  for (const char c : law_toml(stated)) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  for (;; ++hash) {
    law.key = "law_";
    for (int shift = 28; shift >= 0; shift -= 4) law.key += "0123456789abcdef"[hash >> shift & 15U];
    const auto known = law.sampler ? find_law(law.key) : nullptr;
    if (!known || same_law(known->definition(), law)) return law;
  }
}

/// Reads laws from the table [laws] of a file.
class TomlReader {
 public:
  explicit TomlReader(const std::string& path) : path_(path) {}

  StatedLaw read(const toml::key& key, const toml::node& node) {
    const std::string law_key(key.str());
    if (!node.is_table()) fail_at(path_, node, "law " + law_key + " must be a table");
    StatedLaw stated{{law_key, {}}, {}};
    LawDefinition& law = stated.definition;
    std::map<toml::source_position, LawParameter> parameters;  // in the order of the file; a table is sorted by name
    text_ = nullptr;
    for (const auto& [name, value] : *node.as_table()) {
      if (name == "f" || name == "criterion") {
        if (text_) fail_at(path_, name, "a law is stated once: f or criterion");
        text_ = &value;
        law.text = string_of(name, value);
      } else if (name == "name") {
        law.name = string_of(name, value);
      } else if (name == "source") {
        stated.source = string_of(name, value);
      } else if (name == "normalised") {
        if (!value.is_boolean()) fail_at(path_, value, "normalised must be true or false");
        law.normalised = *value.value<bool>();
      } else {
        parameters.emplace(name.source().begin, parameter_of(name, value));
      }
    }
    if (!text_) fail_at(path_, node, "law " + law_key + " states no f");
    for (auto& [place, parameter] : parameters) law.parameters.push_back(std::move(parameter));
    return stated;
  }

  DefinedLaw define_one(const toml::key& key, const toml::node& node) {
    const LawDefinition law = read(key, node).definition;
    try {
      return define(law);
    } catch (const LawError& error) {
      if (!error.at) fail_at(path_, key, error.message);
      const auto quote = text_->source().begin;  // before the text
      throw InputError(path_, quote.line, quote.column + 1 + *error.at, error.message);
    }
  }

 private:
  std::string string_of(const toml::key& name, const toml::node& value) const {
    if (!value.is_string()) fail_at(path_, value, std::string(name.str()) + " must be a text in quotes");
    return value.as_string()->get();
  }

  double number_of(const toml::node* node, const toml::key& name) const {
    const auto value = node && node->is_number() ? node->value<double>() : std::nullopt;
    if (!value || !std::isfinite(*value))
      fail_at(path_, name,
              "parameter " + std::string(name.str()) +
                  " must be [least, greatest] or {range = [least, greatest], start = ...}");
    return *value;
  }

  LawParameter parameter_of(const toml::key& name, const toml::node& value) const {
    const toml::table* table = value.as_table();
    if (table)
      for (const auto& [key, ignored] : *table)
        if (key != "range" && key != "start") fail_at_unknown(path_, key, {"range", "start"});
    if (!table && !value.is_array())
      fail_at(
          path_, name,
          std::string(name.str()) +
              " is no parameter, which is [least, greatest]; else a law has f or criterion, name, source, normalised");
    const toml::array* range = table ? table->get_as<toml::array>("range") : value.as_array();
    if (!range || range->size() != 2) number_of(nullptr, name);
    const double lower = number_of(range->get(0), name), upper = number_of(range->get(1), name);
    const toml::node* start = table ? table->get("start") : nullptr;
    return {std::string(name.str()), lower, upper, start ? number_of(start, name) : usual_start(lower, upper)};
  }

  const std::string& path_;
  const toml::node* text_ = nullptr;
};

}  // namespace

DefinedLaw define_law_text(const std::string& what, std::string_view text) {
  std::size_t begin = 0;
  LawDefinition law = read_law_text(what, text, &begin);
  try {
    return define(with_key(std::move(law)));
  } catch (const LawError& error) {
    throw InputError(what, 1, error.at ? begin + *error.at + 1 : 1, error.message);
  }
}

DefinedLaw define_law_checked(const std::string& what, LawDefinition definition) {
  try {
    return define(with_lasting_key(std::move(definition)));
  } catch (const LawError& error) {
    throw InputError(what, error.at ? 1 : 0, error.at ? *error.at + 1 : 0, error.message);
  }
}

std::vector<DefinedLaw> define_laws(const std::string& path, const toml::table& laws) {
  std::vector<DefinedLaw> defined;
  TomlReader reader(path);
  for (const auto& [key, node] : laws) defined.push_back(reader.define_one(key, node));
  return defined;
}

bool is_model(std::string_view key) { return ContactModel::find(key).has_value(); }

void provide_law(std::string_view key) {
  for (const std::string_view ending : {kEqualEllipse, kEllipse})
    if (key.ends_with(ending)) key.remove_suffix(ending.size());
  if (is_model(key)) return;  // the file is read only when needed
  for (const StatedLaw& law : shipped_laws())
    if (law.definition.key == key) define(law.definition);
}

std::vector<std::string> known_models() {
  std::vector<std::string> keys = model_keys();
  for (const StatedLaw& law : shipped_laws())
    if (!find_law(law.definition.key)) keys.push_back(law.definition.key);
  return keys;
}

const std::vector<StatedLaw>& shipped_laws() {
  static const std::vector<StatedLaw> laws = [] {
    const std::string path = "data/laws.toml";
    const toml::table table = toml::parse(kShippedLaws);
    std::vector<StatedLaw> all;
    for (const auto& [key, node] : table) all.push_back(TomlReader(path).read(key, node));
    return all;
  }();
  return laws;
}

bool is_shipped(const UserLaw& law) {
  return std::any_of(shipped_laws().begin(), shipped_laws().end(), [&](const StatedLaw& one) {
    return same_law(one.definition, law.definition()) && one.definition.name == law.definition().name;
  });
}

}  // namespace mixity
