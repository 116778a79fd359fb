// Data sets.
#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "base/nearest_name.h"
#include "dataset/arrays.h"
#include "dataset/pooled.h"
#include "dataset/table/column_kinds.h"
#include "dataset/table/column_names.h"
#include "python/bindings.h"
#include "python/keyword_words.h"

namespace mixity {
namespace {

/// Keywords of arrays that are no columns are constants; InputError where one was meant to be a column, too.
void require_known(const Stated& constants) {
  std::vector<std::string> names = column_names();
  for (const MetadataField& field : metadata_fields()) names.emplace_back(field.name);
  for (const auto& [key, text] : constants)
    if (std::find(names.begin(), names.end(), key) == names.end()) throw InputError("arrays", unknown_key(key, names));
}

}  // namespace

std::vector<InputFile> inputs_of(const Contents& contents) {
  std::vector<InputFile> files;
  for (const auto& [path, bytes] : contents)
    files.push_back({path, 0, {}, std::make_shared<const std::string>(bytes.c_str(), bytes.size())});
  return files;
}

Dataset load_files(const std::vector<std::string>& paths, const Stated& constants, Inputs& inputs) {
  if (paths.size() == 1) return load_dataset(paths[0], constants, inputs);
  std::vector<RunFile> files;
  for (const std::string& path : paths) files.push_back({path});
  return load_pooled(files, constants, inputs);
}

void bind_data(nb::module_& m) {
  nb::class_<Dataset>(m, "Dataset")
      .def_ro("name", &Dataset::name)
      .def_prop_ro("notes",
                   [](const Dataset& d) {
                     std::vector<std::string> notes;
                     for (const Message& note : d.notes) notes.push_back(note.text(in_keywords));
                     return notes;
                   })
      .def_ro("curves", &Dataset::curves)
      .def_ro("has_loads", &Dataset::has_loads)
      .def_prop_ro("inputs",
                   [](const Dataset& d) {
                     std::vector<std::tuple<std::string, std::size_t, std::string>> all;
                     for (const InputFile& one : d.inputs) all.emplace_back(one.path, one.bytes, one.hash);
                     return all;
                   })
      .def("contents",
           [](const Dataset& d) {
             Contents all;
             for (const InputFile& one : d.inputs) {
               const std::string content = content_of(one);
               all.emplace_back(one.path, nb::bytes(content.data(), content.size()));
             }
             return all;
           })
      .def_prop_ro("force_unit_text", [](const Dataset& d) { return d.display.force; })
      .def_prop_ro("area_unit_text", [](const Dataset& d) { return d.display.area; })
      .def_prop_ro("force_scale", [](const Dataset& d) { return d.display.force_scale; })
      .def_prop_ro("area_scale", [](const Dataset& d) { return d.display.area_scale; })
      .def_prop_ro("force_unit", [](const Dataset& d) { return d.contact ? d.contact->force_unit() : 1.0; })
      .def_prop_ro("holds_approach", &Dataset::holds_approach)
      .def_prop_ro("approach_unit_text", [](const Dataset& d) { return d.display.approach; })
      .def_prop_ro(
          "held_unit",
          [](const Dataset& d) {
            return !d.contact ? 1.0 : d.holds_approach() ? d.contact->displacement_unit() : d.contact->force_unit();
          })
      .def_prop_ro("approach_scale", [](const Dataset& d) { return d.display.approach_scale; })
      .def_prop_ro("stiffness_unit", [](const Dataset& d) { return d.contact ? d.contact->stiffness_unit() : 1.0; })
      .def_prop_ro("displacement_unit",
                   [](const Dataset& d) { return d.contact ? d.contact->displacement_unit() : 1.0; })
      .def_prop_ro("excluded",
                   [](const Dataset& d) {
                     std::vector<std::pair<std::size_t, std::string>> all;
                     for (const Excluded& one : d.excluded) all.emplace_back(d.line_in_file(one.line), one.reason);
                     return all;
                   })
      .def("column",
           [](const Dataset& d, const std::string& name) {
             std::vector<double> values;
             for (std::size_t i = 0; i < d.points.size(); ++i) {
               const Point& point = d.points[i];
               const auto toughness = name == "psi" || name == "f" ? d.toughness(i) : std::nullopt;
               const double load = !d.holds_approach()      ? point.P
                                   : d.loads_beside.empty() ? std::nan("")
                                                            : d.loads_beside[i].q;
               values.push_back(name == "P"       ? load
                                : name == "delta" ? (d.holds_approach() ? point.P : std::nan(""))
                                : name == "T"     ? point.T
                                : name == "A"     ? point.A
                                : name == "line"  ? static_cast<double>(point.line)
                                : name == "curve" ? static_cast<double>(point.curve)
                                : !toughness      ? std::nan("")
                                : name == "psi"   ? phase_angle(toughness->mixity)
                                                  : toughness->ratio);
             }
             return numpy_of(std::move(values));
           })
      .def("__len__", [](const Dataset& d) { return d.points.size(); });
  // contents: files read before, by path; null: files are read from disk, except those of `made`, which are texts made
  // of other files
  m.def(
      "read",
      [](const std::vector<std::string>& paths, const Stated& constants, const std::optional<Contents>& contents,
         const Contents& made) {
        Inputs inputs(inputs_of(contents ? *contents : made),
                      contents ? Inputs::Others::none : Inputs::Others::from_disk);
        const Released released;
        return load_files(paths, constants, inputs);
      },
      nb::arg(), nb::arg(), nb::arg().none() = nb::none(), nb::arg() = Contents());
  m.def("columns_stated", [](const std::string& path, const Stated& constants) {
    Inputs inputs;
    Metadata metadata = metadata_of(path, constants, inputs);
    apply_overrides(constants, metadata);
    return metadata.columns;
  });
  m.def("files_of", &files_of);
  m.def("constants_of_definition", [](const std::string& path) {
    Inputs inputs;
    return constants_as_stated(with_definition({}, {{"definition", path}}, inputs));
  });
  m.def("column_names", &column_names);
  m.def("did_you_mean", [](const std::string& given, const std::vector<std::string>& names) {
    return did_you_mean(given, names);  // empty without a near name
  });
  m.def("si_units", [] {  // units of columns and constants
    std::map<std::string_view, std::string_view> units;
    for (const ColumnKind& kind : kColumnKinds) units[kind.name] = si_unit(kind.dimension);
    for (const MetadataField& field : metadata_fields()) units[field.name] = si_unit(field.dimension);
    std::erase_if(units, [](const auto& one) { return one.second.empty(); });
    return units;
  });
  m.def("named_columns", [](const std::string& name, const std::vector<std::string>& texts, bool load_stated) {
    std::vector<Heading> headings;
    for (const std::string& text : texts) headings.push_back(split_heading(text, {1, headings.size() + 1}));
    ColumnRules rules;
    rules.load_stated = load_stated;
    std::vector<std::tuple<std::string, std::size_t, std::optional<std::string>>> columns;
    for (const NamedColumn& one : name_columns(name, headings, rules))
      columns.emplace_back(to_string(one.id), one.index, one.heading.unit);
    return columns;
  });
  m.def("contact_units", [](double radius, double modulus, double toughness) {
    const Contact contact{radius, modulus, toughness};
    return std::tuple(contact.force_unit(), contact.area_unit(), contact.displacement_unit(), contact.stress_unit());
  });
  m.def("unit_in_heading", [](const std::string& text) { return split_heading(text, {}).unit; });
  m.def("same_unit", [](const std::string& one, const std::string& other) {
    const auto a = parse_unit(one), b = parse_unit(other);
    return a && b && a->factor == b->factor && a->dimension == b->dimension;
  });
  m.def("size_of_unit", [](const std::string& name, const std::string& unit, const std::string& si) {
    const auto of = parse_unit(unit), wanted = parse_unit(si);
    const Dimension dimension = wanted ? wanted->dimension : dimension::none;
    if (!of || of->dimension != dimension)
      throw InputError(name, "is in '" + unit + "'; it must be in " + (si.empty() ? "no unit" : si));
    return of->factor;
  });
  m.def("held_values", [](const std::string& name, const std::string& text, bool approach) {
    const std::string examples =
        approach ? "approaches with a unit, such as \"3,8 um\"" : "loads with a unit, such as \"1,4 mN\"";
    const InputError wrong(name, "is '" + text + "'; it must be " + examples);
    std::vector<Quantity> all;
    for (const std::string_view one : split(text)) {
      const auto quantity = parse_quantity(one);
      if (!quantity) throw wrong;
      all.push_back(*quantity);
    }
    std::vector<double> loads;
    for (Quantity& one : all) {
      if (one.unit.text.empty()) one.unit = all.back().unit;
      if (one.unit.dimension != (approach ? dimension::length : dimension::force)) throw wrong;
      loads.push_back(one.si());
    }
    return loads;
  });
  m.def("from_arrays", [](const std::string& name, const std::vector<std::pair<std::string, nb::object>>& columns,
                          const Stated& constants) {
    require_known(constants);
    std::vector<Numbers> numbers;
    std::vector<std::vector<std::string>> texts;
    numbers.reserve(columns.size());
    texts.reserve(columns.size());
    std::vector<ArrayColumn> all;
    for (const auto& [heading, values] : columns) {
      ArrayColumn& column = all.emplace_back(ArrayColumn{heading});
      if (Numbers read; nb::try_cast(values, read)) {
        numbers.push_back(read);
        column.numbers = {numbers.back().data(), numbers.back().size()};
      } else {
        column.texts = texts.emplace_back(nb::cast<std::vector<std::string>>(values));
      }
    }
    const Released released;
    return make_dataset(name, all, constants);
  });
}

}  // namespace mixity
