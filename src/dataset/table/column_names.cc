#include "dataset/table/column_names.h"

#include <algorithm>

#include "base/input_error.h"
#include "base/text.h"
#include "dataset/table/vocabulary.h"

namespace mixity {
namespace {

std::string name_of(ColumnId id) { return std::string(to_string(id)); }

/// "Kanal 3 (mN)" names a heading with or without its unit, "3" the third.
NamedColumn mapped_column(const std::string& path, const std::vector<Heading>& headings, ColumnId id,
                          const std::string& wanted) {
  const Heading said = split_heading(wanted, {});
  std::optional<std::size_t> found;
  const auto find = [&](const auto& is_it) {
    for (std::size_t i = 0; i < headings.size(); ++i) {
      if (!is_it(headings[i])) continue;
      if (found)
        throw InputError(path, headings[i].place,
                         "columns " + std::to_string(*found + 1) + " and " + std::to_string(i + 1) + " are both '" +
                             wanted + "', which is to be " + name_of(id) + "; say which by its number: " +
                             Remedy::set("columns", name_of(id) + "=" + std::to_string(i + 1)));
      found = i;
    }
  };
  find([&](const Heading& heading) { return trim_name(heading.text) == said.text; });
  if (const std::string name = folded(said.name); !found && !name.empty())
    find([&](const Heading& heading) { return folded(heading.name) == name; });
  const auto number = parse_number(said.name);
  if (!found && number && *number >= 1 && *number <= static_cast<double>(headings.size()) &&
      *number == static_cast<double>(static_cast<std::size_t>(*number)))
    found = static_cast<std::size_t>(*number) - 1;
  const FilePlace line{headings.empty() ? 1 : headings.front().place.line, 1};
  if (!found) {
    std::string names;
    for (const Heading& heading : headings)
      if (!heading.text.empty()) names += (names.empty() ? "'" : ", '") + printable(heading.text, 40) + "'";
    throw InputError(path, line,
                     "no column '" + wanted + "', which is to be " + name_of(id) + "; there are " +
                         (names.empty() ? "none with a name" : names));
  }
  NamedColumn column{id, *found, headings[*found]};
  if (said.unit) {
    const auto stated = column.heading.unit ? parse_unit(*column.heading.unit) : std::nullopt,
               meant = parse_unit(*said.unit);
    if (stated && meant && (stated->factor != meant->factor || stated->dimension != meant->dimension))
      throw InputError(
          path, column.heading.place,
          "column '" + column.heading.text + "' is in " + stated->text + ", the mapping says " + meant->text);
    column.heading.unit = said.unit;
    column.heading.closed = said.closed;
  }
  return column;
}

/// The columns that have been named so far.
class Names {
 public:
  Names(const std::string& path, const std::vector<Heading>& headings, const ColumnRules& rules)
      : path_(path), headings_(headings), rules_(rules) {}

  void add_mapped() {
    for (const auto& [name, heading] : rules_.mapping) {
      NamedColumn column = mapped_column(path_, headings_, *column_named(name), heading);
      if (const NamedColumn* other = at(column.index))
        throw InputError(
            path_, column.heading.place,
            "column " + std::to_string(column.index + 1) + " is mapped to " + name + " and to " + name_of(other->id));
      columns_.push_back(std::move(column));
    }
  }

  /// Of the program's own names those whose unit fits.
  void add_own_names() {
    for (std::size_t i = 0; i < headings_.size(); ++i) {
      const auto id = column_named(headings_[i].name);
      if (!id || at(i) || !is_read(*id) || is_mapped(*id) || (rules_.vocabulary && !unit_fits(headings_[i].unit, *id)))
        continue;
      if (const NamedColumn* before = find(*id))
        throw InputError(
            path_, headings_[i].place,
            "column '" + headings_[i].name + "' stands twice" +
                (rules_.vocabulary
                     ? ", in columns " + std::to_string(before->index + 1) + " and " + std::to_string(i + 1) + "; " +
                           Remedy::set("columns", headings_[i].name + "=" + std::to_string(i + 1)) +
                           " says which; runs beside each other are to stand below each other"
                     : Message()));
      columns_.push_back({*id, i, headings_[i]});
    }
  }

  void add_by_vocabulary(const Vocabulary& vocabulary) {
    for (std::size_t i = 0; i < headings_.size(); ++i) {
      if (at(i) || column_named(headings_[i].name)) continue;  // of the latter the unit does not fit
      auto column = read_heading(headings_[i], i, vocabulary);
      if (!column || !is_read(column->id)) continue;
      const NamedColumn* before = find(column->id);
      if (!before)
        columns_.push_back(std::move(*column));
      else if (!is_mapped(column->id) && !column_named(headings_[before->index].name))
        throw InputError(path_, headings_[i].place,
                         "'" + before->heading.text + "' and '" + headings_[i].text + "' may both be " +
                             name_of(column->id) + "; say which: " + mapping(column->id, headings_, before->index) +
                             " or " + mapping(column->id, headings_, i));
    }
    // "normal force_N" may be a symbol's index; beside headings that end with units it ends with one
    if (std::any_of(columns_.begin(), columns_.end(), [](const NamedColumn& column) { return column.heading.unit; }))
      for (NamedColumn& column : columns_)
        if (!column.heading.unit && !is_mapped(column.id))
          if (auto better = read_heading(headings_[column.index], column.index, vocabulary, true);
              better && better->id == column.id)
            column = std::move(*better);
    if (!is_complete() && (!rules_.log || find(ColumnId::P) || find(ColumnId::T))) refuse_unit(vocabulary);
  }

