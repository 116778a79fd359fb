#include "analysis/fit_definition.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "analysis/contact_shape.h"
#include "analysis/laws.h"
#include "analysis/settings.h"
#include "base/number_text.h"
#include "base/phrases.h"
#include "base/toml_file.h"
#include "fitting/constants.h"

namespace mixity {
namespace {

/// Reads one definition; errors state its path and the position of the node.
class Reader {
 public:
  explicit Reader(const std::string& path) : path_(path) {}

  FitRequest read() {
    Inputs inputs;
    const toml::table table = read_toml(path_, inputs);
    FitRequest request;
    request.inputs = inputs.files();
    request.path = path_;
    if (!table.contains("data") && !table.contains("runs") && states_constants(table))
      throw InputError(path_, "states how data are read, and no data: " + Remedy::set("definition", path_) +
                                  " beside a file reads it so");
    read_laws(table, request);  // first, since models may name them
    for (const auto& [key, node] : table) read_key(key, node, request);
    if (request.data_path.empty()) throw InputError(path_, "the key data is missing");
    if (table.contains("data") && table.contains("runs"))
      fail(*table.get("runs"), "data and runs both say which files: state one");
    take_shape(request);
    if (const auto wrong = contradiction(request))
      fail(*table.get(wrong->option), wrong->option + " " + wrong->problem);
    check_published(table, request);
    return request;
  }

 private:
  void read_key(const toml::key& key, const toml::node& node, FitRequest& request) const {
    const std::string name(key.str());
    if (name == "data")
      read_data(node, request);
    else if (name == "runs")
      read_runs(node, request);
    else if (name == "constants")
      read_constants(node, request);
    else if (name == "columns" && node.is_table())
      request.constants.emplace_back("columns", mapping_text(path_, *node.as_table()));
    else if (name == "source")
      request.source = text(node, "source");
    else if (name == "peaks")
      request.peaks_path = beside(node, "peaks");
    else if (name == "log_figures")
      read_log_figures(node, request);
    else if (name == "published")
      read_published(node, request);
    else if (std::any_of(settings().begin(), settings().end(), [&](const Setting& one) { return one.name == name; }))
      read_option(name, node, request);
    else if (name != "laws")
      fail_at_unknown(path_, key, known_keys());
  }

  static std::vector<std::string> known_keys() {
    std::vector<std::string> keys{"data", "runs", "columns"};
    for (const Setting& one : settings()) keys.push_back(one.name);
    for (const char* other : {"constants", "laws", "peaks", "log_figures", "source", "published"})
      keys.emplace_back(other);
    return keys;
  }

  /// Whether a key outside the tables is that of a constant, as in a definition of data.
  static bool states_constants(const toml::table& table) {
    return std::any_of(metadata_fields().begin(), metadata_fields().end(), [&](const MetadataField& field) {
      return field.name != "source" && field.name != "columns" && table.contains(field.name);
    });
  }

  template <class Placed>
  [[noreturn]] void fail(const Placed& node, const std::string& message) const {
    fail_at(path_, node, message);
  }

  /// A path relative to the definition's folder. Normalised, unless symbolic links make that another file.
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

  /// A file, a pattern, or a list of them. Several files form one data set.
  void read_data(const toml::node& node, FitRequest& request) const {
    const toml::array* const list = node.as_array();
    std::vector<std::string> files;
    for (std::size_t i = 0, n = list ? list->size() : 1; i < n; ++i) {
      const toml::node& pattern = list ? *list->get(i) : node;
      const std::string path = beside(pattern, "data");
      try {
        for (std::string& file : files_of(path)) files.push_back(std::move(file));
      } catch (const InputError& no_file) {
        fail(pattern, std::string("data: ") + no_file.what());
      }
    }
    if (files.empty()) fail(node, "data names no file");
    request.data_path = files.front();
    if (list || files.size() > 1)
      for (const std::string& file : files) request.runs.push_back({file});
  }

  void read_log_figures(const toml::node& node, FitRequest& request) const {
    if (!node.is_array()) fail(node, "log_figures must be a list of SVG files");
    for (const toml::node& entry : *node.as_array()) request.log_figures.push_back(beside(entry, "log_figures"));
  }

  /// [[runs]]: a file, and its name, load and sphere if they are stated.
  void read_runs(const toml::node& node, FitRequest& request) const {
    if (!node.is_array_of_tables()) fail(node, "runs must be tables, each written [[runs]]");
    for (const toml::node& entry : *node.as_array()) {
      RunFile run;
      for (const auto& [key, value] : *entry.as_table()) {
        if (key == "file")
          run.path = beside(value, "file");
        else if (key == "name")
          run.name = text(value, "name");
        else if (key == "load")
          run.load = text(value, "load");
        else if (key == "sphere")
          run.sphere = text(value, "sphere");
        else
          fail_at_unknown(path_, key, {"file", "name", "load", "sphere"});
      }
      if (run.path.empty()) fail(entry, "a run needs a file");
      Metadata scratch;
      for (const auto& [constant, stated] : {std::pair("load", run.load), std::pair("radius", run.sphere)})
        if (const std::string problem = stated.empty() ? "" : set_field(scratch, constant, stated); !problem.empty())
          fail(entry, problem);
      if (scratch.standard_error("radius") > 0)
        fail(entry, "the standard error of a sphere is that of the radius, a percentage of all: state it there");
      request.runs.push_back(run);
    }
    if (request.runs.empty()) fail(node, "runs names no file");
    request.data_path = request.runs.front().path;
  }

