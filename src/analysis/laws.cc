#include "analysis/laws.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "base/input_error.h"
#include "base/number_text.h"
#include "base/text.h"
#include "base/toml_file.h"
#include "fitting/options.h"
#include "mechanics/contact_model.h"
#include "mechanics/laws/known_laws.h"
#include "mechanics/laws/law_check.h"

namespace mixity {

extern const char* const kShippedLaws;  // data/laws.toml, made into a source file by CMake

namespace {

struct Failure {
  std::optional<std::size_t> at;  // in the text of the law
  std::string message;
};

/// The law, defined and checked, or why not.
std::optional<DefinedLaw> define(const LawDefinition& definition, Failure& failure) {
  if (!find_law(definition.key) && is_model(definition.key)) {
    failure = {{}, "'" + definition.key + "' is one of the published models: choose another key"};
    return std::nullopt;
  }
  LawError error;
  const std::shared_ptr<const ExpressionLaw> made = ExpressionLaw::make(definition, error);
  if (!made) {
    failure = {error.at, error.message};
    return std::nullopt;
  }
  LawCheck check = check_law(*made);
  if (check.error) {
    failure = {definition.sampler ? std::nullopt : std::optional<std::size_t>(0), *check.error};
    return std::nullopt;
  }
  DefinedLaw defined{add_law(made, error), std::move(check.warnings)};
  if (!defined.law) {
    failure = {{}, error.message};
    return std::nullopt;
  }
  return defined;
}

/// One without a key becomes law_1, law_2, ..., which the same law has again.
LawDefinition with_key(LawDefinition law) {
  if (!law.key.empty()) return law;
  for (std::size_t n = 1;; ++n) {
    law.key = "law_" + std::to_string(n);
    const auto known = find_law(law.key);
    if (!known || same_law(known->definition(), law)) return law;
  }
}

/// The same with one that follows from what the law says (FNV-1a), in whatever process and order it is defined; of
/// functions, whose text says little, each has its own.
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

class TomlReader {
 public:
  explicit TomlReader(const std::string& path) : path_(path) {}

  LawDefinition read(const toml::key& key, const toml::node& node, std::string* source = nullptr) {
    if (!node.is_table()) fail_at(path_, node, "law " + std::string(key.str()) + " must be a table");
    LawDefinition law;
    law.key = std::string(key.str());
    text_ = nullptr;
    for (const auto& [name, value] : *node.as_table()) {
      if (name == "f" || name == "criterion") {
        if (text_) fail_at(path_, name, "a law is stated once: f or criterion");
        text_ = &value;
        law.text = string_of(name, value);
      } else if (name == "name") {
        law.name = string_of(name, value);
      } else if (name == "source") {
        const std::string told = string_of(name, value);
        if (source) *source = told;
      } else if (name == "normalised") {
        if (!value.is_boolean()) fail_at(path_, value, "normalised must be true or false");
        law.normalised = *value.value<bool>();
      } else {
        law.parameters.push_back(parameter_of(name, value));
      }
    }
    if (!text_) fail_at(path_, node, "law " + law.key + " states no f");
    // in the order in which they are written
    std::sort(law.parameters.begin(), law.parameters.end(), [&](const LawParameter& one, const LawParameter& other) {
      const auto place = [&](const std::string& parameter) {
        const auto source_of = node.as_table()->find(parameter)->first.source().begin;
        return std::pair(source_of.line, source_of.column);
      };
      return place(one.name) < place(other.name);
    });
    return law;
  }

