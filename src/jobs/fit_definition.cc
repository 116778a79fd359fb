#include "jobs/fit_definition.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "dataset/toml_file.h"

namespace mixity {
namespace {

/// Reads one definition, with the file's name and the place of each node at hand for messages.
class Reader {
 public:
  explicit Reader(const std::string& path) : path_(path) {}

  FitJob read() {
    const toml::table table = read_toml(path_);
    FitJob job;
    job.path = path_;
    for (const auto& [key, node] : table) {
      if (key == "data")
        job.data_path = beside(node, "data");
      else if (key == "models")
        read_models(node, job);
      else if (key == "objective")
        job.options.objective = objective(node);
      else if (key == "scale")
        job.options.scale = scale(node);
      else if (key == "hold")
        read_hold(node, job);
      else if (key == "source")
        job.source = text(node, "source");
      else if (key == "peaks")
        job.peaks_path = beside(node, "peaks");
      else if (key == "published")
        read_published(node, job);
      else
        fail(key, "unknown key \"" + std::string(key.str()) +
                      "\" (known: data, models, objective, scale, hold, peaks, source, published)");
    }
    if (job.data_path.empty()) throw InputError(path_, "the key data is missing");
    if (job.models.empty()) job.models = {"a", "b", "c"};
    check_names(table, job);
    return job;
  }

 private:
  template <class Placed>
  [[noreturn]] void fail(const Placed& node, const std::string& message) const {
    fail_at(path_, node, message);
  }

  /// A path as written, against the definition's folder; shortened where that names the same file, which links may keep
  /// it from.
  std::string beside(const toml::node& node, const std::string& key) const {
    const std::string path = text(node, key);
    if (path.empty()) fail(node, key + " is empty");
    const std::filesystem::path whole = std::filesystem::path(path_).parent_path() / path,
                                brief = whole.lexically_normal();
    std::error_code none;
    const bool same = std::filesystem::exists(whole, none) ? std::filesystem::equivalent(whole, brief, none)
                                                           : !std::filesystem::exists(brief, none);
    return (same ? brief : whole).string();
  }

  std::string text(const toml::node& node, const std::string& key) const {
    if (!node.is_string()) fail(node, key + " must be a string");
    if (node.as_string()->get().find('\0') != std::string::npos) fail(node, key + " holds a NUL character");
    return node.as_string()->get();
  }

  std::vector<std::string> texts(const toml::node& node, const std::string& key) const {
    if (!node.is_array()) fail(node, key + " must be an array of strings");
    std::vector<std::string> result;
    for (const toml::node& element : *node.as_array()) result.push_back(text(element, key));
    return result;
  }

  Scale scale(const toml::node& node) const {
    const std::string name = text(node, "scale");
    for (const Scale candidate : {Scale::log, Scale::linear})
      if (name == to_string(candidate)) return candidate;
    fail(node, "scale is \"" + name + "\"; it must be log or linear");
  }

  Objective objective(const toml::node& node) const {
    const std::string name = text(node, "objective");
    const auto found = parse_objective(name);
    if (name == "area") fail(node, std::string(kNoAreaObjective));
    if (!found) fail(node, "unknown objective \"" + name + "\" (known: toughness, curve)");
    return *found;
  }

  void read_models(const toml::node& node, FitJob& job) const {
    const std::vector<std::string> models = texts(node, "models");
    if (models.empty()) fail(node, "models names no model");
    for (const std::string& model : models) {
      if (std::find(job.models.begin(), job.models.end(), model) != job.models.end())
        fail(node, "models names \"" + model + "\" twice");
      job.models.push_back(model);
    }
  }

  void read_hold(const toml::node& node, FitJob& job) const {
    std::vector<HeldParameter>& hold = job.options.hold;
    for (const std::string& entry : texts(node, "hold")) {
      const auto held = parse_held(entry);
      if (!held) fail(node, "hold: \"" + entry + "\" is neither a parameter nor PARAMETER=NUMBER");
      if (std::any_of(hold.begin(), hold.end(), [&](const HeldParameter& other) { return other.name == held->name; }))
        fail(node, "hold names \"" + held->name + "\" twice");
      hold.push_back(*held);
    }
  }

  double number(const toml::table& table, std::string_view key) const {
    const auto value = table[key].value<double>();
    if (!value || !std::isfinite(*value)) fail(table, "a published number needs value and tolerance, both numbers");
    return *value;
  }

  void read_published(const toml::node& node, FitJob& job) const {
    if (!node.is_table()) fail(node, "published must be a table of models");
    for (const auto& [model, entries] : *node.as_table()) {
      if (!entries.is_table()) fail(entries, "published." + std::string(model.str()) + " must be a table");
      for (const auto& [name, value] : *entries.as_table()) {
        if (!value.is_table()) fail(value, std::string(name.str()) + " must be {value = ..., tolerance = ...}");
        const toml::table& table = *value.as_table();
        for (const auto& [key, ignored] : table)
          if (key != "value" && key != "tolerance")
            fail(key, "unknown key \"" + std::string(key.str()) + "\" (known: value, tolerance)");
        const double tolerance = number(table, "tolerance");
        if (tolerance < 0) fail(value, "the tolerance of " + std::string(name.str()) + " is negative");
        job.published[std::string(model.str())].push_back({std::string(name.str()), number(table, "value"), tolerance});
      }
    }
  }

  void check_names(const toml::table& table, const FitJob& job) const {
    const std::vector<std::string> known = model_keys();
    const auto is_known = [&](const std::string& key) {
      return std::find(known.begin(), known.end(), key) != known.end();
    };
    for (const std::string& model : job.models)
      if (!is_known(model)) fail(*table.get("models"), "unknown model \"" + model + "\"");
    for (const HeldParameter& held : job.options.hold)
      if (!has_parameter(job.models, held.name))
        fail(*table.get("hold"), "no fitted model has a parameter \"" + held.name + "\"");
    for (const auto& [model, published] : job.published) {
      if (!is_known(model)) fail(*table.get("published"), "unknown model \"" + model + "\"");
      if (std::find(job.models.begin(), job.models.end(), model) == job.models.end())
        fail(*table.get("published"), "model " + model + " has published numbers and is not fitted");
      for (const Published& number : published)
        if (number.name != "r2" && !has_parameter({model}, number.name))
          fail(*table.get("published"), "model " + model + " has no parameter \"" + number.name + "\"");
    }
  }

  const std::string& path_;
};

}  // namespace

FitJob read_fit_definition(const std::string& path) { return Reader(path).read(); }

}  // namespace mixity