  /// Own names whose unit does not fit, where nothing else has that name: whoever reads the column refuses the unit.
  void add_misfits() {
    for (std::size_t i = 0; i < headings_.size(); ++i)
      if (const auto id = column_named(headings_[i].name); id && is_read(*id) && !find(*id) && !at(i))
        columns_.push_back({*id, i, headings_[i]});
  }

  /// Whether points can be made of these.
  bool is_complete() const {
    using enum ColumnId;
    const bool loads = find(T) && (find(P) || rules_.load_stated) && is_sized();
    if (rules_.log) return loads && find(ColumnId::time);  // a log of forces or of areas alone never is
    return loads || ((find(psi) || find(mode_ratio)) && (find(Gc) || find(Gc_over_GIc))) || (find(G_I) && find(G_II));
  }

  /// An export may hold areas with the radii or axes that they were made of, or the other way round: one of them goes.
  void drop_redundant_sizes() {
    using enum ColumnId;
    const auto drop = [&](ColumnId id) {
      if (!is_mapped(id)) std::erase_if(columns_, [&](const NamedColumn& column) { return column.id == id; });
    };
    const auto has_unit = [&](ColumnId id) { return find(id) && find(id)->heading.unit; };
    const auto is_called_a = [](const Heading& heading) { return column_named(heading.name) == ColumnId::a; };
    if (find(A) && is_mapped(ColumnId::a))
      drop(A);
    else if (find(A) && std::none_of(headings_.begin(), headings_.end(), is_called_a))
      drop(ColumnId::a);
    // axes without a unit beside an area with one add nothing that is needed
    const auto axes = {a_par, a_perp, major, minor};
    if (has_unit(A) && std::any_of(axes.begin(), axes.end(), [&](ColumnId id) { return find(id) && !has_unit(id); }))
      for (const ColumnId axis : axes) drop(axis);
  }

  std::vector<NamedColumn> sorted() && {
    std::sort(columns_.begin(), columns_.end(),
              [](const auto& one, const auto& other) { return one.index < other.index; });
    return std::move(columns_);
  }

 private:
  const NamedColumn* find(ColumnId id) const {
    const auto found =
        std::find_if(columns_.begin(), columns_.end(), [&](const NamedColumn& column) { return column.id == id; });
    return found == columns_.end() ? nullptr : &*found;
  }
  const NamedColumn* at(std::size_t index) const {
    const auto found = std::find_if(columns_.begin(), columns_.end(),
                                    [&](const NamedColumn& column) { return column.index == index; });
    return found == columns_.end() ? nullptr : &*found;
  }
  bool is_mapped(ColumnId id) const { return rules_.mapping.contains(name_of(id)); }
  bool is_read(ColumnId id) const { return rules_.log || id != ColumnId::time; }
  bool is_sized() const {
    using enum ColumnId;
    return find(A) || find(ColumnId::a) || (find(a_par) && find(a_perp)) || (find(major) && find(minor));
  }

  /// Throws for a heading that has the name of a quantity that is still needed, and a unit that is not known or does
  /// not fit.
  void refuse_unit(const Vocabulary& vocabulary) const {
    for (std::size_t i = 0; i < headings_.size(); ++i) {
      const Heading& heading = headings_[i];
      const auto id = vocabulary.find(heading.name);
      if (!id || unit_fits(heading.unit, *id) || find(*id)) continue;
      if (*id == ColumnId::T || (*id == ColumnId::P && !rules_.load_stated) || (*id == ColumnId::A && !is_sized()))
        throw InputError(path_, heading.place,
                         "'" + printable(heading.text, 60) + "' may be " + name_of(*id) + ", but '" + *heading.unit +
                             "' is not " + describe(kind_of(*id).dimension) +
                             "; if it is another way to write one: " + mapping(*id, headings_, i));
    }
  }

  const std::string& path_;
  const std::vector<Heading>& headings_;
  const ColumnRules& rules_;
  std::vector<NamedColumn> columns_;
};

}  // namespace

Remedy mapping(ColumnId id, const std::vector<Heading>& headings, std::size_t index) {
  constexpr std::size_t kLong = 40;
  const Heading& heading = headings[index];
  const bool alone = std::count_if(headings.begin(), headings.end(), [&](const Heading& other) {
                       return other.text == heading.text || folded(other.name) == folded(heading.name);
                     }) == 1;
  const bool plain = alone && heading.closed && !heading.name.empty() && heading.text.size() <= kLong &&
                     heading.text.find_first_of("\",=") == std::string::npos && printable(heading.text) == heading.text;
  const bool known = !heading.unit || unit_fits(heading.unit, id);
  std::string said = plain && known ? heading.text : plain ? heading.name : std::to_string(index + 1);
  if (!known) said += " (UNIT)";
  return Remedy::set("columns", name_of(id) + "=" + said);
}

std::vector<NamedColumn> name_columns(const std::string& path, const std::vector<Heading>& headings,
                                      const ColumnRules& rules) {
  Names names(path, headings, rules);
  names.add_mapped();
  names.add_own_names();
  if (rules.vocabulary && !names.is_complete()) {
    if (rules.headings.empty())
      names.add_by_vocabulary(Vocabulary::shipped());
    else
      names.add_by_vocabulary(Vocabulary::with(rules.headings));
  }
  if (rules.vocabulary) names.add_misfits();
  names.drop_redundant_sizes();
  return std::move(names).sorted();
}

std::vector<NamedColumn> number_columns(const std::string& path, const std::vector<Heading>& headings,
                                        const ColumnRules& rules) {
  try {
    std::vector<NamedColumn> columns = name_columns(path, headings, rules);
    std::erase_if(columns, [](const NamedColumn& column) { return column.id == ColumnId::curve; });
    return columns;
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace mixity