  std::string text(const toml::node& node, const std::string& key) const {
    if (!node.is_string()) fail(node, key + " must be a string");
    if (node.as_string()->get().find('\0') != std::string::npos) fail(node, key + " holds a NUL character");
    return node.as_string()->get();
  }

  /// The value as the text of an option: a list becomes comma-separated.
  std::string flag_text(const toml::node& node, const std::string& key) const {
    if (const toml::array* list = node.as_array()) {
      std::string joined;
      for (const toml::node& element : *list) joined += (joined.empty() ? "" : ",") + flag_text(element, key);
      return joined;
    }
    if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
    if (const auto* whole = node.as_integer()) return std::to_string(whole->get());
    if (const auto* number = node.as_floating_point()) return shortest(number->get());
    if (!node.is_string()) fail(node, key + " must be a string, a number, true, false or a list of strings");
    return text(node, key);
  }

  void read_option(const std::string& key, const toml::node& node, FitRequest& request) const {
    if (const std::string problem = set_option(request, key, flag_text(node, key)); !problem.empty())
      fail(node, key + " " + problem);
  }

  void read_laws(const toml::table& table, FitRequest& request) const {
    const toml::node* const node = table.get("laws");
    if (!node) return;
    if (!node->is_table()) fail(*node, "laws must be tables, each written [laws.KEY]");
    for (const DefinedLaw& defined : define_laws(path_, *node->as_table())) {
      const std::string& key = defined.law->definition().key;
      if (!table.contains("models")) request.models.push_back(key);
      for (const std::string& warning : defined.warnings) request.law_notes.push_back("law " + key + ": " + warning);
    }
  }

  void read_constants(const toml::node& node, FitRequest& request) const {
    if (!node.is_table()) fail(node, "constants must be a table");
    for (const auto& [key, value] : *node.as_table()) {
      const std::string name(key.str());
      std::string given = value.is_string() || value.is_number() ? flag_text(value, name) : text(value, name);
      if (const std::string problem = problem_of_constant(name, given); !problem.empty()) fail(value, problem);
      if (is_path(name)) given = beside(value, name);
      request.constants.emplace_back(name, given);
    }
  }

  double number(const toml::table& table, std::string_view key) const {
    const auto value = table[key].value<double>();
    if (!value || !std::isfinite(*value)) fail(table, "a published number needs value and tolerance, both numbers");
    return *value;
  }

  void read_published(const toml::node& node, FitRequest& request) const {
    if (!node.is_table()) fail(node, "published must be a table of models");
    for (const auto& [model, entries] : *node.as_table()) {
      if (!entries.is_table()) fail(entries, "published." + std::string(model.str()) + " must be a table");
      for (const auto& [name, value] : *entries.as_table()) {
        if (!value.is_table()) fail(value, std::string(name.str()) + " must be {value = ..., tolerance = ...}");
        const toml::table& table = *value.as_table();
        for (const auto& [key, ignored] : table)
          if (key != "value" && key != "tolerance") fail_at_unknown(path_, key, {"value", "tolerance"});
        const double tolerance = number(table, "tolerance");
        if (tolerance < 0) fail(value, "the tolerance of " + std::string(name.str()) + " is negative");
        request.published[std::string(model.str())].push_back(
            {std::string(name.str()), number(table, "value"), tolerance});
      }
    }
  }

  void check_published(const toml::table& table, const FitRequest& request) const {
    for (const auto& [model, published] : request.published) {
      if (!is_model(model))
        fail(*table.get("published"), "unknown model \"" + model + "\"" + known_names(model, known_models()));
      if (std::find(request.models.begin(), request.models.end(), model) == request.models.end())
        fail(*table.get("published"), "model " + model + " has published numbers and is not fitted");
      for (const Published& number : published)
        if (number.name != "r2" && number.name != "chi2" && !has_parameter({model}, number.name) &&
            !is_fitted_constant(number.name, request))
          fail(*table.get("published"), "model " + model + " has no parameter \"" + number.name + "\"");
    }
  }

  /// Whether the name is that of a free constant, or of one of a series: "toughness(2)".
  static bool is_fitted_constant(const std::string& name, const FitRequest& request) {
    const auto constant = constant_named(name.substr(0, name.ends_with(')') ? name.find('(') : name.npos));
    const auto& free = request.options.free;
    return constant && std::find(free.begin(), free.end(), *constant) != free.end();
  }

  const std::string& path_;
};

}  // namespace

FitRequest read_fit_definition(const std::string& path) { return Reader(path).read(); }

}  // namespace mixity