  DefinedLaw define_one(const toml::key& key, const toml::node& node) {
    const LawDefinition law = read(key, node);
    Failure failure;
    if (auto defined = define(law, failure)) return std::move(*defined);
    if (!failure.at) fail_at(path_, key, failure.message);
    auto place = text_->source().begin;  // of the opening quote
    throw InputError(path_, place.line, place.column + static_cast<toml::source_index>(1 + *failure.at),
                     failure.message);
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
        if (key != "range" && key != "start")
          fail_at(path_, key, "unknown key \"" + std::string(key.str()) + "\" (known: range, start)");
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

const toml::table& shipped() {
  static const toml::table table = toml::parse(kShippedLaws);
  return table;
}

}  // namespace

double usual_start(double lower, double upper) {
  return lower > 0 && upper > 20 * lower ? std::sqrt(lower * upper) : 0.5 * (lower + upper);
}

LawDefinition read_law_text(const std::string& what, std::string_view text, std::size_t* expression_at) {
  const auto fail = [&](std::size_t at, const std::string& message) { throw InputError(what, 1, at + 1, message); };
  const std::size_t colon = text.find(':');
  std::size_t begin = colon == std::string_view::npos ? 0 : colon + 1;
  LawDefinition law;
  law.key = trim(text.substr(0, begin == 0 ? 0 : colon));
  const std::size_t end = std::min(text.find(';', begin), text.size());
  // also as laws are shown: f = ...
  if (const std::string_view shown = trim(text.substr(begin, end - begin));
      shown.starts_with('f') && trim(shown.substr(1)).starts_with('='))
    begin = text.find('=', begin) + 1;
  while (begin < end && text[begin] == ' ') ++begin;
  law.text = trim(text.substr(begin, end - begin));
  for (std::size_t at = end; at < text.size();) {
    const std::size_t from = at + 1, next = std::min(text.find_first_of(",;", from), text.size());
    const std::string_view item = trim(text.substr(from, next - from));
    at = next;
    if (item.empty() && next == text.size()) break;
    const std::size_t equals = item.find('='), dots = item.find("..");
    if (item == "normalised" ||
        (trim(item.substr(0, equals)) == "normalised" && trim(item.substr(equals + 1)) == "true")) {
      law.normalised = true;
      continue;
    }
    const std::size_t word = item.find(" start");
    if (equals == std::string_view::npos || dots == std::string_view::npos || dots < equals)
      fail(from,
           "'" + std::string(item) + "' is no parameter: name=least..greatest, with start VALUE behind it if need be");
    const auto lower = parse_number(trim(item.substr(equals + 1, dots - equals - 1)));
    const std::string_view last = trim(item.substr(dots + 2, word == std::string_view::npos ? word : word - dots - 2));
    const auto upper = parse_number(last);
    std::string_view begins = word == std::string_view::npos ? "" : trim(item.substr(word + 6));
    if (begins.starts_with('=')) begins = trim(begins.substr(1));
    const auto start = parse_number(begins);
    const std::string name(trim(item.substr(0, equals)));
    const bool three_dots = item.substr(dots).starts_with("...");
    if (three_dots || !lower || !upper || !std::isfinite(*lower) || !std::isfinite(*upper))
      fail(from, "the range of '" + name + "' must be two numbers: least..greatest");
    if (word != std::string_view::npos && !start)
      fail(from, "the start of '" + name + "' must be a number: least..greatest start VALUE");
    law.parameters.push_back({name, *lower, *upper, start.value_or(usual_start(*lower, *upper))});
  }
  if (colon != std::string_view::npos && law.key.empty()) fail(0, "there is no key before the colon");
  if (expression_at) *expression_at = begin;
  return law;
}

DefinedLaw define_law_text(const std::string& what, std::string_view text) {
  std::size_t begin = 0;
  LawDefinition law = read_law_text(what, text, &begin);
  Failure failure;
  auto defined = define(with_key(std::move(law)), failure);
  if (!defined) throw InputError(what, 1, failure.at ? begin + *failure.at + 1 : 1, failure.message);
  return std::move(*defined);
}

DefinedLaw define_law_checked(const std::string& what, LawDefinition definition) {
  Failure failure;
  auto defined = define(with_lasting_key(std::move(definition)), failure);
  if (!defined) throw InputError(what, failure.at ? 1 : 0, failure.at ? *failure.at + 1 : 0, failure.message);
  return std::move(*defined);
}

std::vector<DefinedLaw> define_laws(const std::string& path, const toml::table& laws) {
  std::vector<DefinedLaw> defined;
  TomlReader reader(path);
  for (const auto& [key, node] : laws) defined.push_back(reader.define_one(key, node));
  return defined;
}

std::string law_toml(const LawDefinition& law) {
  if (law.sampler)
    throw InputError("law " + law.key, "is a function, " + law.text +
                                           ": it has no text that a file could hold; state it as an expression");
  std::string text = "[laws." + law.key + "]\n";
  if (!law.name.empty()) text += "name = " + toml_text(law.name) + '\n';
  text += (law.text.find('=') == std::string::npos ? "f = " : "criterion = ") + toml_text(law.text) + '\n';
  for (const LawParameter& one : law.parameters)
    text += one.name + " = { range = [" + shortest(one.lower) + ", " + shortest(one.upper) +
            "], start = " + shortest(one.start) + " }\n";
  return text + (law.normalised ? "normalised = true\n" : "");
}

std::string law_text(const LawDefinition& law) {
  std::string text = law.text;
  for (const LawParameter& one : law.parameters) {
    text += "; " + one.name + "=" + shortest(one.lower) + ".." + shortest(one.upper);
    if (one.start != usual_start(one.lower, one.upper)) text += " start " + shortest(one.start);
  }
  return text + (law.normalised ? "; normalised" : "");
}

bool is_model(std::string_view key) { return ContactModel::find(key).has_value(); }

void provide_law(std::string_view key) {
  if (is_model(key)) return;  // the file is read only where it is needed
  const auto found = shipped().find(key);
  if (found != shipped().end()) TomlReader("data/laws.toml").define_one(found->first, found->second);
}

std::vector<std::string> known_models() {
  std::vector<std::string> keys = model_keys();
  for (const ShippedLaw& law : shipped_laws())
    if (!find_law(law.key)) keys.push_back(law.key);
  return keys;
}

const std::vector<ShippedLaw>& shipped_laws() {
  static const std::vector<ShippedLaw> laws = [] {
    std::vector<ShippedLaw> all;
    const std::string path = "data/laws.toml";
    TomlReader reader(path);
    for (const auto& [key, node] : shipped()) {
      ShippedLaw one;
      const LawDefinition law = reader.read(key, node, &one.source);
      one.key = law.key;
      one.name = law.name;
      one.shown = law.text.find('=') == std::string::npos ? "f = " + law.text : law.text;
      one.parameters = law.parameters;
      all.push_back(std::move(one));
    }
    return all;
  }();
  return laws;
}

bool is_shipped(const ExpressionLaw& law) {
  const std::string& key = law.definition().key;
  const auto found = shipped().find(key);
  if (found == shipped().end() || law.definition().sampler) return false;
  const std::string path = "data/laws.toml";
  return law_toml(TomlReader(path).read(found->first, found->second)) == law_toml(law.definition());
}

}  // namespace mixity
